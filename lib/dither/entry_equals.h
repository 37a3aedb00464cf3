#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tristim/dither/palette.h"

namespace tristim::detail {

/// Which entry of a palette a colour is already, within MixPalette::kEqual. A grid knows the few
/// entries near each of its cells.
class EntryEquals {
 public:
  explicit EntryEquals(const MixPalette& palette);

  /// The entry that `color`, in the numbers of the mix, is; -1 where it is none.
  int operator()(const MixPalette::Color& color) const noexcept {
    const std::size_t at = cell(color);
    return start_[at] == start_[at + 1] ? -1 : search(at, color);
  }

 private:
  static constexpr int kSide = 64;
  static std::size_t number(float value) noexcept {
    const float held = value > 0 ? value : 0;
    return held < 1 ? static_cast<std::size_t>(held * kSide) : kSide - 1;
  }
  static std::size_t cell(const MixPalette::Color& color) noexcept {
    return (number(color[0]) * kSide + number(color[1])) * kSide + number(color[2]);
  }
  int search(std::size_t cell, const MixPalette::Color& color) const noexcept;

  const MixPalette* palette_;
  std::vector<std::int32_t> start_;  // by cell, of its entries
  std::vector<std::int32_t> entry_;
};

}  // namespace tristim::detail
