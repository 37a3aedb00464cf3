#include "tristim/image/io/read.h"

#include <gtest/gtest.h>
#include <png.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "tests/image/picture_support.h"
#include "tests/support.h"
#include "tristim/color/transfer.h"

namespace tristim {
namespace {

float srgb_light(double code) { return static_cast<float>(srgb_decode(code)); }

class Read : public testing::Test {
 protected:
  TemporaryDirectory directory_;
  std::string path_ = directory_.file("picture");
};

TEST_F(Read, SaysWhatIsWrongWithWhatIsNoPicture) {
  EXPECT_EQ(reading_error(path_),
            "1 " + path_ + ": cannot be opened: no such file or directory; check the path");
  EXPECT_EQ(reading_error(directory_.path().string()),
            "1 " + directory_.path().string() + ": is a directory; name a picture inside it");
  EXPECT_EQ(reading_error("/dev/null"),
            "1 /dev/null: is a device; name a picture file or pipe one in");
  write_bytes(path_, "");
  EXPECT_EQ(reading_error(path_), "3 " + path_ + ": is empty; write or copy it again");
  const std::string text = directory_.file("text.exr");
  write_bytes(text, "once upon a time");
  EXPECT_EQ(reading_error(text).find("3 " + text + ": is no picture"), 0U);
}

TEST_F(Read, GoesByTheFirstBytesAndNotByTheName) {
  const std::string path = directory_.file("really_a_pgm.exr");
  write_bytes(path, std::string("P5 1 1 255\n") + '\x80');
  EXPECT_EQ(picture_facts(path).format, "pgm");
}

TEST_F(Read, ReadsPipes) {
  ASSERT_EQ(mkfifo(path_.c_str(), 0600), 0);
  std::thread writer([&] { write_bytes(path_, "PF 1 2 -1.0\n" + std::string(24, '\0')); });
  EXPECT_EQ(read_whole(path_).info.height, 2);
  writer.join();
}

TEST_F(Read, ReadsStandardInput) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const std::string picture = std::string("P5 2 1 255\n") + '\x00' + '\xff';
  ASSERT_EQ(write(ends[1], picture.data(), picture.size()), static_cast<ssize_t>(picture.size()));
  close(ends[1]);
  const int saved = dup(STDIN_FILENO);
  dup2(ends[0], STDIN_FILENO);
  const WholePicture read = read_whole("-");
  dup2(saved, STDIN_FILENO);
  close(saved);
  close(ends[0]);
  EXPECT_EQ(read.info.name, "standard input");
  EXPECT_EQ(read.at(1, 0, 0), 1);
}

// PNM

TEST_F(Read, ReadsEveryKindOfPnm) {
  struct Case {
    const char* name;
    std::string bytes;
    int width;
    std::vector<float> first_row;  // R of each pixel
  };
  const Case cases[] = {
      {"P1, digits without space", "P1\n# words\n3 1\n1 01\n", 3, {0, 1, 0}},
      {"P2, odd maximum", "P2 3 1 100\n0 50 120", 3, {0, srgb_light(0.5), 1}},
      {"P3", "P3 1 1 255 51 0 0", 1, {srgb_light(0.2)}},
      {"P4", std::string("P4 9 1\n") + '\xaa' + '\x00', 9, {0, 1, 0, 1, 0, 1, 0, 1, 1}},
      {"P5", std::string("P5 2 1 255\n") + '\x33' + '\xff', 2, {srgb_light(0.2), 1}},
      {"P5, 16 bits", std::string("P5 1 1 65535\n") + '\x33' + '\x33', 1, {srgb_light(0.2)}},
      {"P6", std::string("P6 1 1 255\n") + '\x33' + '\x01' + '\x02', 1, {srgb_light(0.2)}},
  };
  for (const Case& test : cases) {
    SCOPED_TRACE(test.name);
    write_bytes(path_, test.bytes);
    const WholePicture picture = read_whole(path_);
    ASSERT_EQ(picture.info.width, test.width);
    for (int x = 0; x < test.width; ++x) {
      EXPECT_EQ(picture.at(x, 0, 0), test.first_row[static_cast<std::size_t>(x)]) << x;
    }
  }
}

TEST_F(Read, PamHasAlpha) {
  write_bytes(
      path_,
      std::string("P7\nWIDTH 1\nHEIGHT 1\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n") +
          '\xff' + '\x33' + '\x00' + '\x33');
  const WholePicture picture = read_whole(path_);
  ASSERT_EQ(picture.info.channels, 4);
  EXPECT_EQ(picture.at(0, 0, 0), 0.2F);
  EXPECT_EQ(picture.at(0, 0, 1), static_cast<float>(static_cast<double>(srgb_light(0.2)) * 0.2));
  EXPECT_EQ(picture.at(0, 0, 3), 0.2F);
}

TEST_F(Read, PfmIsLinearAndFromTheBottom) {
  const float values[] = {1, 2, 3, -4, 5e9F, 6};
  std::string bytes(sizeof values, '\0');
  std::memcpy(bytes.data(), values, sizeof values);
  write_bytes(path_, "PF\n1 2\n-1.0\n" + bytes);
  EXPECT_EQ(read_whole(path_).at(0, 0, 1), 5e9F);
  EXPECT_EQ(read_whole(path_, {}, 1).at(0, 1, 2), 3);
  for (std::size_t i = 0; i < bytes.size(); i += 4)
    std::reverse(bytes.begin() + static_cast<long>(i), bytes.begin() + static_cast<long>(i) + 4);
  write_bytes(path_, "PF\n1 2\n1.0\n" + bytes);
  EXPECT_EQ(read_whole(path_).at(0, 0, 1), 5e9F);
}

TEST_F(Read, ACutPnmNamesItsRow) {
  write_bytes(path_, "P6 4 4 255\n" + std::string(30, 'x'));
  EXPECT_EQ(reading_error(path_),
            "3 " + path_ + ": is damaged or cut off at row 2; write or copy it again");
  write_bytes(path_, "P5 0 4 255\n");
  EXPECT_EQ(reading_error(path_), "3 " + path_ + ": has no pixels: its size is 0x4");
  write_bytes(path_, "P5 99999999 99999999 255\n");
  EXPECT_NE(reading_error(path_).find("is too large"), std::string::npos);
}

// PNG

struct PngCase {
  png_uint_32 width = 1, height = 1;
  int depth = 8;
  int type = PNG_COLOR_TYPE_RGB;
  bool interlaced = false;
  std::function<void(png_structp, png_infop)> add_chunks = [](png_structp, png_infop) {};
};

// `rows`: the samples as the file holds them, rows of whole bytes.
void write_png(const std::string& path, const PngCase& png, std::vector<unsigned char> rows) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  png_structp writer = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(writer);
  png_init_io(writer, file);
  png_set_IHDR(writer, info, png.width, png.height, png.depth, png.type,
               png.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png.add_chunks(writer, info);
  png_write_info(writer, info);
  const std::size_t row_bytes = png_get_rowbytes(writer, info);
  std::vector<png_bytep> pointers;
  for (png_uint_32 y = 0; y < png.height; ++y) pointers.push_back(rows.data() + y * row_bytes);
  png_write_image(writer, pointers.data());
  png_write_end(writer, info);
  png_destroy_write_struct(&writer, &info);
  std::fclose(file);
}

TEST_F(Read, DecodesEveryDepthOfGreyBySrgb) {
  struct Depth {
    int bits;
    std::vector<unsigned char> row;  // codes 0, 1 and the highest
  };
  for (const Depth& depth : {Depth{1, {0x60}}, Depth{2, {0x1c}}, Depth{4, {0x01, 0xf0}},
                             Depth{8, {0, 1, 255}}, Depth{16, {0, 0, 0, 1, 255, 255}}}) {
    SCOPED_TRACE(depth.bits);
    write_png(path_, {.width = 3, .depth = depth.bits, .type = PNG_COLOR_TYPE_GRAY}, depth.row);
    const WholePicture picture = read_whole(path_);
    EXPECT_TRUE(picture.info.grey);
    EXPECT_EQ(picture.info.channels, 3);
    EXPECT_EQ(picture.at(0, 0, 0), 0);
    EXPECT_EQ(picture.at(1, 0, 1), srgb_light(1.0 / ((1 << depth.bits) - 1)));
    EXPECT_EQ(picture.at(2, 0, 2), 1);
  }
}

TEST_F(Read, PremultipliesStraightAlphaInLight) {
  write_png(path_, {.type = PNG_COLOR_TYPE_RGBA}, {51, 255, 0, 51});
  const WholePicture picture = read_whole(path_);
  ASSERT_EQ(picture.info.channels, 4);
  EXPECT_EQ(picture.at(0, 0, 0), static_cast<float>(static_cast<double>(srgb_light(0.2)) * 0.2));
  EXPECT_EQ(picture.at(0, 0, 1), 0.2F);
  EXPECT_EQ(picture.at(0, 0, 3), 0.2F);
}

TEST_F(Read, ReadsPalettesWithTransparency) {
  const auto add = [](png_structp png, png_infop info) {
    const png_color colours[] = {{51, 0, 0}, {0, 255, 0}};
    const png_byte alpha[] = {255, 0};
    png_set_PLTE(png, info, colours, 2);
    png_set_tRNS(png, info, alpha, 2, nullptr);
  };
  write_png(path_, {.width = 2, .depth = 1, .type = PNG_COLOR_TYPE_PALETTE, .add_chunks = add},
            {0x40});
  const WholePicture picture = read_whole(path_);
  ASSERT_EQ(picture.info.channels, 4);
  EXPECT_EQ(picture.at(0, 0, 0), srgb_light(0.2));
  EXPECT_EQ(picture.at(0, 0, 3), 1);
  EXPECT_EQ(picture.at(1, 0, 1), 0);
  EXPECT_EQ(picture.at(1, 0, 3), 0);
  EXPECT_EQ(picture_facts(path_).channels, std::vector<std::string>{"index:1-bit"});
}

TEST_F(Read, InterlacedPngHasTheSameRows) {
  std::vector<unsigned char> rows(13 * 11 * 3);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = static_cast<unsigned char>(i * 7);
  write_png(path_, {.width = 13, .height = 11}, rows);
  const WholePicture plain = read_whole(path_);
  write_png(path_, {.width = 13, .height = 11, .interlaced = true}, rows);
  const WholePicture interlaced = read_whole(path_, {}, 3);
  for (int y = 0; y < 11; ++y) {
    EXPECT_TRUE(std::ranges::equal(plain.image.view().row(y), interlaced.image.view().row(y))) << y;
  }
}

TEST_F(Read, HonoursGamaAndChrm) {
  const auto add = [](png_structp png, png_infop info) {
    png_set_gAMA_fixed(png, info, 50000);
    png_set_cHRM(png, info, 0.31, 0.316, 0.67, 0.33, 0.21, 0.71, 0.14, 0.08);
  };
  write_png(path_, {.add_chunks = add}, {51, 255, 0});
  const WholePicture picture = read_whole(path_);
  EXPECT_EQ(picture.at(0, 0, 0), static_cast<float>(0.2 * 0.2));
  EXPECT_NEAR(picture.info.primaries.red.x, 0.67, 1e-9);
  EXPECT_NEAR(picture.info.primaries.white.y, 0.316, 1e-9);
}

TEST_F(Read, SrgbChunkGoesBeforeGama) {
  const auto add = [](png_structp png, png_infop info) {
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  };
  write_png(path_, {.add_chunks = add}, {51, 255, 0});
  EXPECT_EQ(read_whole(path_).at(0, 0, 0), srgb_light(0.2));
  EXPECT_EQ(picture_facts(path_).colour, "sRGB chunk");
}

std::function<void(png_structp, png_infop)> cicp(unsigned char primaries, unsigned char transfer) {
  return [=](png_structp png, png_infop info) {
    png_byte data[4] = {primaries, transfer, 0, 1};
    png_unknown_chunk chunk = {{'c', 'I', 'C', 'P', 0}, data, 4, PNG_HAVE_IHDR};
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_ALWAYS, chunk.name, 1);
    png_set_unknown_chunks(png, info, &chunk, 1);
  };
}

