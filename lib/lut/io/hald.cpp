#include <algorithm>

#include "lib/image/io/readers.h"
#include "lib/lut/io/formats.h"
#include "lib/lut/io/png_bytes.h"
#include "lib/lut/io/tables.h"
#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

constexpr int kMostLevel = 16;

// The edge of the cube of a picture whose side is the third power of its level; 0: it is none.
int edge_of_side(int side) {
  for (int level = 2; level <= kMostLevel; ++level) {
    if (level * level * level == side) return level * level;
  }
  return 0;
}

}  // namespace

// The identity picture of Eskil Steenberg [Hald] after the changes: the colours of a cube of
// level^2 points an edge, red fastest, as the rows of a square of level^3 pixels.
Lut read_hald(std::string_view bytes, const std::string& file, const LutFileOptions& /*options*/) {
  const auto input = std::make_shared<const InputFile>(file, bytes);
  const OpenedPicture opened = open_png(input, {.codes = true});
  const PictureInfo& info = opened.facts.info;
  const int size = info.width == info.height ? edge_of_side(info.width) : 0;
  if (size == 0) {
    throw Error(ErrorKind::kContent, file,
                "is a picture of " + std::to_string(info.width) + "x" +
                    std::to_string(info.height) + ", no table",
                "a Hald picture is square with a side of 8, 27, 64, 125 ... 4096");
  }
  Lut3D cube{{}, size, {}};
  cube.rgb.reserve(cube_samples(size));
  Image row(info.width, 1, info.channels);
  for (int y = 0; y < info.height; ++y) {
    opened.rows->read(row.view());
    for (int x = 0; x < info.width; ++x) {
      const float* pixel = row.view().pixel(x, 0);
      cube.rgb.insert(cube.rgb.end(), pixel, pixel + 3);
    }
  }
  return {"", {std::move(cube)}};
}

std::string write_hald(const Lut& lut, const LutFileOptions& options) {
  const Lut3D& cube = *parts_of(lut).cube;
  int level = 2;
  while (level * level < cube.size) ++level;
  const int side = level * level * level;
  const bool wide = options.bits == 0 || options.bits > 8;
  std::string samples;
  samples.reserve(cube.rgb.size() * 2);
  for (const float value : cube.rgb) {
    const std::uint16_t code = table_code(value, most_of_bits(wide ? 16 : 8));
    if (wide) samples += static_cast<char>(code >> 8);
    samples += static_cast<char>(code & 0xff);
  }
  return png_bytes(side, side, wide ? 16 : 8, samples);
}

}  // namespace tristim::detail
