#pragma once

#include "lib/core/double_double.h"

namespace tristim::detail {

inline constexpr DoubleDouble kPi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
inline constexpr DoubleDouble kRadiansPerDegree = kPi / 180;
inline constexpr DoubleDouble kDegreesPerRadian = DoubleDouble(180) / kPi;

/// The angle of the vector (x, y), y >= 0, to the x axis in radians, [0, pi], to about 100 bits; 0
/// for (0, 0).
DoubleDouble arctangent(DoubleDouble y, DoubleDouble x) noexcept;

}  // namespace tristim::detail
