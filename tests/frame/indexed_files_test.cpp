#include <gtest/gtest.h>

#include <cmath>

#include "tests/error_text.h"
#include "tests/frame/frames.h"
#include "tests/support.h"
#include "tristim/color/transfer.h"
#include "tristim/image/io/indexed.h"
#include "tristim/image/io/read.h"

namespace tristim {
namespace {

constexpr const char* kIndexedFormats[] = {"png", "gif", "bmp", "tiff"};

std::vector<std::uint16_t> positions_of(const IndexedPicture& picture) {
  std::vector<std::uint16_t> positions;
  const auto view = picture.positions.view();
  for (int y = 0; y < view.height; ++y) {
    for (const std::uint8_t position : view.row(y)) positions.push_back(position);
  }
  return positions;
}

IndexedPicture written(const TestFrame& frame, const std::string& format) {
  const TemporaryDirectory directory;
  write_frame(frame, directory.file("out"), {.format = format});
  auto picture = read_indexed_picture(directory.file("out"));
  EXPECT_TRUE(picture);
  return picture ? std::move(*picture) : IndexedPicture{};
}

void expect_palette(const IndexedPicture& picture, const std::vector<PaletteEntry>& palette) {
  ASSERT_GE(picture.palette.size(), palette.size());  // some formats have powers of 2
  for (std::size_t i = 0; i < palette.size(); ++i) {
    const auto& srgb = palette[i].srgb;
    const auto& read = picture.palette[i];
    EXPECT_EQ((std::array{read[0], read[1], read[2]}), srgb) << "entry " << i;
  }
}

TEST(IndexedFiles, KeepThePaletteAndThePositions) {
  for (const std::string format : kIndexedFormats) {
    for (const int colours : {1, 2, 3, 5, 16, 17, 200, 256}) {
      SCOPED_TRACE(format + " with " + std::to_string(colours));
      FrameInfo info = frame_info(colours <= 16 ? "index4" : "index8", 37, 11);
      info.palette = test_palette(colours, info.layout.packing.bits[0]);
      const TestFrame frame = random_frame(info);
      const IndexedPicture picture = written(frame, format);
      expect_palette(picture, info.palette);
      EXPECT_EQ(positions_of(picture), frame.codes);
      EXPECT_EQ(picture.pictures, 1);
    }
  }
}

TEST(IndexedFiles, KeepGreysAsAPalette) {
  for (const std::string format : {"gif", "bmp"}) {
    for (const char* packing : {"mono1", "gray2", "gray4", "gray8"}) {
      SCOPED_TRACE(format + " " + packing);
      const TestFrame frame = random_frame(frame_info(packing, 19, 9));
      const IndexedPicture picture = written(frame, format);
      EXPECT_EQ(positions_of(picture), frame.codes);
      const auto highest = (1u << frame.info.layout.packing.bits[0]) - 1;
      EXPECT_EQ(picture.palette[0], (std::array<std::uint8_t, 4>{0, 0, 0, 255}));
      EXPECT_EQ(picture.palette[highest], (std::array<std::uint8_t, 4>{255, 255, 255, 255}));
    }
  }
}

TEST(IndexedFiles, KeepAlpha) {
  FrameInfo info = frame_info("index4", 8, 8);
  info.palette = test_palette(6, 4);
  info.palette[1].alpha = 128;
  info.palette[3].alpha = 0;
  const TestFrame frame = random_frame(info);
  const IndexedPicture png = written(frame, "png");
  const IndexedPicture gif = written(frame, "gif");
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(png.palette[i][3], info.palette[i].alpha);
    EXPECT_EQ(gif.palette[i][3], i == 3 ? 0 : 255);
  }
  EXPECT_EQ(positions_of(gif), frame.codes);
}

TEST(IndexedFiles, GifMoves) {
  FrameInfo info = frame_info("index2", 7, 5);
  info.palette = test_palette(4, 2);
  info.frames = 3;
  info.delay_s = 0.25;
  const TemporaryDirectory directory;
  const auto sink = open_code_sink(directory.file("out.gif"), info);
  const TestFrame frame = random_frame(frame_info("index2", 7, 5));
  for (int i = 0; i < 3; ++i) sink->write(frame.view());
  sink->finish();
  const auto picture = read_indexed_picture(directory.file("out.gif"));
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->pictures, 3);
  EXPECT_EQ(positions_of(*picture), frame.codes);
  const std::string bytes = read_bytes(directory.file("out.gif"));
  EXPECT_NE(bytes.find("NETSCAPE2.0"), std::string::npos);
  EXPECT_NE(bytes.find(std::string("\x21\xf9\x04\x00\x19\x00", 6)), std::string::npos);  // 25/100 s
}