TEST_F(Read, HonoursCicp) {
  write_png(path_, {.add_chunks = cicp(9, 8)}, {51, 255, 0});
  const WholePicture picture = read_whole(path_);
  EXPECT_EQ(picture.at(0, 0, 0), 0.2F);
  EXPECT_EQ(picture.info.primaries.red, (Chromaticity{0.708, 0.292}));
  write_png(path_, {.add_chunks = cicp(12, 13)}, {51, 255, 0});
  EXPECT_EQ(read_whole(path_).at(0, 0, 0), srgb_light(0.2));
  write_png(path_, {.add_chunks = cicp(9, 16)}, {51, 255, 0});  // PQ
  EXPECT_NE(reading_error(path_).find("3 " + path_ +
                                      ": its cICP colours (9, 16, 0, 1) are not known here"),
            std::string::npos);
}

TEST_F(Read, TakesPixelAspectAndOrientationFromPng) {
  const auto add = [](png_structp png, png_infop info) {
    png_set_pHYs(png, info, 1000, 2000, PNG_RESOLUTION_UNKNOWN);
    png_byte exif[] = {'I', 'I', 42, 0, 8, 0, 0, 0, 1, 0, 0x12, 1, 3,
                       0,   1,   0,  0, 0, 6, 0, 0, 0, 0, 0,    0, 0};
    png_set_eXIf_1(png, info, sizeof exif, exif);
  };
  write_png(path_, {.add_chunks = add}, {51, 255, 0});
  EXPECT_EQ(read_whole(path_).info.pixel_aspect, 2);
  EXPECT_EQ(read_whole(path_).info.orientation, 6);
}

