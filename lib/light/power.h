#pragma once

#include <algorithm>

#include "lib/core/math.h"

namespace tristim::detail {

/// x^n for n >= 0 by repeated squaring: a twentieth of pow's time. Relative error below n 2^-53, no
/// more than what a rounding of x does to x^n; n 2^-102 of a DoubleDouble.
template <typename Number>
Number integer_power(Number x, int n) noexcept {
  Number power = 1;
  for (; n > 0; n /= 2) {
    if (n % 2 != 0) power = power * x;
    x = x * x;
  }
  return power;
}

/// cosine^n where the cosine is positive, else 0, so that n = 0 gives 1 inside the lobe and 0
/// outside. Rounded once, whatever n >= 0 is; beyond 2, which is no cosine, it may overflow.
inline double lobe_power(DoubleDouble cosine, double n) noexcept {
  constexpr double kLargestSquared = 4096;  // beyond that pow is as fast
  if (!(cosine.hi > 0)) return 0;
  if (cosine.hi > 2) return pow(cosine.hi, n);
  if (n >= 0 && n <= kLargestSquared && n == static_cast<int>(n)) {
    return integer_power(cosine, static_cast<int>(n)).hi;
  }
  constexpr double kLargest = 1e290;  // where every cosine but 1 has vanished long ago
  return pow_precise(cosine, std::min(n, kLargest)).hi;
}

}  // namespace tristim::detail
