#pragma once

#include <array>

namespace tristim::detail {

/// c0 + c1 t + c2 t^2 + c3 t^3.
struct Cubic {
  std::array<double, 4> c{};

  double operator()(double t) const noexcept { return c[0] + t * (c[1] + t * (c[2] + t * c[3])); }
  double slope(double t) const noexcept { return c[1] + t * (2 * c[2] + t * (3 * c[3])); }

  /// Whether its Bernstein coefficients on [0, t] are above 0, so that it is too; false tells
  /// nothing.
  bool surely_positive(double t) const noexcept {
    return c[0] > 0 && c[0] + t * c[1] / 3 > 0 && c[0] + t * (2 * c[1] + t * c[2]) / 3 > 0 &&
           (*this)(t) > 0;
  }
};

/// Up to five places.
struct Places {
  std::array<double, 5> at{};
  int count = 0;
};

/// Where, strictly between `from` and `to` (from < to), the slope is 0 or the cubic changes sign.
Places roots_and_turns(const Cubic& cubic, double from, double to) noexcept;

/// The first t on the way at which the cubic, not below 0 at `from`, goes below 0; `to` where it
/// does not.
double first_outside(const Cubic& cubic, double from, double to) noexcept;

}  // namespace tristim::detail