// Codes of RGB and grey packings as another reader sees them.
TEST(IndexedFiles, BmpAndTiffKeepCodes) {
  for (const std::string format : {"bmp", "tiff"}) {
    for (const Packing& packing : kPackings) {
      const bool deep = packing.bits[0] == 16;
      if (packing.indexed || (deep && format == "bmp")) continue;
      SCOPED_TRACE(format + " " + std::string(packing.name));
      const TestFrame frame = random_frame(frame_info(packing.name, 13, 5));
      const TemporaryDirectory directory;
      write_frame(frame, directory.file("out"), {.format = format});
      const auto source = open_picture(directory.file("out"));
      ASSERT_EQ(source->info().width, 13);
      ASSERT_EQ(source->info().height, 5);
      Image rows(13, 5, source->info().channels);
      source->read(rows.view());
      const int samples = packing.samples;
      for (std::size_t i = 0; i < frame.codes.size(); ++i) {
        const int pixel = static_cast<int>(i) / samples;
        const int channel = static_cast<int>(i) % samples;
        const double most = (1 << packing.bits[static_cast<std::size_t>(channel)]) - 1;
        const double wide = deep ? 65535 : 255;  // of the file, except for greys of few bits
        const double asked = frame.codes[i] / most;
        const float light = rows.view().pixel(pixel % 13, pixel / 13)[channel];
        EXPECT_NEAR(srgb_encode(light), std::round(asked * wide) / wide, 0.6 / wide) << i;
      }
    }
  }
}

TEST(IndexedFiles, TiffIsGroup4AtOneBit) {
  const TemporaryDirectory directory;
  write_frame(random_frame(frame_info("mono1", 64, 64)), directory.file("a.tif"));
  FrameInfo white_first = frame_info("index1", 64, 64);
  white_first.palette = {{{255, 255, 255}, 0, {}}, {{0, 0, 0}, 1, {}}};
  write_frame(random_frame(white_first), directory.file("b.tif"));
  const PictureFacts a = picture_facts(directory.file("a.tif"));
  const PictureFacts b = picture_facts(directory.file("b.tif"));
  EXPECT_EQ(a.compression, "ccittfax4");
  EXPECT_EQ(b.compression, "ccittfax4");
}

TEST(IndexedFiles, SayTheLimit) {
  const TemporaryDirectory directory;
  FrameInfo info = frame_info("gray16", 4, 4);
  info.palette = test_palette(300, 16);
  for (const auto& [file, name] :
       {std::pair{"o.gif", "GIF"}, {"o.bmp", "BMP"}, {"o.tif", "TIFF"}}) {
    const std::string path = directory.file(file);
    EXPECT_EQ(open_error(info, path), "2 " + path + ": a palette of 300 colours, but " + name +
                                          " holds at most 256; use fewer colours");
  }
  const std::string gif = directory.file("rgb.gif");
  EXPECT_EQ(open_error(frame_info("rgb888", 4, 4), gif),
            "2 " + gif +
                ": GIF holds a palette of at most 256 colours, codes of packing rgb888 are more; "
                "choose a palette (--palette), or write PNG or TIFF");
  FrameInfo moving = frame_info("gray8", 4, 4);
  moving.frames = 2;
  const std::string png = directory.file("m.png");
  EXPECT_EQ(open_error(moving, png), "2 " + png +
                                         ": png holds one picture, these are 2; write a moving "
                                         "picture as GIF");
  EXPECT_EQ(
      open_error(frame_info("rgb48", 4, 4), directory.file("d.bmp")),
      "2 " + directory.file("d.bmp") +
          ": BMP holds 8 bits a channel, codes of packing rgb48 have more; write PNG or TIFF");
}

