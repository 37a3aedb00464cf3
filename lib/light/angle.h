#pragma once

#include "lib/core/arctangent.h"
#include "lib/light/precise.h"

namespace tristim::detail {

/// The angle between two vectors in radians, [0, pi]; 0 where either is 0.
inline DoubleDouble angle_between(const PreciseVector& a, const PreciseVector& b) noexcept {
  return arctangent(length(cross(a, b)), dot(a, b));
}

}  // namespace tristim::detail
