#include "tristim/color/xyz.h"

#include <limits>

#include "lib/color/exact_matrix.h"

namespace tristim {
namespace {

// The sum of three numbers, rounded once.
double sum3(double a, double b, double c) noexcept {
  return detail::add(detail::two_sum(a, b), {c, 0}).value();
}

}  // namespace

Xyy xyz_to_xyy(Xyz xyz) noexcept {
  const double sum = sum3(xyz.x, xyz.y, xyz.z);
  if (sum == 0) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    return {kNone, kNone, xyz.y};
  }
  return {xyz.x / sum, xyz.y / sum, xyz.y};
}

Xyz xyy_to_xyz(Xyy xyy) noexcept {
  if (xyy.luminance == 0) return {};
  return {xyy.x * xyy.luminance / xyy.y, xyy.luminance,
          sum3(1, -xyy.x, -xyy.y) * xyy.luminance / xyy.y};
}

Xyz white_xyz(Chromaticity white) noexcept {
  const detail::ExactVector exact = detail::exact_white(white);
  return {exact[0].hi, exact[1].hi, exact[2].hi};
}

}  // namespace tristim
