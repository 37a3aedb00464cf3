#include <algorithm>
#include <array>
#include <deque>

#include "lib/dither/entry_equals.h"
#include "lib/dither/palette_rows.h"

namespace tristim {
namespace {

using detail::PaletteMeetingRows;
using detail::PaletteRows;
using detail::PaletteRowsBand;

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

void PaletteDiffusion::rows(ImageView<const float> rgb, ImageView<std::uint16_t> indices,
                            int threads) {
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
  const int lanes = fast->lanes;
  const int groups = (rgb.height - y + lanes - 1) / lanes;
  std::deque<PaletteMeetingRows> meeting;
  for (int g = 0; g <= groups; ++g) meeting.emplace_back(width_, plan.rows, lanes);
  for (int c = 0; c < 3; ++c) meeting.front().channel[static_cast<std::size_t>(c)].load(errors_, c);
  detail::in_turn(groups, threads, [&] {
    return [&, wanted = WantedRows(width_, lanes)](int group) mutable {
      const int first = group * lanes;
      const int count = std::min(lanes, rgb.height - y - first);
      wanted.fill(*palette_, *equal_entry_, rgb.rows(y + first, count));
      const auto at = static_cast<std::size_t>(group);
      fast->run(plan, wanted.band(y_ + first, indices.rows(y + first, count)), meeting[at],
                meeting[at + 1]);
    };
  });
  y_ += rgb.height - y;
  for (int c = 0; c < 3; ++c) meeting.back().channel[static_cast<std::size_t>(c)].store(errors_, c);
}

}  // namespace tristim
