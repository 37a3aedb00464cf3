#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "tristim/image/view.h"

namespace tristim::detail {

/// Levels as the fast rows look them up. Few are compared one by one; of many, the leading bits of
/// a light tell which two levels it lies between.
struct LevelTable {
  /// Levels ascend; `threshold[i]` is the smallest light that takes level i + 1.
  LevelTable(std::span<const float> light, std::span<const float> threshold,
             std::span<const std::uint16_t> code);

  /// Whether the fast rows can take these levels: not thousands of them, none below 0.
  bool usable() const noexcept { return !light.empty(); }
  bool few() const noexcept { return pair.empty(); }

  static constexpr std::size_t kFew = 8;

  std::vector<float> light;
  std::vector<float> threshold;
  std::vector<std::int32_t> code;

  int shift = 0;                           // bits of a light that do not tell its bin
  std::int32_t first = 0, last = 0;        // bins: the leading bits
  std::vector<std::array<float, 2>> pair;  // by bin: the levels below and above its half way
  std::vector<std::int32_t> codes;         // by bin: theirs, the lower one in the lower 16 bits
};

/// Floyd-Steinberg of rows of one channel that follow each other, from left to right, as
/// LevelDiffusion defines it, bit for bit.
///
/// Lane l of a vector works on row l, two pixels behind lane l - 1: what a pixel receives is known
/// when it is its turn. `errors` are those of the row above the first, between two that are 0, and
/// become those of the last row.
struct FloydSteinbergRows {
  std::string_view name;  // instruction set
  void (*run)(const LevelTable& levels, ImageView<const float> in, ImageView<std::uint16_t> out,
              std::span<float> errors);
};

/// Those that this processor has, the best first; none where there are no vectors.
std::span<const FloydSteinbergRows> all_floyd_steinberg_rows();

/// The best, or the one that TRISTIM_SIMD names; nullptr: the definition is to be taken.
const FloydSteinbergRows* floyd_steinberg_rows();

}  // namespace tristim::detail
