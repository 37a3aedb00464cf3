#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "tests/image/exr_fixture.h"
#include "tests/image/picture_support.h"
#include "tests/support.h"

namespace tristim {
namespace {

constexpr unsigned kSeconds = 5;
constexpr long kMostKilobytes = 512 << 10;

struct Outcome {
  int exit_code = 0;  // the Error's kind, 0: read to the end, -1: killed, 99: another exception
  long peak_kilobytes = 0;
};

// Reads a file to its end in a process of its own, on one thread: others do not survive a fork.
Outcome read_apart(const std::string& path) {
  const pid_t child = fork();
  if (child == 0) {
    alarm(kSeconds);
    int code = 0;
    try {
      const auto rows = open_picture(path, {.threads = 1});
      const PictureInfo& info = rows->info();
      Image band(info.width, 13, info.channels);
      for (int y = 0; y < info.height; y += 13) {
        rows->read(band.view().rows(0, std::min(13, info.height - y)));
      }
    } catch (const Error& error) {
      code = static_cast<int>(error.kind());
    } catch (...) {
      code = 99;
    }
    _exit(code);
  }
  int status = 0;
  rusage usage = {};
  wait4(child, &status, 0, &usage);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, usage.ru_maxrss};
}

void expect_orderly_end(const std::string& path) {
  const Outcome outcome = read_apart(path);
  EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 3)
      << path << ": " << outcome.exit_code;
  EXPECT_LT(outcome.peak_kilobytes, kMostKilobytes) << path;
}

std::vector<std::string> fixtures(const TemporaryDirectory& directory) {
  std::vector<std::string> paths;
  const auto add = [&](const std::string& name, const Imf::Header& header) {
    paths.push_back(directory.file(name));
    fixture::write_exr(paths.back(), header);
  };
  for (const Imf::Compression compression :
       {Imf::RLE_COMPRESSION, Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION, Imf::PXR24_COMPRESSION,
        Imf::B44_COMPRESSION, Imf::DWAA_COMPRESSION}) {
    Imf::Header header = fixture::header(60, 50, {"R", "G", "B"});
    header.compression() = compression;
    add("rows" + std::to_string(compression), header);
    header.setTileDescription(Imf::TileDescription(16, 16));
    add("tiles" + std::to_string(compression), header);
  }
  Imf::Header chroma = fixture::header(60, 50, {"Y"});
  chroma.channels().insert("RY", Imf::Channel(Imf::HALF, 2, 2));
  chroma.channels().insert("BY", Imf::Channel(Imf::HALF, 2, 2));
  add("chroma", chroma);
  return paths;
}

TEST(Damaged, EveryKnownBadFileEndsInOrder) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(*shared / "images" / "damaged")) {
    expect_orderly_end(entry.path().string());
    ++count;
  }
  EXPECT_GT(count, 90);
}

TEST(Damaged, FlippedAndCutFilesEndInOrder) {
  const TemporaryDirectory directory;
  std::mt19937 random(1);
  for (const std::string& path : fixtures(directory)) {
    ASSERT_EQ(read_apart(path).exit_code, 0) << path;
    const std::string good = read_bytes(path);
    for (int trial = 0; trial < 12; ++trial) {
      std::string bad = good;
      if (trial % 4 == 0) bad.resize(random() % bad.size());
      const std::size_t reach =
          trial % 2 == 0 ? bad.size() : std::min<std::size_t>(bad.size(), 400);
      for (int flips = 0; flips < 3 && reach > 0; ++flips) {
        bad[random() % reach] = static_cast<char>(random());
      }
      const std::string bad_path = directory.file("bad");
      write_bytes(bad_path, bad);
      SCOPED_TRACE(path + ", trial " + std::to_string(trial));
      expect_orderly_end(bad_path);
    }
  }
}

}  // namespace
}  // namespace tristim
