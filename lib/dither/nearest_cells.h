#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tristim/dither/palette.h"

namespace tristim::detail {

/// Which cell of a grid over the colours of a mix, -2 to 3 in each number, holds a colour: about
/// square roots apart, as the eye sees light.
class ColorGrid {
 public:
  static constexpr int kBits = 6;  // of a number
  static constexpr std::size_t kCells = std::size_t{1} << (3 * kBits);
  static constexpr float kLow = -2, kHigh = 3;

  ColorGrid();

  std::size_t cell(const MixPalette::Color& color) const noexcept {
    return (std::size_t{number(color[0])} << (2 * kBits)) |
           (std::size_t{number(color[1])} << kBits) | number(color[2]);
  }

  MixPalette::Color middle(std::size_t cell) const noexcept { return of_numbers(middle_, cell); }

  /// Half of the cell's width in each number.
  MixPalette::Color reach(std::size_t cell) const noexcept { return of_numbers(reach_, cell); }

 private:
  static constexpr float kStepsPerUnit = 1024;
  static constexpr std::size_t kSteps = static_cast<std::size_t>((kHigh - kLow) * kStepsPerUnit);
  using Numbers = std::array<float, std::size_t{1} << kBits>;

  // NaN counts as the lowest.
  std::uint8_t number(float value) const noexcept {
    if (!(value > kLow)) return 0;
    if (value >= kHigh) return number_.back();
    return number_[static_cast<std::size_t>((value - kLow) * kStepsPerUnit)];
  }
  static MixPalette::Color of_numbers(const Numbers& numbers, std::size_t cell) noexcept {
    constexpr std::size_t kMask = (std::size_t{1} << kBits) - 1;
    return {numbers[cell >> (2 * kBits)], numbers[(cell >> kBits) & kMask], numbers[cell & kMask]};
  }

  std::array<std::uint8_t, kSteps> number_{};
  Numbers middle_{}, reach_{};
};

/// The nearest entry of a palette, by the metric's tangents in the cells of a grid: a cell knows
/// the entries that can be nearest in it, found when it is first asked for. Not for several
/// threads.
class NearestCells {
 public:
  explicit NearestCells(const MixPalette& palette);

  int nearest(const MixPalette::Color& color);

  /// The entry that `color` is already; -1 where it is none.
  int equal_entry(const MixPalette::Color& color) {
    return holds_entry_[grid_.cell(color)] ? equal_candidate(color) : -1;
  }

 private:
  // |place(color) - place(entry)|^2 without what all entries share: slope . color + height.
  struct Candidate {
    std::array<float, 3> slope;
    float height;
    std::int32_t entry;
  };
  struct Cell {
    std::uint32_t first = 0;
    std::uint32_t count = 0;  // of candidates; 0: not known yet
  };
  std::span<const Candidate> candidates(std::size_t cell);
  int equal_candidate(const MixPalette::Color& color);
  void fill(std::size_t cell);

  const MixPalette* palette_;
  ColorGrid grid_;
  std::vector<std::array<float, 3>> place_;  // of the entries
  std::vector<Cell> cells_;
  std::vector<Candidate> candidates_;
  std::vector<bool> holds_entry_;  // or one within rounding
};

}  // namespace tristim::detail
