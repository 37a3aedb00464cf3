#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "lib/dither/entry_plans.h"
#include "lib/dither/mixtures.h"
#include "tristim/dither/palette.h"

namespace tristim {
namespace {

using Color = MixPalette::Color;

constexpr std::size_t kBlock = 1024;  // pixels that stay in the nearest cache

// Smaller shares are not shown: entries are themselves with what rounding leaves of others.
constexpr float kShown = 1 / 32768.0F;

// The colour on its way from its nearest entry: 0 is the entry, 1 the colour.
Color weakened(const MixPalette& palette, const Color& color, float strength) noexcept {
  const Color& near = palette.entry(palette.nearest(color));
  Color between{};
  for (std::size_t c = 0; c < 3; ++c) between[c] = near[c] + strength * (color[c] - near[c]);
  return between;
}

}  // namespace

struct PaletteOrdered::State {
  const MixPalette* palette;
  ThresholdMatrix matrix;
  std::vector<float> threshold;  // of the matrix, half way between shares of its ranks
  detail::Mixtures mixtures;
  std::optional<detail::EntryPlans> plans;  // where there are no mixtures

  State(const MixPalette& p, const ThresholdMatrix& m) : palette(&p), matrix(m), mixtures(p) {
    for (const std::uint16_t rank : matrix.rank) {
      const float half_way = (static_cast<float>(rank) + 0.5F) / static_cast<float>(matrix.ranks);
      threshold.push_back(std::clamp(half_way, kShown, 1 - kShown));
    }
    if (!mixtures.known()) plans.emplace(p);
  }

  // Of the pixels of row `y` from `x` on.
  void copy_thresholds(int y, std::size_t x, std::size_t count, float* out) const noexcept {
    const auto width = static_cast<std::size_t>(matrix.width);
    const float* row = threshold.data() + (matrix.row(y) - matrix.rank.data());
    std::size_t at = (static_cast<std::size_t>(matrix.column(y)) + x) % width;
    for (std::size_t done = 0; done < count;) {
      const std::size_t part = std::min(width - at, count - done);
      std::copy_n(row + at, part, out + done);
      done += part;
      at = 0;
    }
  }
};

PaletteOrdered::PaletteOrdered(const MixPalette& palette, const ThresholdMatrix& matrix)
    : state_(std::make_unique<const State>(palette, matrix)) {}
PaletteOrdered::PaletteOrdered(PaletteOrdered&&) noexcept = default;
PaletteOrdered::~PaletteOrdered() = default;

void PaletteOrdered::row(int y, std::span<const float> rgb, std::span<std::uint16_t> indices,
                         std::span<const float> strength) const {
  const MixPalette& palette = *state_->palette;
  std::array<std::array<float, kBlock>, 3> planes;
  std::array<float, kBlock> thresholds;
  const std::array<float*, 3> colors{planes[0].data(), planes[1].data(), planes[2].data()};
  for (std::size_t x = 0; x < indices.size(); x += kBlock) {
    const std::size_t count = std::min(kBlock, indices.size() - x);
    palette.from_light_row(rgb.subspan(3 * x, 3 * count), colors);
    for (std::size_t i = 0; i < count && !strength.empty(); ++i) {
      const Color weak =
          weakened(palette, {planes[0][i], planes[1][i], planes[2][i]}, strength[x + i]);
      for (std::size_t c = 0; c < 3; ++c) planes[c][i] = weak[c];
    }
    state_->copy_thresholds(y, x, count, thresholds.data());
    const std::array<const float*, 3> from{colors[0], colors[1], colors[2]};
    const std::span<std::uint16_t> out = indices.subspan(x, count);
    if (state_->plans) {
      state_->plans->entry_row(from, thresholds.data(), out);
    } else {
      state_->mixtures.entry_row(from, thresholds.data(), out);
    }
  }
}

}  // namespace tristim
