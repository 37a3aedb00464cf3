#include "lib/image/io/png_colour.h"

#include <algorithm>
#include <cstring>

namespace tristim::detail {
namespace {

// Code points of [H273].
struct CicpPrimaries {
  int code;
  Primaries primaries;
  const char* name;
};
constexpr CicpPrimaries kCicpPrimaries[] = {
    {1, {{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, kD65}, "BT.709"},
    {9, {{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, kD65}, "BT.2020"},
    {12, {{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, kD65}, "P3 D65"},
};

struct CicpTransfer {
  int code;
  Curve curve;
  const char* name;
};
constexpr CicpTransfer kCicpTransfers[] = {
    {1, {Curve::Kind::kBt709, 1}, "BT.709"},      {4, {Curve::Kind::kGamma, 2.2}, "gamma 2.2"},
    {5, {Curve::Kind::kGamma, 2.8}, "gamma 2.8"}, {6, {Curve::Kind::kBt709, 1}, "BT.601"},
    {8, {Curve::Kind::kLinear, 1}, "linear"},     {13, {Curve::Kind::kSrgb, 1}, "sRGB"},
    {14, {Curve::Kind::kBt709, 1}, "BT.2020"},    {15, {Curve::Kind::kBt709, 1}, "BT.2020"},
};

// The bytes of an ancillary chunk that libpng does not know, or nullptr.
const unsigned char* unknown_chunk(png_structp png, png_infop info, const char* name,
                                   std::size_t size) {
  png_unknown_chunkp chunks = nullptr;
  const int count = png_get_unknown_chunks(png, info, &chunks);
  for (int i = 0; i < count; ++i) {
    const bool named = std::memcmp(chunks[i].name, name, 4) == 0;
    if (named && chunks[i].size == size) return chunks[i].data;
  }
  return nullptr;
}

void read_cicp(const unsigned char* cicp, PngColour& colour) {
  const auto* primaries = std::ranges::find(kCicpPrimaries, int{cicp[0]}, &CicpPrimaries::code);
  const auto* transfer = std::ranges::find(kCicpTransfers, int{cicp[1]}, &CicpTransfer::code);
  if (primaries == std::end(kCicpPrimaries) || transfer == std::end(kCicpTransfers) ||
      cicp[2] != 0 || cicp[3] != 1) {
    colour.refusal = "its cICP colours (" + std::to_string(cicp[0]) + ", " +
                     std::to_string(cicp[1]) + ", " + std::to_string(cicp[2]) + ", " +
                     std::to_string(cicp[3]) + ") are not known here";
    return;
  }
  colour.primaries = primaries->primaries;
  colour.curve = transfer->curve;
  colour.words =
      std::string("cICP: ") + primaries->name + " primaries, " + transfer->name + " curve";
}

void read_gamma(png_structp png, png_infop info, PngColour& colour) {
  png_fixed_point gamma = 0;  // of encoding, times 100000
  if (png_get_gAMA_fixed(png, info, &gamma) == 0 || gamma <= 0) {
    colour.words = "sRGB curve: the file does not say";
    return;
  }
  colour.words = "gAMA " + std::to_string(gamma);
  if (gamma == PNG_FP_1) {
    colour.curve = {Curve::Kind::kLinear};
  } else {
    colour.curve = {Curve::Kind::kGamma, static_cast<double>(PNG_FP_1) / gamma};
  }
}

void read_primaries(png_structp png, png_infop info, PngColour& colour) {
  Primaries& p = colour.primaries;
  if (png_get_cHRM(png, info, &p.white.x, &p.white.y, &p.red.x, &p.red.y, &p.green.x, &p.green.y,
                   &p.blue.x, &p.blue.y) == 0) {
    p = {};
    colour.words += ", sRGB primaries";
  } else {
    colour.words += ", primaries of cHRM";
  }
}

unsigned number(const unsigned char* bytes, std::size_t count, bool little) noexcept {
  unsigned value = 0;
  for (std::size_t i = 0; i < count; ++i) value = value << 8 | bytes[little ? count - 1 - i : i];
  return value;
}

}  // namespace

void read_png_colour(png_structp png, png_infop info, PngColour& colour) {
  if (const unsigned char* cicp = unknown_chunk(png, info, "cICP", 4)) {
    read_cicp(cicp, colour);
    return;
  }
  if (png_get_valid(png, info, PNG_INFO_sRGB) != 0) {
    colour.words = "sRGB chunk";
  } else {
    read_gamma(png, info, colour);
    read_primaries(png, info, colour);
  }
  if (png_get_valid(png, info, PNG_INFO_iCCP) != 0) colour.words += "; its ICC profile is ignored";
}

int exif_orientation(const unsigned char* exif, std::size_t size) noexcept {
  constexpr std::size_t kEntryBytes = 12;
  constexpr unsigned kOrientationTag = 0x112;
  if (size < 8) return 1;
  const bool little = exif[0] == 'I';
  const std::size_t directory = number(exif + 4, 4, little);
  if (directory > size - 2) return 1;
  const std::size_t entries = number(exif + directory, 2, little);
  for (std::size_t i = 0; i < entries; ++i) {
    const std::size_t at = directory + 2 + i * kEntryBytes;
    if (at + kEntryBytes > size) return 1;
    if (number(exif + at, 2, little) != kOrientationTag) continue;
    const unsigned value = number(exif + at + 8, 2, little);
    return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
  }
  return 1;
}

}  // namespace tristim::detail
