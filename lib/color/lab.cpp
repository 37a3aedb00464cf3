#include "tristim/color/lab.h"

#include <cmath>

#include "lib/color/cie1976.h"
#include "lib/core/math.h"

namespace tristim {
namespace {

using detail::kCieEpsilon;
using detail::kCieKappa;

double f(double t) noexcept {
  return t > kCieEpsilon ? detail::cbrt(t) : (kCieKappa * t + 16) / 116;
}

double f_inverse(double v) noexcept {
  const double cube = v * v * v;
  return cube > kCieEpsilon ? cube : (116 * v - 16) / kCieKappa;
}

Lab lab_of(const detail::RelativeXyz& xyz) noexcept {
  const detail::DoubleDouble y = xyz.ratio(1);
  const detail::DoubleDouble fy = detail::cie_f(y);
  const auto times = [](double factor, detail::DoubleDouble a, detail::DoubleDouble b) {
    return detail::multiply(detail::subtract(a, b), factor).value();
  };
  return {detail::cie_lightness(y).value(), times(500, detail::cie_f(xyz.ratio(0)), fy),
          times(200, fy, detail::cie_f(xyz.ratio(2)))};
}

// For numbers without end, and so large that their products have none.
Lab immoderate_lab(double x, double y, double z) noexcept {
  return {116 * f(y) - 16, 500 * (f(x) - f(y)), 200 * (f(y) - f(z))};
}

}  // namespace

Lab xyz_to_lab(Xyz xyz, Xyz white) noexcept {
  if (detail::is_moderate(xyz.x, xyz.y, xyz.z)) return lab_of(detail::relative_xyz(xyz, white));
  return immoderate_lab(xyz.x / white.x, xyz.y / white.y, xyz.z / white.z);
}

Xyz lab_to_xyz(Lab lab, Xyz white) noexcept {
  const double fy = (lab.l + 16) / 116;
  return {white.x * f_inverse(fy + lab.a / 500), white.y * luminance_from_lstar(lab.l),
          white.z * f_inverse(fy - lab.b / 200)};
}

double lstar_from_luminance(double y) noexcept {
  if (detail::is_moderate(y, y, y)) return detail::cie_lightness({y, 0}).value();
  return 116 * f(y) - 16;
}

double luminance_from_lstar(double lstar) noexcept {
  const double fy = (lstar + 16) / 116;
  return lstar > 8 ? fy * fy * fy : lstar / kCieKappa;
}

Lab rgb_to_lab(Rgb rgb, const Eigen::Matrix3d& matrix) noexcept {
  if (detail::is_moderate(rgb.r, rgb.g, rgb.b)) return lab_of(detail::relative_xyz(rgb, matrix));
  const Eigen::Vector3d white = matrix.rowwise().sum();
  const Eigen::Vector3d xyz = matrix * Eigen::Vector3d(rgb.r, rgb.g, rgb.b);
  return immoderate_lab(xyz.x() / white.x(), xyz.y() / white.y(), xyz.z() / white.z());
}

Rgb lab_to_rgb(Lab lab, Xyz white, const Eigen::Matrix3d& matrix) noexcept {
  // RGB = Y/Yw (1, 1, 1) + M (X - Xw Y/Yw, 0, Z - Zw Y/Yw), as M takes the white to (1, 1, 1).
  const double fy = (lab.l + 16) / 116;
  const double y = luminance_from_lstar(lab.l);
  const double x = lab.a == 0 ? 0 : white.x * (f_inverse(fy + lab.a / 500) - y);
  const double z = lab.b == 0 ? 0 : white.z * (f_inverse(fy - lab.b / 200) - y);
  return detail::off_grey(y, x, z, matrix);
}

}  // namespace tristim
