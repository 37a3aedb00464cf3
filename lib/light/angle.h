#pragma once

#include "lib/light/precise.h"

namespace tristim::detail {

inline constexpr DoubleDouble kPi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
inline constexpr DoubleDouble kRadiansPerDegree = kPi / 180;
inline constexpr DoubleDouble kDegreesPerRadian = DoubleDouble(180) / kPi;

/// The angle of the vector (x, y), y >= 0, to the x axis in radians, [0, pi], to about 100 bits; 0
/// for (0, 0).
DoubleDouble arc_tangent(DoubleDouble y, DoubleDouble x) noexcept;

/// The angle between two vectors in radians, [0, pi]; 0 where either is 0.
inline DoubleDouble angle_between(const PreciseVector& a, const PreciseVector& b) noexcept {
  return arc_tangent(length(cross(a, b)), dot(a, b));
}

}  // namespace tristim::detail
