#include <algorithm>
#include <array>

#include "lib/dither/entry_equals.h"
#include "lib/dither/palette_rows.h"

namespace tristim {
namespace {

using detail::PaletteRows;
using detail::PaletteRowsBand;
using detail::PaletteRowsErrors;

// Rows on their way through the lanes: what is wanted, in planes.
class WantedRows {
 public:
  WantedRows(int width, int height)
      : planes_{Image(width, height, 1), Image(width, height, 1), Image(width, height, 1)},
        fixed_(width, height, 1) {}

  void fill(const MixPalette& palette, const detail::EntryEquals& equal_entry,
            ImageView<const float> rgb) {
    for (int y = 0; y < rgb.height; ++y) {
      const std::array<float*, 3> planes{planes_[0].view().row(y).data(),
                                         planes_[1].view().row(y).data(),
                                         planes_[2].view().row(y).data()};
      palette.from_light_row(rgb.row(y), planes);
      const std::span<std::int32_t> fixed = fixed_.view().row(y);
      for (std::size_t x = 0; x < fixed.size(); ++x) {
        fixed[x] = equal_entry({planes[0][x], planes[1][x], planes[2][x]});
      }
    }
  }

  PaletteRowsBand band(int y0, ImageView<std::uint16_t> indices) {
    const int rows = indices.height;
    return {y0,
            {planes_[0].view().rows(0, rows), planes_[1].view().rows(0, rows),
             planes_[2].view().rows(0, rows)},
            fixed_.view().rows(0, rows),
            indices};
  }

 private:
  std::array<Image, 3> planes_;
  Raster<std::int32_t> fixed_;
};

}  // namespace

void PaletteDiffusion::rows(ImageView<const float> rgb, ImageView<std::uint16_t> indices) {
  int y = 0;
  const auto definition = [&] {
    row(rgb.row(y), indices.row(y));
    ++y;
  };
  // What a picture begins with is known only there.
  while (y < rgb.height && (y_ == 0 || errors_.keeps())) definition();
  const PaletteRows* fast =
      options_.serpentine || !tones_.empty() ? nullptr : detail::palette_rows();
  if (fast == nullptr) {
    while (y < rgb.height) definition();
    return;
  }
  const detail::PaletteRowsPlan plan(*palette_, *grid_, errors_, options_.kernel->closed,
                                     options_.jitter, seed_);
  WantedRows wanted(width_, fast->lanes);
  PaletteRowsErrors errors;
  for (int r = 0; r < ErrorRows::kReach; ++r) {
    for (int c = 0; c < 3; ++c) {
      errors.row[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] = errors_.row(r + 1, c);
    }
  }
  for (int c = 0; c < 3; ++c) errors.overflow[static_cast<std::size_t>(c)] = errors_.overflow(c);
  while (y < rgb.height) {
    const int count = std::min(fast->lanes, rgb.height - y);
    wanted.fill(*palette_, *equal_entry_, rgb.rows(y, count));
    fast->run(plan, wanted.band(y_, indices.rows(y, count)), errors);
    y += count;
    y_ += count;
  }
  for (int c = 0; c < 3; ++c) errors_.overflow(c) = errors.overflow[static_cast<std::size_t>(c)];
}

}  // namespace tristim
