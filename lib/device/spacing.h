#pragma once

#include "lib/core/double_double.h"
#include "tristim/device/levels.h"

namespace tristim::detail {

/// The quantity of which a spacing's steps are equal, and the intensity of one of its values.
struct SpacingCurve {
  DoubleDouble (*position)(DoubleDouble intensity, const LevelTable& table) noexcept;
  DoubleDouble (*intensity)(DoubleDouble position, const LevelTable& table) noexcept;
};

/// A table whose figures were found good, and where its levels begin and end.
class LevelPositions {
 public:
  /// Keeps a reference to `table`. Throws as intensity_levels does.
  explicit LevelPositions(const LevelTable& table);

  /// I_j, 0 <= j <= n, to about 90 bits.
  DoubleDouble intensity(int j) const noexcept;

  /// See level_position, of an intensity above 0.
  DoubleDouble position(double intensity) const noexcept;

  /// See nearest_level; not NaN.
  int nearest(double intensity) const noexcept;

 private:
  const LevelTable& table_;
  const SpacingCurve& curve_;
  DoubleDouble low_, high_;  // positions of level 0 and of level n
};

}  // namespace tristim::detail
