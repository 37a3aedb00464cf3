#pragma once

#include <array>
#include <optional>

#include "tristim/lut/bake.h"
#include "tristim/lut/invert.h"

namespace tristim::detail {

/// The way between inputs and the unit cube that a grid's shaper makes of them.
class GridPoints {
 public:
  /// Throws std::invalid_argument where the shaper has no inverse or is a cube or a matrix.
  explicit GridPoints(const BakeGrid& grid);

  /// The input at (r, g, b), each [0, 1].
  Rgb input(Rgb at) const noexcept;

  /// Where an input lies, each [0, 1].
  Rgb place(Rgb input) const noexcept;

 private:
  LutRange range_;
  std::optional<LutStep> shaper_, inverse_;
};

/// What bake_error compares at.
std::vector<Rgb> many_inputs(const GridPoints& points, const LutRange& range);

/// `count` of the same kind by chance alone.
std::vector<Rgb> chance_inputs(const GridPoints& points, const LutRange& range, std::size_t count);

std::vector<Rgb> grey_inputs(const GridPoints& points, std::size_t count);

}  // namespace tristim::detail
