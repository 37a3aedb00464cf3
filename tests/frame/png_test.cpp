#include <gtest/gtest.h>
#include <png.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>

#include "tests/frame/frames.h"
#include "tests/support.h"

namespace tristim {
namespace {

/// A PNG as libpng reads it, samples as stored.
struct Png {
  int colour_type = 0;
  int depth = 0;
  int width = 0, height = 0;
  std::vector<std::uint16_t> samples;
  std::vector<std::array<int, 3>> palette;
  std::array<int, 4> significant{};  // red green blue grey; 0: no sBIT
  bool srgb = false;
  double gamma = 0;  // of the chunk; 0: none
  std::optional<Primaries> primaries;
  std::uint32_t dots_per_metre = 0;
  std::map<std::string, std::string> text;
};

struct PngReader {
  std::FILE* file;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  explicit PngReader(const std::string& path) : file(std::fopen(path.c_str(), "rb")) {}
  ~PngReader() {
    png_destroy_read_struct(&png, &info, nullptr);
    std::fclose(file);
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
};

void read_chunks(PngReader& in, Png& result) {
  png_colorp colours = nullptr;
  int count = 0;
  if (png_get_PLTE(in.png, in.info, &colours, &count) != 0) {
    for (int i = 0; i < count; ++i) {
      result.palette.push_back({colours[i].red, colours[i].green, colours[i].blue});
    }
  }
  png_color_8p bits = nullptr;
  if (png_get_sBIT(in.png, in.info, &bits) != 0) {
    result.significant = {bits->red, bits->green, bits->blue, bits->gray};
  }
  int intent = 0;
  result.srgb = png_get_sRGB(in.png, in.info, &intent) != 0;
  png_get_gAMA(in.png, in.info, &result.gamma);
  Primaries p;
  if (png_get_cHRM(in.png, in.info, &p.white.x, &p.white.y, &p.red.x, &p.red.y, &p.green.x,
                   &p.green.y, &p.blue.x, &p.blue.y) != 0) {
    result.primaries = p;
  }
  result.dots_per_metre = png_get_pixels_per_meter(in.png, in.info);
  png_textp text = nullptr;
  const int texts = png_get_text(in.png, in.info, &text, nullptr);
  for (int i = 0; i < texts; ++i) result.text[text[i].key] = text[i].text;
}

/// Errors of libpng end the test program: it prints and aborts.
Png read_png(const std::string& path) {
  PngReader in(path);
  png_init_io(in.png, in.file);
  png_set_user_limits(in.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_read_info(in.png, in.info);
  Png result;
  result.colour_type = png_get_color_type(in.png, in.info);
  result.depth = png_get_bit_depth(in.png, in.info);
  result.width = static_cast<int>(png_get_image_width(in.png, in.info));
  result.height = static_cast<int>(png_get_image_height(in.png, in.info));
  png_set_packing(in.png);
  png_read_update_info(in.png, in.info);
  std::vector<png_byte> row(png_get_rowbytes(in.png, in.info));
  for (int y = 0; y < result.height; ++y) {
    png_read_row(in.png, row.data(), nullptr);
    for (std::size_t i = 0; i < row.size(); ++i) {
      unsigned sample = row[i];
      if (result.depth == 16) sample = sample << 8 | row[++i];
      result.samples.push_back(static_cast<std::uint16_t>(sample));
    }
  }
  png_read_end(in.png, in.info);
  read_chunks(in, result);
  return result;
}

Png written(const TestFrame& frame, const FrameWriteOptions& options = {}) {
  const TemporaryDirectory directory;
  write_frame(frame, directory.file("out.png"), options);
  Png png = read_png(directory.file("out.png"));
  EXPECT_EQ(png.width, frame.info.width);
  EXPECT_EQ(png.height, frame.info.height);
  return png;
}

TEST(PngWriter, KeepsTheCodesOfEveryPacking) {
  for (const Packing& packing : kPackings) {
    SCOPED_TRACE(packing.name);
    const TestFrame frame = random_frame(frame_info(packing.name, 13, 5));
    const Png png = written(frame);
    const bool rgb = packing.samples == 3;
    EXPECT_EQ(png.colour_type, rgb ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY);
    EXPECT_EQ(png.depth, rgb ? (packing.bits[0] == 16 ? 16 : 8) : packing.bits[0]);
    ASSERT_EQ(png.samples.size(), frame.codes.size());
    for (std::size_t i = 0; i < frame.codes.size(); ++i) {
      const unsigned bits =
          static_cast<unsigned>(packing.bits[i % static_cast<unsigned>(packing.samples)]);
      const unsigned highest = (1u << bits) - 1;
      const unsigned wide = (1u << png.depth) - 1;
      const unsigned long long expected =
          (frame.codes[i] * 2ull * wide + highest) / (2ull * highest);
      ASSERT_EQ(png.samples[i], expected) << "sample " << i;
    }
    const bool widened = rgb && packing.bits[0] < 8;
    const auto& bits = packing.bits;
    EXPECT_EQ(png.significant,
              (widened ? std::array{bits[0], bits[1], bits[2], 0} : std::array<int, 4>{}));
  }
}

TEST(PngWriter, KeepsThePaletteAndItsPositions) {
  const std::pair<const char*, int> cases[] = {
      {"index8", 256}, {"index8", 3}, {"index4", 16}, {"index4", 7}, {"index2", 4}, {"index1", 2},
      {"index1", 1},   {"gray8", 9},  {"gray4", 5},   {"gray2", 4},  {"mono1", 2},
  };
  for (const auto& [packing, colours] : cases) {
    SCOPED_TRACE(std::string(packing) + " with " + std::to_string(colours));
    FrameInfo info = frame_info(packing, 21, 7);
    info.palette = test_palette(colours, info.layout.packing.bits[0]);
    const TestFrame frame = random_frame(info);
    const Png png = written(frame);
    EXPECT_EQ(png.colour_type, PNG_COLOR_TYPE_PALETTE);
    EXPECT_EQ(png.depth, info.layout.packing.bits[0]);
    EXPECT_EQ(png.samples, frame.codes);
    ASSERT_EQ(png.palette.size(), info.palette.size());
    for (std::size_t i = 0; i < png.palette.size(); ++i) {
      const auto& srgb = info.palette[i].srgb;
      EXPECT_EQ(png.palette[i], (std::array<int, 3>{srgb[0], srgb[1], srgb[2]}));
    }
    EXPECT_TRUE(png.srgb);
    EXPECT_EQ(png.significant, (std::array<int, 4>{}));
  }
}

TEST(PngWriter, TakesTheSmallestDepthForThePaletteOfAPackingThatPngLacks) {
  const std::pair<int, int> cases[] = {{2, 1}, {3, 2}, {4, 2}, {5, 4}, {16, 4}, {17, 8}, {256, 8}};
  for (const auto& [colours, depth] : cases) {
    FrameInfo info = frame_info("gray16", 21, 7);
    info.palette = test_palette(colours, 16);
    const TestFrame frame = random_frame(info);
    const Png png = written(frame);
    EXPECT_EQ(png.depth, depth) << colours;
    EXPECT_EQ(png.samples, frame.codes) << colours;
  }
}

TEST(PngWriter, TellsHowManyColoursFit) {
  FrameInfo info = frame_info("index4", 2, 2);
  info.palette = test_palette(17, 4);
  EXPECT_EQ(open_error(info, "out.png"),
            "2 out.png: a palette of 17 colours, but indexed PNG of packing index4 holds at most "
            "16; use fewer colours or a wider packing");
  info = frame_info("gray16", 2, 2);
  info.palette = test_palette(257, 16);
  EXPECT_EQ(open_error(info, "out.png"),
            "2 out.png: a palette of 257 colours, but indexed PNG of packing gray16 holds at most "
            "256; use fewer colours or a wider packing");
}

TEST(PngWriter, SaysWhatTheColoursMean) {
  FrameInfo info = frame_info("rgb888", 2, 2);
  Png png = written(random_frame(info));
  EXPECT_FALSE(png.srgb);
  EXPECT_EQ(png.gamma, 0);
  EXPECT_FALSE(png.primaries);

  info.srgb = true;
  png = written(random_frame(info));
  EXPECT_TRUE(png.srgb);
  EXPECT_NEAR(png.gamma, 0.45455, 1e-9);
  ASSERT_TRUE(png.primaries);
  EXPECT_NEAR(png.primaries->red.x, 0.64, 1e-9);

  info.srgb = false;
  info.gamma = 2.5;
  info.primaries = {{0.67, 0.33}, {0.21, 0.71}, {0.14, 0.08}, {0.31006, 0.31616}};
  png = written(random_frame(info));
  EXPECT_FALSE(png.srgb);
  EXPECT_NEAR(png.gamma, 0.4, 1e-9);
  ASSERT_TRUE(png.primaries);
  EXPECT_NEAR(png.primaries->green.y, 0.71, 1e-9);  // the chunk holds hundred thousandths
  EXPECT_NEAR(png.primaries->white.x, 0.31006, 1e-9);

  info.primaries.blue = {0.0001, -0.077};  // as in AP0: below what the chunk can say
  png = written(random_frame(info));
  EXPECT_NEAR(png.gamma, 0.4, 1e-9);
  EXPECT_FALSE(png.primaries);

  info.primaries = {{1, 0}, {0, 1}, {0, 0}, {1.0 / 3, 1.0 / 3}};  // XYZ
  info.gamma = 1;
  EXPECT_NEAR(written(random_frame(info)).gamma, 1, 1e-9);
}

TEST(PngWriter, SaysTheResolutionAndTheSoftware) {
  FrameInfo info = frame_info("mono1", 2, 2);
  EXPECT_EQ(written(random_frame(info)).dots_per_metre, 0u);
  info.dpi = 300;
  const Png png = written(random_frame(info));
  EXPECT_EQ(png.dots_per_metre, 11811u);
  EXPECT_EQ(png.text, (std::map<std::string, std::string>{{"Software", "tristim"}}));
}

/// A frame as long as several stripes: noise, flat and patterned parts, so that every recipe is
/// chosen.
TestFrame varied_frame(const char* packing, int width, int height) {
  TestFrame frame = random_frame(frame_info(packing, width, height));
  const auto samples = static_cast<std::size_t>(frame.info.layout.packing.samples);
  for (std::size_t i = 0; i < frame.codes.size(); ++i) {
    const std::size_t pixel = i / samples;
    const std::size_t x = pixel % static_cast<unsigned>(width);
    const std::size_t y = pixel / static_cast<unsigned>(width);
    const std::size_t highest = (std::size_t{1} << frame.info.layout.packing.bits[i % samples]) - 1;
    const std::size_t noise = frame.codes[i];
    const std::size_t parts[] = {noise, 7, x * 5 + y * 3, x + y + noise % 2};
    const std::size_t part = y * 4 / static_cast<unsigned>(height);
    frame.codes[i] = static_cast<std::uint16_t>(parts[part] & highest);
  }
  return frame;
}

TEST(PngWriter, ReadsBackAtEveryLevelOverManyStripes) {
  for (const char* packing : {"rgb888", "rgb48", "gray8", "gray16", "gray2", "rgb565"}) {
    const TestFrame frame = varied_frame(packing, 1001, 900);
    const Png first = written(frame);
    for (const int level : {0, 1, 9}) {
      SCOPED_TRACE(std::string(packing) + " at level " + std::to_string(level));
      FrameWriteOptions options;
      options.png_level = level;
      const Png png = written(frame, options);
      EXPECT_TRUE(png.samples == first.samples);
      const bool widened = std::string(packing) == "rgb565";
      EXPECT_TRUE(widened || png.samples == frame.codes);
    }
  }
}

TEST(PngWriter, GivesTheSameBytesForAnyBandHeight) {
  const TemporaryDirectory directory;
  const TestFrame frame = varied_frame("rgb888", 1001, 700);
  write_frame(frame, directory.file("all.png"), {}, 700);
  const std::string all = read_bytes(directory.file("all.png"));
  for (const int rows : {1, 7, 64, 200}) {
    const std::string path = directory.file(std::to_string(rows) + ".png");
    write_frame(frame, path, {}, rows);
    EXPECT_TRUE(read_bytes(path) == all) << rows;
  }
}

TEST(PngWriter, WritesOneRowAndOneColumn) {
  for (const Packing& packing : kPackings) {
    SCOPED_TRACE(packing.name);
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(70001, 1), std::pair(1, 3001)}) {
      const TestFrame frame = random_frame(frame_info(packing.name, width, height));
      const Png png = written(frame);
      ASSERT_EQ(png.samples.size(), frame.codes.size());
      const bool widened = packing.samples == 3 && packing.bits[0] < 8;
      EXPECT_TRUE(widened || png.samples == frame.codes);
    }
  }
}

TEST(PngWriter, CompressesFlatAndPatternedPictures) {
  const TemporaryDirectory directory;
  TestFrame frame = random_frame(frame_info("rgb888", 1000, 1000));
  std::fill(frame.codes.begin(), frame.codes.end(), std::uint16_t{200});
  write_frame(frame, directory.file("flat.png"));
  EXPECT_LT(std::filesystem::file_size(directory.file("flat.png")), 20000u);  // measured: 6 kB
  for (std::size_t i = 0; i < frame.codes.size(); ++i) {
    const std::size_t x = i / 3 % 1000;
    const std::size_t y = i / 3000;
    frame.codes[i] = static_cast<std::uint16_t>(200 + (x * 5 + y * 3) % 8 % 3 % 2);
  }
  write_frame(frame, directory.file("pattern.png"));
  EXPECT_LT(std::filesystem::file_size(directory.file("pattern.png")), 60000u);  // measured: 16 kB
}

TEST(PngWriter, RejectsLevelsThatZlibLacks) {
  FrameWriteOptions options;
  options.png_level = 10;
  EXPECT_THROW(open_code_sink("out.png", frame_info("gray8", 2, 2), options),
               std::invalid_argument);
}

}  // namespace
}  // namespace tristim
