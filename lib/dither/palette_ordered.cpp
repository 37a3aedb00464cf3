#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "lib/dither/entry_equals.h"
#include "lib/dither/entry_grid.h"
#include "tristim/dither/palette.h"

namespace tristim {
namespace {

using Color = MixPalette::Color;

// Entries of a plan: 64 gain nothing that the eye sees at 7 to 16 colours.
using Plan = std::array<int, 16>;

// The colour on its way from its nearest entry: 0 is the entry, 1 the colour.
Color weakened(const MixPalette& palette, const Color& color, float strength) noexcept {
  const Color& near = palette.entry(palette.nearest(color));
  Color between{};
  for (std::size_t c = 0; c < 3; ++c) between[c] = near[c] + strength * (color[c] - near[c]);
  return between;
}

// Of a palette of two, the colour's fraction of the way between them is known: the levels' rule of
// ordered dither, exactly.
int pair_entry(const MixPalette& palette, const Color& color, const ThresholdMatrix& matrix,
               std::uint16_t rank) noexcept {
  const int low = palette.luminance_rank(0) < palette.luminance_rank(1) ? 0 : 1;
  const Color& from = palette.entry(low);
  const Color& to = palette.entry(1 - low);
  float along = 0;
  float length2 = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    along += (color[c] - from[c]) * (to[c] - from[c]);
    length2 += (to[c] - from[c]) * (to[c] - from[c]);
  }
  const float steps = along / length2 * static_cast<float>(matrix.ranks);
  return steps + 0.5F >= static_cast<float>(rank + 1) ? 1 - low : low;
}

}  // namespace

struct PaletteOrdered::State {
  const MixPalette* palette;
  ThresholdMatrix matrix;
  detail::EntryEquals equal_entry;
  detail::EntryGrid grid;

  State(const MixPalette& p, const ThresholdMatrix& m)
      : palette(&p), matrix(m), equal_entry(p), grid(p) {}

  Plan plan(const Color& color) const noexcept;
};

Plan PaletteOrdered::State::plan(const Color& color) const noexcept {
  Plan made{};
  if (const int equal = equal_entry(color); equal >= 0) {
    made.fill(equal);
    return made;
  }
  Color owed = color;
  for (int& index : made) {
    index = grid.nearest(palette->bounded(owed));
    const Color& got = palette->entry(index);
    for (std::size_t c = 0; c < 3; ++c) owed[c] += color[c] - got[c];
  }
  std::sort(made.begin(), made.end(), [this](int a, int b) {
    return palette->luminance_rank(a) < palette->luminance_rank(b);
  });
  return made;
}

PaletteOrdered::PaletteOrdered(const MixPalette& palette, const ThresholdMatrix& matrix)
    : state_(std::make_unique<const State>(palette, matrix)) {}
PaletteOrdered::PaletteOrdered(PaletteOrdered&&) noexcept = default;
PaletteOrdered::~PaletteOrdered() = default;

void PaletteOrdered::row(int y, std::span<const float> rgb, std::span<std::uint16_t> indices,
                         std::span<const float> strength) const {
  const MixPalette& palette = *state_->palette;
  const ThresholdMatrix& matrix = state_->matrix;
  const std::uint16_t* ranks = matrix.row(y);
  const auto first = static_cast<std::size_t>(matrix.column(y));
  const std::size_t count = indices.size();
  std::array<std::vector<float>, 3> planes;
  for (auto& plane : planes) plane.resize(count);
  palette.from_light_row(rgb, {planes[0].data(), planes[1].data(), planes[2].data()});
  Color planned{-1, -1, -1};  // no colour of a picture
  Plan plan{};
  for (std::size_t x = 0; x < count; ++x) {
    const std::uint16_t rank = ranks[(first + x) % static_cast<std::size_t>(matrix.width)];
    Color color{planes[0][x], planes[1][x], planes[2][x]};
    if (!strength.empty()) color = weakened(palette, color, strength[x]);
    if (palette.size() == 2) {
      indices[x] = static_cast<std::uint16_t>(pair_entry(palette, color, matrix, rank));
      continue;
    }
    if (color != planned) {
      plan = state_->plan(color);
      planned = color;
    }
    const std::size_t at = rank * plan.size() / static_cast<std::size_t>(matrix.ranks);
    indices[x] = static_cast<std::uint16_t>(plan[at]);
  }
}

}  // namespace tristim
