#pragma once

#include <cmath>

namespace tristim::detail {

/// Sine of an angle in radians, for orders and shapes: within 2e-15 up to 1e5, the same bits
/// everywhere, many times faster than lib/core/trigonometry.h. NaN where it is not finite.
inline double sine(double radians) noexcept {
  constexpr double kPiHigh = 0x1.921fb544p+1;  // 33 bits: products with a count of turns are exact
  constexpr double kPiLow = 0x1.0b4611a626331p-33;
  const double turns = std::floor(radians / (kPiHigh + kPiLow) + 0.5);  // half turns
  const double r = (radians - turns * kPiHigh) - turns * kPiLow;        // [-pi/2, pi/2]
  const double r2 = r * r;
  double sum = 0;
  for (int n = 21; n >= 3; n -= 2) sum = (-1 - sum) * r2 / (n * (n - 1));  // Taylor
  const double value = r + r * sum;
  return std::fmod(turns, 2) == 0 ? value : -value;
}

inline double cosine(double radians) noexcept {
  // Even to the last bit: what lies alike on both sides of a centre gets one value.
  constexpr double kHalfPi = 0x1.921fb54442d18p+0;
  return sine(kHalfPi - std::fabs(radians));
}

}  // namespace tristim::detail
