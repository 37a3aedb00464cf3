#pragma once

#include "lib/core/double_double.h"

namespace tristim::detail {

// The C library's pow, exp, log and cbrt differ between processors in the last bit. These use
// nothing but IEEE addition, multiplication, division and square root in a fixed order, so that
// what they compute is the same everywhere.

/// x^y, correctly rounded but for results within 1e-9 ulp of a tie; subnormal results are rounded
/// twice, within .75 ulp. Follows the C standard at the edges: x < 0 gives NaN unless y is an
/// integer, x^0 is 1, NaN passes.
double pow(double x, double y) noexcept;

/// Logarithms of a finite x > 0 to about 95 bits.
DoubleDouble log2_precise(DoubleDouble x) noexcept;
DoubleDouble log_precise(DoubleDouble x) noexcept;

/// 2^y, e^y of a finite y and x^y of finite x > 0 and y, to about 95 bits less those of the
/// result's exponent; +inf where they overflow.
DoubleDouble exp2_precise(DoubleDouble y) noexcept;
DoubleDouble exp_precise(DoubleDouble y) noexcept;
DoubleDouble pow_precise(DoubleDouble x, DoubleDouble y) noexcept;

/// Cube root, odd; maximum error 1 ulp.
double cbrt(double x) noexcept;

/// Cube root of 1e-100 < x < 1e100 to about 100 bits.
DoubleDouble cube_root(DoubleDouble x) noexcept;

/// e^x and ln x through pow's kernels; maximum error 1 ulp.
double exp(double x) noexcept;
double log(double x) noexcept;

/// The smallest float at which the monotone non-decreasing `reaches` holds, looked for from `guess`
/// on; +inf where no finite float reaches it. `reaches` takes a double that is exactly a float.
template <typename Predicate>
float first_float(double guess, Predicate&& reaches);

}  // namespace tristim::detail

#include <cmath>
#include <limits>

namespace tristim::detail {

template <typename Predicate>
float first_float(double guess, Predicate&& reaches) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  float x = static_cast<float>(guess);
  if (!(std::fabs(x) < kInfinity)) x = 0;
  // Gallop away from the guess until it is bracketed, then halve: guesses are mostly one float off.
  float low = x;
  float high = x;
  for (float step = std::nextafter(std::fabs(x), kInfinity) - std::fabs(x); reaches(double{low});
       step *= 2) {
    high = low;
    low -= step;
    if (!(low > -kInfinity)) return low;
  }
  for (float step = std::nextafter(std::fabs(x), kInfinity) - std::fabs(x); !reaches(double{high});
       step *= 2) {
    low = high;
    high += step;
    if (!(high < kInfinity)) return kInfinity;
  }
  while (std::nextafter(low, kInfinity) < high) {
    const float middle = static_cast<float>((double{low} + double{high}) / 2);
    const float inside = middle <= low ? std::nextafter(low, kInfinity) : middle;
    (reaches(double{inside}) ? high : low) = inside;
  }
  return high;
}

}  // namespace tristim::detail
