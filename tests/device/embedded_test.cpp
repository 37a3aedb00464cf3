#include "lib/device/embedded.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support.h"

namespace tristim::detail {
namespace {

TEST(EmbeddedDevices, AreTheFilesByteForByte) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source_file("luts/devices"))) {
    if (entry.path().extension() == ".toml") ++files;
  }
  EXPECT_EQ(embedded_devices().size(), files);
  for (const EmbeddedFile& file : embedded_devices()) {
    SCOPED_TRACE(file.name);
    const std::string path = "luts/devices/" + std::string(file.name) + ".toml";
    EXPECT_EQ(file.text, read_bytes(source_file(path)));
  }
}

TEST(EmbeddedDevices, AreSortedByName) {
  const auto devices = embedded_devices();
  for (std::size_t i = 1; i < devices.size(); ++i) {
    EXPECT_LT(devices[i - 1].name, devices[i].name);
  }
}

}  // namespace
}  // namespace tristim::detail
