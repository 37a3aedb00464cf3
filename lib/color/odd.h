#pragma once

#include <cmath>
#include <limits>

namespace tristim::detail {

/// sign(x) f(|x|) of a finite x; infinities and NaN stay.
template <typename F>
double odd(double x, F&& f) noexcept {
  const double magnitude = std::fabs(x);
  if (!(magnitude < std::numeric_limits<double>::infinity())) return x;
  return std::copysign(f(magnitude), x);
}

}  // namespace tristim::detail
