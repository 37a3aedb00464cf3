#include "lib/core/trigonometry.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace tristim::detail {
namespace {

using Dd = DoubleDouble;

constexpr Dd kRadiansPerDegree{0x1.1df46a2529d39p-6, 0x1.5c1d8becdd291p-62};
constexpr Dd kDegreesPerRadian{0x1.ca5dc1a63c1f8p+5, -0x1.1e7ab456405f9p-49};

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

// arctan x for |x| <= 1/64: x - x^3/3 + x^5/5 ...
Dd arctangent_series(Dd x) noexcept {
  const Dd x2 = multiply(x, x);
  Dd sum{0, 0};
  for (int n = 19; n >= 3; n -= 2)
    sum = multiply(subtract(divide({1, 0}, {double(n), 0}), sum), x2);
  return multiply(x, subtract({1, 0}, sum));
}

constexpr int kNodes = 32;

// arctan(k/32), each from the one before: arctan a = arctan b + arctan((a - b)/(1 + ab)).
std::array<Dd, kNodes + 1> arctangent_nodes() noexcept {
  std::array<Dd, kNodes + 1> nodes{};
  for (std::size_t k = 1; k <= kNodes; ++k) {
    const double a = double(k) / kNodes;
    const double b = double(k - 1) / kNodes;
    const double middle = (a + b) / 2;  // half steps, so that the series' argument is small enough
    const Dd low = divide({middle - b, 0}, {1 + middle * b, 0});
    const Dd high = divide({a - middle, 0}, {1 + a * middle, 0});
    nodes[k] = add(nodes[k - 1], add(arctangent_series(low), arctangent_series(high)));
  }
  return nodes;
}

// arctan(y/x) in degrees for 0 <= y <= x, x > 0, both in the middle of the range of doubles.
Dd octant_deg(double y, double x) noexcept {
  static const std::array<Dd, kNodes + 1> nodes = arctangent_nodes();
  const double node = std::nearbyint(y / x * kNodes);
  const Dd c{node / kNodes, 0};
  // arctan(y/x) = arctan c + arctan((y - cx)/(x + cy))
  const Dd rise = subtract({y, 0}, multiply(c, x));
  const Dd run = add({x, 0}, multiply(c, y));
  const Dd radians =
      add(nodes[static_cast<std::size_t>(node)], arctangent_series(divide(rise, run)));
  return multiply(radians, kDegreesPerRadian);
}

// The angle of a vector of the first quadrant that is not 0.
Dd quadrant_deg(double y, double x) noexcept {
  if (std::isinf(x) && std::isinf(y)) return {45, 0};
  if (std::isinf(x) || std::isinf(y)) return {std::isinf(y) ? 90.0 : 0.0, 0};
  int exponent = 0;
  (void)std::frexp(std::fmax(x, y), &exponent);
  x = std::ldexp(x, -exponent);  // products of subnormal numbers would lose their digits
  y = std::ldexp(y, -exponent);
  return y <= x ? octant_deg(y, x) : subtract({90, 0}, octant_deg(x, y));
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
