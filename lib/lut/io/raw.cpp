#include <cmath>
#include <optional>

#include "lib/lut/io/formats.h"
#include "lib/lut/io/tables.h"
#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

constexpr int kBits = 8;
constexpr std::size_t kMostEntries = std::size_t{1} << 24;  // of a cube of 256

int bits_of(const LutFileOptions& options) { return options.bits != 0 ? options.bits : kBits; }

// The size of the table that so many codes are; 0: none.
int size_of(std::size_t codes, bool cube, std::size_t channels) {
  const std::size_t entries = codes / channels;
  if (codes % channels != 0 || entries < 2 || entries > kMostEntries) return 0;
  if (!cube)
    return entries <= static_cast<std::size_t>(kMostCurveSize) ? static_cast<int>(entries) : 0;
  const auto size = static_cast<int>(std::lround(std::cbrt(static_cast<double>(entries))));
  return size >= 2 && cube_samples(size) == codes ? size : 0;
}

std::string expected(bool cube, std::size_t channels, std::size_t width) {
  const std::string entry = std::to_string(width * channels);
  return cube ? "a cube has " + entry + " bytes a colour, and 8, 27, 64, ... colours"
              : "curves have " + entry + " bytes an entry";
}

}  // namespace

// The codes of a table, nothing else: bytes, or words of 9 to 16 bits with the low byte first.
Lut read_raw(std::string_view bytes, const std::string& file, const LutFileOptions& options) {
  const int bits = bits_of(options);
  const std::size_t width = bits > 8 ? 2 : 1;
  const bool one = options.one_curve && !options.cube;
  const std::size_t channels = one ? 1 : 3;
  const std::size_t codes = bytes.size() / width;
  const int size = bytes.size() % width == 0 ? size_of(codes, options.cube, channels) : 0;
  if (size == 0) {
    throw Error(ErrorKind::kContent, file,
                "has " + std::to_string(bytes.size()) + " bytes, which is no table of " +
                    std::to_string(bits) + " bits",
                expected(options.cube, channels, width));
  }
  std::vector<float> rgb;
  rgb.reserve(codes * (one ? 3 : 1));
  for (std::size_t i = 0; i < codes; ++i) {
    int code = static_cast<unsigned char>(bytes[i * width]);
    if (width == 2) code |= static_cast<unsigned char>(bytes[i * width + 1]) << 8;
    if (code > most_of_bits(bits)) {
      throw Error(
          ErrorKind::kContent, file + ", byte " + std::to_string(i * width),
          "code " + std::to_string(code) + " has more than " + std::to_string(bits) + " bits");
    }
    const float value = static_cast<float>(code) / static_cast<float>(most_of_bits(bits));
    rgb.insert(rgb.end(), one ? 3 : 1, value);
  }
  if (options.cube) return {"", {Lut3D{{}, size, std::move(rgb)}}};
  return {"", {Lut1D{{}, size, std::move(rgb)}}};
}

std::string write_raw(const Lut& lut, const LutFileOptions& options) {
  const auto [points, curves, cube] = parts_of(lut);
  const int bits = bits_of(options);
  const std::vector<float>& rgb = cube != nullptr ? cube->rgb : curves->rgb;
  std::string bytes;
  for (std::size_t i = 0; i < rgb.size(); i += options.one_curve && cube == nullptr ? 3 : 1) {
    const std::uint16_t code = table_code(rgb[i], most_of_bits(bits));
    bytes += static_cast<char>(code & 0xff);
    if (bits > 8) bytes += static_cast<char>(code >> 8);
  }
  return bytes;
}

}  // namespace tristim::detail
