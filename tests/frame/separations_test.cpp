#include "tristim/frame/io/separations.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/error_text.h"
#include "tests/frame/frames.h"
#include "tests/support.h"

namespace tristim {
namespace {

const std::vector<std::string> kInks{"cyan", "magenta", "black"};

FrameInfo sheet(int width, int height) {
  FrameInfo info = frame_info("index4", width, height);
  for (int i = 0; i < 8; ++i) {
    const auto grey = static_cast<std::uint8_t>(255 - 20 * i);
    info.palette.push_back({{grey, grey, grey}, static_cast<std::uint16_t>(i), ""});
  }
  return info;
}

void write_sheet(const TestFrame& frame, const std::string& path,
                 const FrameWriteOptions& options = {}) {
  const auto sink = open_separations(path, frame.info, kInks, options);
  sink->write(frame.view());
  sink->finish();
}

TEST(Separations, AreNamedByInk) {
  EXPECT_EQ(separation_paths("a.b/page.tif", kInks),
            (std::vector<std::string>{"a.b/page.cyan.tif", "a.b/page.magenta.tif",
                                      "a.b/page.black.tif"}));
}

TEST(Separations, AreWhatPrintersTake) {
  EXPECT_TRUE(is_separated("a.tif"));
  EXPECT_TRUE(is_separated("a.TIFF"));
  EXPECT_TRUE(is_separated("a.pbm"));
  EXPECT_FALSE(is_separated("a.png"));
  EXPECT_FALSE(is_separated("a.tif", {.format = "png"}));
  EXPECT_TRUE(is_separated("a.png", {.format = "tiff"}));
  EXPECT_FALSE(is_separated("a.unknown"));
}

TEST(Separations, HoldTheBitOfTheirInk) {
  const TemporaryDirectory directory;
  TestFrame frame{sheet(3, 1), {0, 5, 6}};
  write_sheet(frame, directory.file("p.pbm"));
  const std::string head = "P4\n3 1\n";
  EXPECT_EQ(read_bytes(directory.file("p.cyan.pbm")), head + '\x40');
  EXPECT_EQ(read_bytes(directory.file("p.magenta.pbm")), head + '\x20');
  EXPECT_EQ(read_bytes(directory.file("p.black.pbm")), head + '\x60');
  EXPECT_FALSE(std::filesystem::exists(directory.file("p.pbm")));
}

TEST(Separations, AreAllThereOrNone) {
  const TemporaryDirectory directory;
  const TestFrame frame = random_frame(sheet(40, 30));
  write_bytes(directory.file("p.black.tif"), "mine");
  EXPECT_NE(error_text([&] { write_sheet(frame, directory.file("p.tif")); }), "");
  EXPECT_FALSE(std::filesystem::exists(directory.file("p.cyan.tif")));
  EXPECT_FALSE(std::filesystem::exists(directory.file("p.magenta.tif")));
  EXPECT_EQ(read_bytes(directory.file("p.black.tif")), "mine");

  // The last file comes into being while the others are written.
  const auto sink = open_separations(directory.file("q.tif"), frame.info, kInks);
  sink->write(frame.view());
  write_bytes(directory.file("q.black.tif"), "mine");
  EXPECT_NE(error_text([&] { sink->finish(); }), "");
  EXPECT_FALSE(std::filesystem::exists(directory.file("q.cyan.tif")));
  EXPECT_FALSE(std::filesystem::exists(directory.file("q.magenta.tif")));
  EXPECT_EQ(read_bytes(directory.file("q.black.tif")), "mine");
}

TEST(Separations, DoNotGoToAStream) {
  EXPECT_EQ(error_text([] { open_separations("-", sheet(2, 2), kInks, {.format = "tiff"}); }),
            "2 standard output: cannot take a file for each of 3 inks; give a name, such as -o "
            "page.tif, or --format png for all inks in one");
}

}  // namespace
}  // namespace tristim
