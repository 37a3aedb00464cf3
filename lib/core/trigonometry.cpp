#include "lib/core/trigonometry.h"

#include <cmath>
#include <limits>

#include "lib/core/arctangent.h"

namespace tristim::detail {
namespace {

using Dd = DoubleDouble;

// Sine (first = x, from = 2) or cosine (first = 1, from = 1) by its Taylor series.
Dd series(Dd first, Dd x2, int from) noexcept {
  constexpr double kNegligible = 0x1p-110;
  Dd term = first;
  Dd sum = first;
  for (int n = from; std::fabs(term.hi) > kNegligible * std::fabs(sum.hi); n += 2) {
    term = divide(multiply(term, negate(x2)), {double(n) * (n + 1), 0});
    sum = add(sum, term);
  }
  return sum;
}

// The angle of a vector of the first quadrant that is not 0.
Dd quadrant_deg(double y, double x) noexcept {
  if (std::isinf(x) && std::isinf(y)) return {45, 0};
  if (std::isinf(x) || std::isinf(y)) return {std::isinf(y) ? 90.0 : 0.0, 0};
  int exponent = 0;
  (void)std::frexp(std::fmax(x, y), &exponent);
  x = std::ldexp(x, -exponent);  // products of subnormal numbers would lose their digits
  y = std::ldexp(y, -exponent);
  return arctangent(y, x) * kDegreesPerRadian;
}

}  // namespace

PreciseSineCosine precise_sine_cosine_deg(double degrees) noexcept {
  if (!std::isfinite(degrees)) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    return {{kNone, 0}, {kNone, 0}};
  }
  const double turn = std::fmod(degrees, 360);  // exact
  const double quarter = std::nearbyint(turn / 90);
  const Dd x = multiply(kRadiansPerDegree, turn - 90 * quarter);  // the difference is exact
  const Dd x2 = multiply(x, x);
  const Dd sine = series(x, x2, 2);
  const Dd cosine = series({1, 0}, x2, 1);
  switch (static_cast<int>(quarter) & 3) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, negate(sine)};
    case 2:
      return {negate(sine), negate(cosine)};
    default:
      return {negate(cosine), sine};
  }
}

SineCosine sine_cosine_deg(double degrees) noexcept {
  const PreciseSineCosine precise = precise_sine_cosine_deg(degrees);
  return {precise.sine.value() + 0.0, precise.cosine.value() + 0.0};  // -0 becomes 0
}

double angle_deg(double y, double x) noexcept {
  if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<double>::quiet_NaN();
  if (x == 0 && y == 0) return 0;
  Dd angle = quadrant_deg(std::fabs(y), std::fabs(x));
  if (x < 0) angle = subtract({180, 0}, angle);
  if (y < 0) angle = subtract({360, 0}, angle);
  const double rounded = angle.value();
  return rounded >= 360 ? 0 : rounded;
}

double hypotenuse(double x, double y) noexcept {
  if (std::isinf(x) || std::isinf(y)) return std::numeric_limits<double>::infinity();
  int exponent = 0;
  (void)std::frexp(std::fmax(std::fabs(x), std::fabs(y)), &exponent);
  x = std::ldexp(x, -exponent);
  y = std::ldexp(y, -exponent);
  const Dd root = square_root(add(two_product(x, x), two_product(y, y)));
  return std::ldexp(root.value(), exponent);
}

}  // namespace tristim::detail