TEST_F(Read, ACutPngIsAContentError) {
  std::vector<unsigned char> noise(300 * 100 * 3);
  std::uint32_t state = 1;
  for (unsigned char& byte : noise)
    byte = static_cast<unsigned char>((state = state * 1664525 + 1013904223) >> 24);
  write_png(path_, {.width = 300, .height = 100}, noise);
  const std::string whole = read_bytes(path_);
  write_bytes(path_, whole.substr(0, whole.size() / 2));
  EXPECT_EQ(reading_error(path_).find("3 " + path_ + ": is damaged or cut off at row "), 0U);
  write_bytes(path_, whole.substr(0, 20));
  EXPECT_EQ(reading_error(path_).find("3 " + path_ + ": its PNG header is damaged or cut off"), 0U);
}

// What OpenImageIO reads

std::string little(unsigned value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i));
  return text;
}

struct TiffCase {
  unsigned width = 1, height = 1;
  unsigned bits = 8, samples = 3, photometric = 2;  // RGB
  unsigned sample_format = 1;                       // 1: unsigned, 3: float
  unsigned extra_sample = 0;                        // 1: associated alpha, 2: unassociated
  unsigned orientation = 1;
  std::string colour_map = {};  // 3 * 2^bits shorts
};

// One uncompressed strip, little endian [TIFF6].
std::string tiff(const TiffCase& t, const std::string& pixels) {
  const bool alpha = t.extra_sample != 0;
  const unsigned entries = 11 + (alpha ? 1 : 0) + (t.colour_map.empty() ? 0 : 1);
  const unsigned map_at = 8 + 2 + entries * 12 + 4;
  const unsigned data_at = map_at + static_cast<unsigned>(t.colour_map.size());
  std::string file = "II" + little(42, 2) + little(8, 4) + little(entries, 2);
  const auto add = [&](unsigned tag, unsigned type, unsigned count, unsigned value) {
    file += little(tag, 2) + little(type, 2) + little(count, 4) + little(value, 4);
  };
  add(256, 4, 1, t.width);
  add(257, 4, 1, t.height);
  add(258, 3, 1, t.bits);  // libtiff takes one count for all samples
  add(259, 3, 1, 1);
  add(262, 3, 1, t.photometric);
  add(273, 4, 1, data_at);
  add(274, 3, 1, t.orientation);
  add(277, 3, 1, t.samples);
  add(278, 4, 1, t.height);
  add(279, 4, 1, static_cast<unsigned>(pixels.size()));
  if (!t.colour_map.empty()) add(320, 3, static_cast<unsigned>(t.colour_map.size() / 2), map_at);
  if (alpha) add(338, 3, 1, t.extra_sample);
  add(339, 3, 1, t.sample_format);
  return file + little(0, 4) + t.colour_map + pixels;
}

