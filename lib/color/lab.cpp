#include "tristim/color/lab.h"

#include "lib/core/math.h"

namespace tristim {
namespace {

constexpr double kEpsilon = 216.0 / 24389;  // exact [CIE15 note to 8.2.1]
constexpr double kKappa = 24389.0 / 27;

double f(double t) noexcept { return t > kEpsilon ? detail::cbrt(t) : (kKappa * t + 16) / 116; }

double f_inverse(double v) noexcept {
  const double cube = v * v * v;
  return cube > kEpsilon ? cube : (116 * v - 16) / kKappa;
}

Lab lab_of_ratios(double x, double y, double z) noexcept {
  const double fy = f(y);
  return {116 * fy - 16, 500 * (f(x) - fy), 200 * (fy - f(z))};
}

}  // namespace

Lab xyz_to_lab(Xyz xyz, Xyz white) noexcept {
  return lab_of_ratios(xyz.x / white.x, xyz.y / white.y, xyz.z / white.z);
}

Xyz lab_to_xyz(Lab lab, Xyz white) noexcept {
  const double fy = (lab.l + 16) / 116;
  return {white.x * f_inverse(fy + lab.a / 500), white.y * luminance_from_lstar(lab.l),
          white.z * f_inverse(fy - lab.b / 200)};
}

Luv xyz_to_luv(Xyz xyz, Xyz white) noexcept {
  const double l = lstar_from_luminance(xyz.y / white.y);
  const double sum = xyz.x + 15 * xyz.y + 3 * xyz.z;
  if (sum == 0) return {l, 0, 0};
  const double white_sum = white.x + 15 * white.y + 3 * white.z;
  return {l, 13 * l * (4 * xyz.x / sum - 4 * white.x / white_sum),
          13 * l * (9 * xyz.y / sum - 9 * white.y / white_sum)};
}

double lstar_from_luminance(double y) noexcept { return 116 * f(y) - 16; }

double luminance_from_lstar(double lstar) noexcept {
  const double fy = (lstar + 16) / 116;
  return lstar > 8 ? fy * fy * fy : lstar / kKappa;
}

Lab rgb_to_lab(Rgb rgb, const Eigen::Matrix3d& matrix) noexcept {
  // X/Xw = G + (Mr (R - G) + Mb (B - G))/Xw, with Xw the sum of the row: a grey leaves G alone,
  // exactly.
  const double red = rgb.r - rgb.g;
  const double blue = rgb.b - rgb.g;
  const auto ratio = [&](int row) {
    const double white = matrix(row, 0) + matrix(row, 1) + matrix(row, 2);
    return rgb.g + (matrix(row, 0) * red + matrix(row, 2) * blue) / white;
  };
  return lab_of_ratios(ratio(0), ratio(1), ratio(2));
}

}  // namespace tristim