// BMP files of other programs: runs of 8 bits, from the top, a palette of OS/2.
TEST(IndexedFiles, BmpOfOthers) {
  const TemporaryDirectory directory;
  const auto header = [](int size, int width, int height, int bits, int compression, int at) {
    std::string bytes = "BM" + std::string(8, '\0');
    const auto put = [&](long value, int count) {
      for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> 8 * i);
    };
    put(at, 4);
    put(size, 4);
    const int side = size == 12 ? 2 : 4;
    put(width, side);
    put(height, side);
    put(1, 2);
    put(bits, 2);
    if (size == 12) return bytes;
    put(compression, 4);
    bytes += std::string(12, '\0');
    put(2, 4);
    bytes += std::string(4, '\0');
    return bytes;
  };
  const std::string palette("\x01\x02\x03\x00\x04\x05\x06\x00", 8);
  const std::string runs("\x03\x01\x00\x00\x00\x03\x01\x00\x01\x00\x00\x01", 12);
  write_bytes(directory.file("runs"), header(40, 3, 2, 8, 1, 62) + palette + runs);
  const auto picture = read_indexed_picture(directory.file("runs"));
  ASSERT_TRUE(picture);
  EXPECT_EQ(positions_of(*picture), (std::vector<std::uint16_t>{1, 0, 1, 1, 1, 1}));
  EXPECT_EQ(picture->palette[1], (std::array<std::uint8_t, 4>{6, 5, 4, 255}));

  const std::string old_palette("\x01\x02\x03\x04\x05\x06", 6);
  const std::string rows("\x80\0\0\0\x40\0\0\0", 8);
  write_bytes(directory.file("old"), header(12, 2, 2, 1, 0, 32) + old_palette + rows);
  const auto old = read_indexed_picture(directory.file("old"));
  ASSERT_TRUE(old);
  EXPECT_EQ(positions_of(*old), (std::vector<std::uint16_t>{0, 1, 1, 0}));
  EXPECT_EQ(old->palette[0], (std::array<std::uint8_t, 4>{3, 2, 1, 255}));

  write_bytes(directory.file("top"), header(40, 2, -2, 1, 0, 62) + palette + rows);
  EXPECT_EQ(positions_of(read_indexed_picture(directory.file("top")).value()),
            (std::vector<std::uint16_t>{1, 0, 0, 1}));
}

TEST(IndexedFiles, NothingForColours) {
  const TemporaryDirectory directory;
  for (const std::string format : {"png", "bmp", "tiff", "pnm"}) {
    write_frame(random_frame(frame_info("rgb888", 4, 4)), directory.file(format),
                {.format = format});
    EXPECT_FALSE(read_indexed_picture(directory.file(format))) << format;
  }
}

// Every damaged file is an Error of its content or a picture; nothing else.
TEST(IndexedFiles, SurviveDamage) {
  const TemporaryDirectory directory;
  std::mt19937 generator(6);
  for (const std::string format : kIndexedFormats) {
    FrameInfo info = frame_info("index4", 24, 24);
    info.palette = test_palette(16, 4);
    write_frame(random_frame(info), directory.file(format), {.format = format});
    const std::string good = read_bytes(directory.file(format));
    int refused = 0;
    for (int i = 0; i < 300; ++i) {
      std::string bad = good;
      if (i % 3 == 0) bad.resize(generator() % bad.size());
      for (int k = 0; k < 4 && !bad.empty(); ++k) {
        bad[generator() % bad.size()] = static_cast<char>(generator());
      }
      write_bytes(directory.file("bad"), bad);
      try {
        (void)read_indexed_picture(directory.file("bad"));
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::kContent) << error.what();
        ++refused;
      }
    }
    EXPECT_GT(refused, 10) << format;
  }
}

}  // namespace
}  // namespace tristim
