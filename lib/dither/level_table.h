#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lib/dither/step_table.h"

namespace tristim::detail {

/// Levels as the fast rows look them up. Few are compared one by one, of many tables tell how many
/// are below a light.
struct LevelTable {
  /// Levels ascend; `threshold[i]` is the smallest light that takes level i + 1.
  LevelTable(std::span<const float> light, std::span<const float> threshold,
             std::span<const std::uint16_t> code);

  /// Whether the fast rows can take these levels: none of many is below 0.
  bool usable() const noexcept { return few() || (nearest && below); }
  bool few() const noexcept { return light.size() <= kFew; }

  static constexpr std::size_t kFew = 8;

  std::vector<float> light;
  std::vector<float> threshold;
  std::vector<std::int32_t> code;

  std::optional<StepTable> nearest;  // the level that a light takes
  std::optional<StepTable> below;    // the level below a light that lies between two
};

}  // namespace tristim::detail
