#include "tristim/frame/io/write.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#include "tests/frame/frames.h"
#include "tests/support.h"

namespace tristim {
namespace {

TEST(OpenCodeSink, ChoosesTheFormatByExtension) {
  const TemporaryDirectory directory;
  const TestFrame frame = random_frame(frame_info("gray8", 5, 4));
  const std::pair<const char*, const char*> begins[] = {
      {"a.png", "\x89PNG"}, {"a.PNG", "\x89PNG"}, {"a.pgm", "P5\n"},
      {"a.pnm", "P5\n"},    {"a.h", "#pragma"},   {"a.hpp", "#pragma"},
  };
  for (const auto& [name, begin] : begins) {
    SCOPED_TRACE(name);
    FrameWriteOptions options;
    options.replace = true;
    write_frame(frame, directory.file(name), options);
    EXPECT_EQ(read_bytes(directory.file(name)).substr(0, std::string(begin).size()), begin);
  }
  write_frame(frame, directory.file("a.bin"));
  EXPECT_EQ(read_bytes(directory.file("a.bin")).size(), 20u);
}

TEST(OpenCodeSink, ChoosesTheFormatByNameBeforeExtension) {
  const TemporaryDirectory directory;
  FrameWriteOptions options;
  options.format = "RAW";
  write_frame(random_frame(frame_info("gray8", 5, 4)), directory.file("a.png"), options);
  EXPECT_EQ(read_bytes(directory.file("a.png")).size(), 20u);
}

TEST(OpenCodeSink, OpensEveryFormatOfTheList) {
  const TemporaryDirectory directory;
  for (const FrameFormat& format : kFrameFormats) {
    SCOPED_TRACE(format.name);
    FrameWriteOptions options;
    options.format = format.name;
    const std::string path = directory.file(std::string(format.name));
    write_frame(random_frame(frame_info("gray8", 5, 4)), path, options);
    EXPECT_GE(read_bytes(path).size(), 20u);
  }
}

TEST(OpenCodeSink, TellsTheFormatsThereAre) {
  const FrameInfo info = frame_info("gray8", 5, 4);
  EXPECT_EQ(
      open_error(info, "a.jpg"),
      "2 a.jpg: unknown extension 'jpg'; use one of: png gif bmp dib tif tiff pnm pbm pgm ppm raw "
      "bin h hpp c inc");
  EXPECT_EQ(open_error(info, "a"),
            "2 a: has no extension that tells the format; use one of: png gif bmp dib tif tiff "
            "pnm pbm pgm ppm raw bin h hpp c inc");
  EXPECT_EQ(open_error(info, "-"),
            "2 standard output: has no extension that tells the format; name one of: png, gif, "
            "bmp, tiff, pnm, raw, c");
  FrameWriteOptions options;
  options.format = "pnmm";
  EXPECT_EQ(open_error(info, "a", options), "2 format: unknown name 'pnmm'; did you mean pnm?");
}

TEST(OpenCodeSink, RejectsWhatIsNoFrame) {
  const auto open = [](const FrameInfo& info) { open_code_sink("never/made.h", info); };
  EXPECT_THROW(open(frame_info("gray8", 0, 4)), std::invalid_argument);
  EXPECT_THROW(open(frame_info("gray8", 4, 0)), std::invalid_argument);
  FrameInfo info = frame_info("rgb565", 4, 4);
  info.palette = test_palette(2, 8);
  EXPECT_THROW(open(info), std::invalid_argument);
  info.palette.clear();
  info.gamma = 0;
  EXPECT_THROW(open(info), std::invalid_argument);
  info.gamma.reset();
  info.frames = 0;
  EXPECT_THROW(open(info), std::invalid_argument);
}

TEST(CodeSink, LeavesNothingWithoutFinish) {
  const TemporaryDirectory directory;
  for (const FrameFormat& format : kFrameFormats) {
    const TestFrame frame = random_frame(frame_info("gray8", 300, 400));
    FrameWriteOptions options;
    options.format = format.name;
    open_code_sink(directory.file("out"), frame.info, options)->write(frame.view());
    EXPECT_TRUE(std::filesystem::is_empty(directory.path())) << format.name;
  }
}

TEST(CodeSink, RejectsRowsAndCodesThatAreNotOfTheFrame) {
  const TemporaryDirectory directory;
  for (const FrameFormat& format : kFrameFormats) {
    SCOPED_TRACE(format.name);
    FrameWriteOptions options;
    options.format = format.name;
    if (format.name == "gif") continue;  // holds no RGB
    const TestFrame frame = random_frame(frame_info("rgb565", 4, 3));
    const auto sink = open_code_sink(directory.file("out"), frame.info, options);
    ImageView<const std::uint16_t> view = frame.view();
    view.width = 3;
    EXPECT_THROW(sink->write(view), std::invalid_argument);
    view = frame.view();
    view.channels = 1;
    EXPECT_THROW(sink->write(view), std::invalid_argument);
    TestFrame wrong = frame;
    wrong.codes[4] = 64;
    EXPECT_THROW(sink->write(wrong.view()), std::invalid_argument);
  }
  const TestFrame frame = random_frame(frame_info("gray8", 4, 3));
  const auto sink = open_code_sink(directory.file("out.png"), frame.info);
  sink->write(frame.view().rows(0, 2));
  EXPECT_THROW(sink->finish(), std::logic_error);
  EXPECT_THROW(sink->write(frame.view().rows(0, 2)), std::invalid_argument);
  FrameInfo info = frame_info("index4", 4, 3);
  info.palette = test_palette(7, 4);
  TestFrame beyond = random_frame(info);
  beyond.codes[5] = 7;
  EXPECT_THROW(open_code_sink(directory.file("out.raw"), info)->write(beyond.view()),
               std::invalid_argument);
}

TEST(CodeSink, TellsAFullDisk) {
  for (const FrameFormat& format : kFrameFormats) {
    SCOPED_TRACE(format.name);
    FrameWriteOptions options;
    options.format = format.name;
    std::string text;
    try {
      write_frame(random_frame(frame_info("gray8", 2000, 1500)), "/dev/full", options, 100);
    } catch (const Error& error) {
      text = error.what();
    }
    EXPECT_EQ(text,
              "/dev/full: cannot write: no space left on device; free some space or write "
              "elsewhere");
  }
}

}  // namespace
}  // namespace tristim
