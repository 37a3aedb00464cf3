#include "lib/dither/entry_plans.h"

#include <algorithm>
#include <cstddef>

namespace tristim::detail {

EntryPlans::Plan EntryPlans::plan(const MixPalette::Color& color) const noexcept {
  Plan made{};
  if (const int equal = equal_entry_(color); equal >= 0) {
    made.fill(equal);
    return made;
  }
  MixPalette::Color owed = color;
  for (int& index : made) {
    index = grid_.nearest(palette_->bounded(owed));
    const MixPalette::Color& got = palette_->entry(index);
    for (std::size_t c = 0; c < 3; ++c) owed[c] += color[c] - got[c];
  }
  std::sort(made.begin(), made.end(), [this](int a, int b) {
    return palette_->luminance_rank(a) > palette_->luminance_rank(b);
  });
  return made;
}

void EntryPlans::entry_row(const std::array<const float*, 3>& planes, const float* thresholds,
                           std::span<std::uint16_t> indices) const noexcept {
  MixPalette::Color planned{-1, -1, -1};  // no colour of a picture
  Plan current{};
  for (std::size_t x = 0; x < indices.size(); ++x) {
    const MixPalette::Color color{planes[0][x], planes[1][x], planes[2][x]};
    if (color != planned) {
      current = plan(color);
      planned = color;
    }
    const float at = thresholds[x] * static_cast<float>(current.size());
    indices[x] = static_cast<std::uint16_t>(current[static_cast<std::size_t>(at)]);
  }
}

}  // namespace tristim::detail