std::string bytes_of(const std::vector<float>& values) {
  std::string bytes(values.size() * 4, '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

TEST_F(Read, DecodesTiffIntegersBySrgbAndTakesFloatsAsLight) {
  write_bytes(path_, tiff({}, "\x33\xff\x01"));
  EXPECT_EQ(read_whole(path_).at(0, 0, 0), srgb_light(0.2));
  write_bytes(path_, tiff({.bits = 16}, "\x33\x33\xff\xff\x01\x01"));
  EXPECT_EQ(read_whole(path_).at(0, 0, 0), srgb_light(0.2));
  write_bytes(path_, tiff({.bits = 32, .sample_format = 3}, bytes_of({0.25F, -1, 1e6F})));
  EXPECT_EQ(read_whole(path_).at(0, 0, 0), 0.25F);
  EXPECT_EQ(read_whole(path_).at(0, 0, 2), 1e6F);
}

TEST_F(Read, PremultipliesTiffAlphaInLight) {
  write_bytes(path_, tiff({.samples = 4, .extra_sample = 2}, "\xff\x33\x01\x33"));
  const WholePicture straight = read_whole(path_);
  ASSERT_EQ(straight.info.channels, 4);
  EXPECT_EQ(straight.at(0, 0, 0), 0.2F);
  EXPECT_EQ(straight.at(0, 0, 1), static_cast<float>(static_cast<double>(srgb_light(0.2)) * 0.2));
  write_bytes(path_, tiff({.samples = 4, .extra_sample = 1}, "\x33\x33\x01\x33"));
  EXPECT_EQ(read_whole(path_).at(0, 0, 0), 0.2F);  // white under alpha .2
}

TEST_F(Read, ReadsTiffPaletteAndWhiteIsZero) {
  write_bytes(path_, tiff({.width = 2,
                           .samples = 1,
                           .photometric = 3,
                           .colour_map = std::string(2, '\x33') + std::string(1534, '\0')},
                          std::string("\0\1", 2)));
  EXPECT_EQ(read_whole(path_).at(0, 0, 0), srgb_light(0.2));
  EXPECT_EQ(read_whole(path_).at(0, 0, 1), 0);
  write_bytes(path_, tiff({.width = 2, .samples = 1, .photometric = 0}, std::string("\0\xff", 2)));
  EXPECT_EQ(read_whole(path_).at(0, 0, 0), 1);
  EXPECT_TRUE(read_whole(path_).info.grey);
}

TEST_F(Read, TakesOrientationFromTiff) {
  write_bytes(path_, tiff({.orientation = 8}, "abc"));
  EXPECT_EQ(read_whole(path_).info.orientation, 8);
}

TEST_F(Read, RefusesCmykInOneLine) {
  write_bytes(path_, tiff({.samples = 4, .photometric = 5}, "abcd"));
  EXPECT_EQ(reading_error(path_),
            "3 " + path_ + ": is CMYK, not RGB; convert it to RGB with its profile first");
}

// A baseline JPEG of 8x8 pixels, each component 128: its tables know but the codes that are needed.
std::string jpeg(int components) {
  const auto count = static_cast<char>(components);
  std::string file = "\xff\xd8";
  file += std::string(
      "\xff\xe1\0\x22"
      "Exif\0\0II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0",
      36);
  file += std::string("\xff\xdb\0\x43\0", 5) + std::string(64, '\1');
  file += std::string("\xff\xc0\0", 3) + static_cast<char>(8 + 3 * components) +
          std::string("\x08\0\x08\0\x08", 5) + count;
  for (char c = 1; c <= count; ++c) file += std::string{c, '\x11', '\0'};
  for (const char table : {'\x00', '\x10'}) {
    file += std::string("\xff\xc4\0\x14", 4) + table + '\1' + std::string(16, '\0');
  }
  file += std::string("\xff\xda\0", 3) + static_cast<char>(6 + 2 * components) + count;
  for (char c = 1; c <= count; ++c) file += std::string{c, '\0'};
  file += std::string("\0\x3f\0", 3) + (components == 1 ? '\x3f' : '\0');
  return file + "\xff\xd9";
}

TEST_F(Read, ReadsJpegWithItsOrientation) {
  write_bytes(path_, jpeg(1));
  const WholePicture picture = read_whole(path_);
  EXPECT_EQ(picture.info.width, 8);
  EXPECT_TRUE(picture.info.grey);
  EXPECT_EQ(picture.at(7, 7, 0), srgb_light(128 / 255.0));
  EXPECT_EQ(picture.info.orientation, 6);
  write_bytes(path_, jpeg(4));
  EXPECT_NE(reading_error(path_).find("is CMYK, not RGB"), std::string::npos)
      << reading_error(path_);
}

TEST_F(Read, ReadsRadianceWithItsPrimaries) {
  const std::string pixels("\x80\x40\x20\x81", 4);  // 1, .5, .25
  write_bytes(path_, "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n" + pixels);
  const WholePicture plain = read_whole(path_);
  EXPECT_NEAR(plain.at(0, 0, 0), 1,
              0.01);  // the format has 8 bits, and readers differ by half a step
  EXPECT_NEAR(plain.at(0, 0, 2), 0.25, 0.005);
  EXPECT_EQ(plain.info.primaries, Primaries{});
  write_bytes(path_,
              "#?RADIANCE\nPRIMARIES= .67 .33 .21 .71 .14 .08 .31 "
              ".316\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n" +
                  pixels);
  EXPECT_EQ(read_whole(path_).info.primaries.red, (Chromaticity{0.67, 0.33}));
  EXPECT_EQ(read_whole(path_).info.primaries.white, (Chromaticity{0.31, 0.316}));
}

TEST_F(Read, ReadsBmpFromTheTop) {
  const std::string header = "BM" + little(70, 4) + little(0, 4) + little(54, 4) + little(40, 4) +
                             little(1, 4) + little(2, 4) + little(1, 2) + little(24, 2) +
                             little(0, 4) + little(16, 4) + std::string(16, '\0');
  write_bytes(path_, header + std::string("\0\0\x33\0\0\xff\0\0", 8));  // bottom row first, B G R
  const WholePicture picture = read_whole(path_);
  EXPECT_EQ(picture.at(0, 0, 1), 1);
  EXPECT_EQ(picture.at(0, 1, 0), srgb_light(0.2));
}

TEST_F(Read, ACutTiffIsAContentError) {
  const std::string whole = tiff({.width = 50, .height = 50}, std::string(7500, 'x'));
  write_bytes(path_, whole.substr(0, whole.size() - 4000));
  const std::string error = reading_error(path_);
  EXPECT_EQ(error.substr(0, 2), "3 ") << error;
  EXPECT_EQ(error.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace tristim
