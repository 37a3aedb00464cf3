#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "lib/dither/entry_equals.h"
#include "lib/dither/entry_grid.h"
#include "tristim/dither/palette.h"

namespace tristim::detail {

/// Plans of entries whose mean is a colour: each is the nearest to what the ones before it still
/// owe; sorted by luminance, a threshold picks one [Knoll08]. For palettes too large for Mixtures.
class EntryPlans {
 public:
  explicit EntryPlans(const MixPalette& palette)
      : palette_(&palette), equal_entry_(palette), grid_(palette) {}

  /// As Mixtures does.
  void entry_row(const std::array<const float*, 3>& planes, const float* thresholds,
                 std::span<std::uint16_t> indices) const noexcept;

 private:
  using Plan = std::array<int, 16>;
  Plan plan(const MixPalette::Color& color) const noexcept;

  const MixPalette* palette_;
  EntryEquals equal_entry_;
  EntryGrid grid_;
};

}  // namespace tristim::detail
