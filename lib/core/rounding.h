#pragma once

#include <cmath>

#include "lib/core/double_double.h"

namespace tristim::detail {

/// The integer nearest to v, |v| < 2^40, halves up: floor(v + 1/2). What lies within 2^-60 below a
/// half counts as the half: the rounding errors of formulas whose exact value it is are smaller.
inline double round_half_up(DoubleDouble v) noexcept {
  const DoubleDouble up = v + 0.5 + 0x1p-60;
  const double below = std::floor(up.hi);
  return below == up.hi && up.lo < 0 ? below - 1 : below;
}

}  // namespace tristim::detail
