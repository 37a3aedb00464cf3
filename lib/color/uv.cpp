#include "tristim/color/uv.h"

#include <limits>

#include "lib/core/double_double.h"

namespace tristim {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// The sum of three numbers, rounded once.
double sum3(double a, double b, double c) noexcept {
  return detail::add(detail::two_sum(a, b), {c, 0}).value();
}

}  // namespace

Uv xyz_to_uv(Xyz xyz) noexcept {
  const double sum = sum3(xyz.x, 15 * xyz.y, 3 * xyz.z);
  if (sum == 0) return {kNone, kNone, xyz.y};
  return {4 * xyz.x / sum, 6 * xyz.y / sum, xyz.y};
}

Xyz uv_to_xyz(Uv uv) noexcept {
  if (uv.luminance == 0) return {};
  const double scale = uv.luminance / (2 * uv.v);
  return {3 * uv.u * scale, uv.luminance, sum3(4, -uv.u, -10 * uv.v) * scale};
}

UvPrime xyz_to_uv_prime(Xyz xyz) noexcept {
  const double sum = sum3(xyz.x, 15 * xyz.y, 3 * xyz.z);
  if (sum == 0) return {kNone, kNone, xyz.y};
  return {4 * xyz.x / sum, 9 * xyz.y / sum, xyz.y};
}

Xyz uv_prime_to_xyz(UvPrime uv) noexcept {
  if (uv.luminance == 0) return {};
  const double scale = uv.luminance / (4 * uv.v);
  return {9 * uv.u * scale, uv.luminance, sum3(12, -3 * uv.u, -20 * uv.v) * scale};
}

}  // namespace tristim
