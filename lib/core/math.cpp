#include "lib/core/math.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace tristim::detail {
namespace {

using Dd = DoubleDouble;

// 1/1, 1/2, ... 1/N: the series' coefficients, so that no division is left in them.
template <int N>
constexpr std::array<Dd, N + 1> reciprocals() noexcept {
  std::array<Dd, N + 1> table{};
  for (int n = 1; n <= N; ++n) {
    table[static_cast<std::size_t>(n)] = Dd(1) / n;
  }
  return table;
}
constexpr auto kReciprocal = reciprocals<91>();

constexpr Dd kLn2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
constexpr Dd kInverseLn2{0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56};

// ln(m/c) = 2 atanh((m-c)/(m+c)); `terms` of the series in s^2.
Dd log_ratio(double m, double c, int terms) noexcept {
  const Dd s = Dd(m - c) / two_sum(m, c);  // m - c is exact: they are within a factor of 2
  const Dd s2 = s * s;
  Dd sum = 0;
  for (int k = terms; k >= 1; --k) {
    sum = (sum + kReciprocal[static_cast<std::size_t>(2 * k + 1)]) * s2;
  }
  return s * (1 + sum) * 2;
}

constexpr int kFirstNode = 22;  // nodes k/32 around [sqrt(1/2), sqrt(2)]
constexpr int kNodes = 25;

std::array<Dd, kNodes> log_nodes() noexcept {
  std::array<Dd, kNodes> nodes{};
  for (int i = 0; i < kNodes; ++i) {
    nodes[static_cast<std::size_t>(i)] = log_ratio((kFirstNode + i) / 32.0, 1, 45);
  }
  return nodes;
}

// ln of a finite x > 0, as exponent * ln 2 + the rest.
struct Logarithm {
  int exponent;
  Dd rest;
};

Logarithm log_parts(double x) noexcept {
  static const std::array<Dd, kNodes> nodes = log_nodes();
  int exponent = 0;
  double m = std::frexp(x, &exponent);  // [1/2, 1)
  if (m < 0x1.6a09e667f3bcdp-1) {
    m *= 2;
    --exponent;
  }
  const int node = static_cast<int>(m * 32 + 0.5);
  const Dd rest = log_ratio(m, node / 32.0, 8);
  return {exponent, nodes[static_cast<std::size_t>(node - kFirstNode)] + rest};
}

// 2^y for |y| < 1100; a subnormal result is rounded twice.
Dd exp2_finite(Dd y) noexcept {
  const double n = std::nearbyint(y.hi);
  Dd r = (y - n) * kLn2;
  constexpr int kHalvings = 5;
  r = {r.hi / (1 << kHalvings), r.lo / (1 << kHalvings)};
  Dd sum = 1;
  for (std::size_t k = 14; k >= 1; --k) sum = 1 + r * sum * kReciprocal[k];
  for (int k = 0; k < kHalvings; ++k) sum = sum * sum;
  const int exponent = static_cast<int>(n);
  const double hi = std::ldexp(sum.hi + sum.lo, exponent);
  return {hi, std::isfinite(hi) ? std::ldexp(sum.lo, exponent) : 0};
}

bool odd_integer(double y) noexcept {
  return std::fabs(y) < 0x1p53 && y == std::trunc(y) && std::fmod(y, 2) != 0;
}

double pow_positive(double x, double y) noexcept {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (x == 1) return 1;
  if (x == 0 || x == kInfinity) return (x == 0) == (y > 0) ? 0 : kInfinity;
  if (std::fabs(y) == kInfinity) return (x > 1) == (y > 0) ? kInfinity : 0;
  return pow_precise(x, y).hi;
}

}  // namespace

DoubleDouble log2_precise(DoubleDouble x) noexcept {
  const Logarithm parts = log_parts(x.hi);
  const double u = x.lo / x.hi;  // ln(1 + u) is u - u^2/2, and the next term below 2^-160
  return parts.exponent + (parts.rest + (u - u * u / 2)) * kInverseLn2;
}

DoubleDouble log_precise(DoubleDouble x) noexcept { return log2_precise(x) * kLn2; }

DoubleDouble exp2_precise(DoubleDouble y) noexcept {
  if (y.hi >= 1025) return std::numeric_limits<double>::infinity();
  if (y.hi <= -1080) return 0;
  return exp2_finite(y);
}

DoubleDouble exp_precise(DoubleDouble y) noexcept {
  if (std::fabs(y.hi) > 800) return exp2_precise(y.hi);  // no number, whichever base
  return exp2_precise(y * kInverseLn2);
}

DoubleDouble pow_precise(DoubleDouble x, DoubleDouble y) noexcept {
  const Dd log2 = log2_precise(x);
  if (std::fabs(log2.hi * y.hi) > 1100) return exp2_precise(log2.hi * y.hi);
  return exp2_precise(log2 * y);
}

double pow(double x, double y) noexcept {
  if (y == 0 || x == 1) return 1;
  if (std::isnan(x) || std::isnan(y)) return x + y;
  if (x > 0 || (x == 0 && !std::signbit(x))) return pow_positive(x, y);
  if (x == 0 || y == std::trunc(y)) {
    const double magnitude = pow_positive(-x, y);
    return odd_integer(y) ? -magnitude : magnitude;
  }
  if (std::isinf(x)) return y > 0 ? -x : 0;
  return std::numeric_limits<double>::quiet_NaN();
}

double cbrt(double x) noexcept {
  if (x == 0 || !std::isfinite(x)) return x;
  int exponent = 0;
  double m = std::frexp(std::fabs(x), &exponent);  // [1/2, 1)
  const int shift = ((exponent % 3) + 3) % 3;      // make the exponent a multiple of 3
  if (shift != 0) {
    m = std::ldexp(m, shift - 3);  // [1/8, 1/2)
    exponent += 3 - shift;
  }
  double t = 0.3536 + m * (1.0136 - m * 0.3717);  // within 3 % on [1/8, 1)
  for (int i = 0; i < 2; ++i) {
    const double t3 = t * t * t;
    t *= (t3 + 2 * m) / (2 * t3 + m);  // Halley: the error's cube
  }
  // One Newton step with the residual m - t^3 to twice the precision.
  const Dd square = two_product(t, t);
  const Dd cube = square * t;
  t += (((m - cube.hi) - cube.lo)) / (3 * square.hi);
  t = std::ldexp(t, exponent / 3);
  return x < 0 ? -t : t;
}

DoubleDouble cube_root(DoubleDouble x) noexcept {
  const double t = cbrt(x.hi);  // one Newton step doubles its digits
  const Dd rest = subtract(x, multiply(two_product(t, t), t));
  return quick_two_sum(t, rest.hi / (3 * t * t));
}

double exp(double x) noexcept {
  if (std::isnan(x)) return x;
  return exp_precise(x).hi;
}

double log(double x) noexcept {
  if (std::isnan(x) || x < 0) return std::numeric_limits<double>::quiet_NaN();
  if (x == 0) return -std::numeric_limits<double>::infinity();
  if (std::isinf(x)) return x;
  const Logarithm parts = log_parts(x);
  return (kLn2 * parts.exponent + parts.rest).hi;
}

}  // namespace tristim::detail
