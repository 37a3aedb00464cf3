#include <zlib.h>

#include "tests/tools/command_test.h"

namespace tristim {
namespace {

// Small files that claim to be pictures of 2^31 pixels a side, or as many as their format can say.
class ProcessHuge : public CommandTest {};

constexpr std::uint32_t kSide = 0x7fffffff;

std::string little(std::uint32_t value, int bytes = 4) {
  std::string text;
  for (int i = 0; i < bytes; ++i, value >>= 8) text += static_cast<char>(value & 0xff);
  return text;
}

std::string big(std::uint32_t value) {
  const std::string text = little(value);
  return {text.rbegin(), text.rend()};
}

std::string png_chunk(const std::string& body) {
  const uLong sum =
      crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  return big(static_cast<std::uint32_t>(body.size() - 4)) + body +
         big(static_cast<std::uint32_t>(sum));
}

std::string png(std::uint32_t side, const std::string& depth_and_kind) {
  return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR" + big(side) + big(side) + depth_and_kind) +
         png_chunk("IDAT" + std::string(1000, '\0')) + png_chunk("IEND");
}

std::string exr_attribute(const std::string& name, const std::string& type,
                          const std::string& value) {
  return name + '\0' + type + '\0' + little(static_cast<std::uint32_t>(value.size())) + value;
}

// One half channel, zip; in tiles of such a side where that is above 0.
std::string exr(std::uint32_t last, std::uint32_t tile) {
  const std::string box = little(0) + little(0) + little(last) + little(last);
  const std::string one = little(0x3f800000);
  std::string text = std::string("\x76\x2f\x31\x01", 4) + little(tile > 0 ? 0x202 : 2);
  text +=
      exr_attribute("channels", "chlist",
                    std::string("Y\0", 2) + little(1) + little(0) + little(1) + little(1) + '\0');
  text += exr_attribute("compression", "compression", "\x03");
  text += exr_attribute("dataWindow", "box2i", box) + exr_attribute("displayWindow", "box2i", box);
  text += exr_attribute("lineOrder", "lineOrder", std::string(1, '\0'));
  text += exr_attribute("pixelAspectRatio", "float", one);
  text += exr_attribute("screenWindowCenter", "v2f", little(0) + little(0));
  text += exr_attribute("screenWindowWidth", "float", one);
  if (tile > 0) {
    text += exr_attribute("tiles", "tiledesc", little(tile) + little(tile) + std::string(1, '\0'));
  }
  return text + std::string(100000, '\0');
}

std::string bmp() {
  const std::string head = little(40) + little(kSide) + little(kSide) + little(1, 2) +
                           little(24, 2) + std::string(24, '\0');
  return "BM" + little(1054) + little(0) + little(54) + head + std::string(1000, '\0');
}

std::string tiff_tag(std::uint32_t tag, std::uint32_t value) {
  return little(tag, 2) + little(4, 2) + little(1) + little(value);
}

// Grey, in one strip or in tiles of 2^30.
std::string tiff(bool tiled) {
  std::string tags = tiff_tag(256, kSide) + tiff_tag(257, kSide) + tiff_tag(258, 8) +
                     tiff_tag(259, 1) + tiff_tag(262, 1);
  if (tiled) {
    tags += tiff_tag(277, 1) + tiff_tag(322, 1U << 30) + tiff_tag(323, 1U << 30) +
            tiff_tag(324, 200) + tiff_tag(325, 500);
  } else {
    tags += tiff_tag(273, 200) + tiff_tag(277, 1) + tiff_tag(278, kSide) + tiff_tag(279, 500);
  }
  return std::string("II*\0", 4) + little(8) +
         little(static_cast<std::uint32_t>(tags.size() / 12), 2) + tags + little(0) +
         std::string(1000, '\0');
}

std::string gif() {
  return "GIF89a" + little(65535, 2) + little(65535, 2) + std::string("\x80\0\0", 3) +
         std::string(6, '\0') + "," + little(0) + little(65535, 2) + little(65535, 2) +
         std::string("\0\x02\x02\x4c\x01\0;", 7);
}

TEST_F(ProcessHuge, IsRefusedBeforeMemoryIsAskedFor) {
  const std::string side = std::to_string(kSide);
  const std::string rest(1000, '\0');
  const std::pair<std::string, std::string> pictures[] = {
      {"rgb.png", png(kSide, std::string("\x08\x02\0\0\0", 5))},
      {"interlaced.png", png(1U << 20, std::string("\x10\x06\0\0\x01", 5))},
      {"text.pbm", "P1 " + side + " " + side + "\n" + rest},
      {"packed.pbm", "P4 " + side + " " + side + "\n" + rest},
      {"grey.pgm", "P5 " + side + " " + side + " 255\n" + rest},
      {"rgb.ppm", "P6 " + side + " " + side + " 65535\n" + rest},
      {"rgb.pam", "P7\nWIDTH " + side + "\nHEIGHT " + side +
                      "\nDEPTH 3\nMAXVAL 255\nTUPLTYPE RGB\nENDHDR\n" + rest},
      {"rgb.pfm", "PF\n" + side + " " + side + "\n-1\n" + rest},
      {"rgb.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + side + " +X " + side + "\n" + rest},
      {"rgb.bmp", bmp()},
      {"strip.tif", tiff(false)},
      {"tiles.tif", tiff(true)},
      {"lines.exr", exr(kSide - 1, 0)},
      {"tiles.exr", exr(kSide - 1, 64)},
      {"million.exr", exr((1U << 20) - 1, 0)},
      {"large-tiles.exr", exr((1U << 20) - 1, 1U << 20)},
      {"canvas.gif", gif()},
  };
  for (const auto& [name, bytes] : pictures) {
    SCOPED_TRACE(name);
    write(name, bytes);
    for (const std::string& command :
         {"process " + name + " -d srgb -o o.png --quiet",
          "process " + name + " -d srgb --rotate 90 -o o.png --quiet", "info " + name}) {
      const CommandResult result = run(command);
      EXPECT_EQ(result.exit_code, 3) << command << result.out;
      EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
      EXPECT_LT(result.peak_bytes, std::size_t{192} << 20) << command;  // OpenImageIO takes 140
      EXPECT_FALSE(exists("o.png"));
    }
  }
}

}  // namespace
}  // namespace tristim
