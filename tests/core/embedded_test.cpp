#include "lib/core/embedded.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support.h"

namespace tristim::detail {
namespace {

struct Folder {
  std::string path;
  std::span<const EmbeddedFile> files;
};

std::vector<Folder> folders() {
  return {{"luts/devices", embedded_devices()}, {"luts/scenes", embedded_scenes()}};
}

TEST(EmbeddedFiles, AreTheFilesByteForByte) {
  for (const Folder& folder : folders()) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(source_file(folder.path))) {
      if (entry.path().extension() == ".toml") ++files;
    }
    EXPECT_EQ(folder.files.size(), files);
    for (const EmbeddedFile& file : folder.files) {
      SCOPED_TRACE(file.name);
      const std::string path = folder.path + "/" + std::string(file.name) + ".toml";
      EXPECT_EQ(file.text, read_bytes(source_file(path)));
    }
  }
}

TEST(EmbeddedFiles, AreSortedByName) {
  for (const Folder& folder : folders()) {
    for (std::size_t i = 1; i < folder.files.size(); ++i) {
      EXPECT_LT(folder.files[i - 1].name, folder.files[i].name);
    }
  }
}

}  // namespace
}  // namespace tristim::detail
