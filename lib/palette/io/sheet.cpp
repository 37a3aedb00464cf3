#include <png.h>

#include <algorithm>
#include <array>
#include <new>
#include <set>

#include "lib/image/io/indexed_readers.h"
#include "lib/palette/io/formats.h"
#include "lib/palette/io/text_rows.h"
#include "tristim/color/transfer.h"
#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

constexpr std::size_t kSide = 24;     // of a swatch, in pixels
constexpr std::size_t kColumns = 16;  // swatches side by side
constexpr std::size_t kMostFound = 256;

// The colours of a picture without palette in the order in which they come, row by row.
Palette found_colors(const InputFilePtr& file) {
  const auto source = std::move(open_png(file, {}).rows);
  const PictureInfo& info = source->info();
  Image row(info.width, 1, info.channels);
  Palette palette;
  std::set<std::array<std::uint16_t, 4>> seen;
  for (int y = 0; y < info.height; ++y) {
    source->read(row.view());
    for (int x = 0; x < info.width; ++x) {
      const float* p = row.view().pixel(x, 0);
      const double alpha = info.channels == 4 ? p[3] : 1;
      const double light = alpha > 0 ? 1 / alpha : 0;  // rows are multiplied by alpha
      std::array<std::uint16_t, 4> codes{0, 0, 0, unit_code(alpha, 255)};
      for (std::size_t c = 0; c < 3; ++c) codes[c] = unit_code(srgb_encode(p[c] * light), 255);
      if (!seen.insert(codes).second) continue;
      palette.colors.push_back(
          {color_of_codes(codes[0], codes[1], codes[2]), {}, codes[3] / 255.0});
      if (palette.colors.size() > kMostFound) {
        throw Error(ErrorKind::kContent, file->name(),
                    "is a picture without palette that has more than " +
                        std::to_string(kMostFound) + " colours",
                    "choose a palette for it: tristim palette build");
      }
    }
  }
  return palette;
}

}  // namespace

// The palette of an indexed PNG in its order, whether pixels have its colours or not.
Palette read_sheet(std::string_view bytes, const std::string& file) {
  const auto input = std::make_shared<const InputFile>(file, bytes);
  const auto picture = read_indexed_png(input);
  if (!picture) return found_colors(input);
  Palette palette;
  for (const auto& [r, g, b, alpha] : picture->palette) {
    palette.colors.push_back({color_of_codes(r, g, b), {}, alpha / 255.0});
  }
  return palette;
}

// Squares in rows; those behind the last colour have the first one.
std::string write_sheet(const Palette& palette) {
  const std::size_t count = palette.colors.size();
  const std::size_t columns = std::min(count, kColumns);
  const std::size_t width = columns * kSide;
  const std::size_t height = (count + columns - 1) / columns * kSide;
  std::vector<png_byte> positions(width * height);
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t swatch = y / kSide * columns + x / kSide;
      positions[y * width + x] = static_cast<png_byte>(swatch < count ? swatch : 0);
    }
  }
  std::vector<png_byte> map;
  for (const PaletteColor& entry : palette.colors) {
    for (const std::uint8_t code : color_codes8(entry.color)) map.push_back(code);
    map.push_back(static_cast<png_byte>(unit_code(entry.alpha, 255)));
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGBA_COLORMAP;
  image.colormap_entries = static_cast<png_uint_32>(count);
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, positions.data(), 0, map.data()) ==
      0) {
    throw std::bad_alloc();  // nothing else can fail
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace tristim::detail
