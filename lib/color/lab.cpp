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

double luv_sum(Xyz xyz) noexcept { return xyz.x + 15 * xyz.y + 3 * xyz.z; }

// u' - u'w of u*, and v' - v'w of v*; black has that of the white.
double chromaticity_difference(double u, double l) noexcept {
  return l == 0 ? 0 * u : u / (13 * l);
}

// What the differences of a colour from its G make of XYZ, and the XYZ of the white.
struct FromGrey {
  Xyz xyz, white;
};

FromGrey from_grey(Rgb rgb, const Eigen::Matrix3d& m) noexcept {
  const double red = rgb.r - rgb.g;
  const double blue = rgb.b - rgb.g;
  const auto part = [&](int row) { return m(row, 0) * red + m(row, 2) * blue; };
  const auto white = [&](int row) { return m(row, 0) + m(row, 1) + m(row, 2); };
  return {{part(0), part(1), part(2)}, {white(0), white(1), white(2)}};
}

// Grey `y` and what X and Z differ from its own.
Rgb off_grey(double y, double x, double z, const Eigen::Matrix3d& m) noexcept {
  return {y + (m(0, 0) * x + m(0, 2) * z), y + (m(1, 0) * x + m(1, 2) * z),
          y + (m(2, 0) * x + m(2, 2) * z)};
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
  const double sum = luv_sum(xyz);
  if (sum == 0) return {l, 0, 0};
  const double white_sum = luv_sum(white);
  return {l, 13 * l * (4 * xyz.x / sum - 4 * white.x / white_sum),
          13 * l * (9 * xyz.y / sum - 9 * white.y / white_sum)};
}

Xyz luv_to_xyz(Luv luv, Xyz white) noexcept {
  const double y = white.y * luminance_from_lstar(luv.l);
  const double white_sum = luv_sum(white);
  const double u = chromaticity_difference(luv.u, luv.l) + 4 * white.x / white_sum;
  const double v = chromaticity_difference(luv.v, luv.l) + 9 * white.y / white_sum;
  return {9 * y * u / (4 * v), y, (12 - 3 * u - 20 * v) * y / (4 * v)};
}

double lstar_from_luminance(double y) noexcept { return 116 * f(y) - 16; }

double luminance_from_lstar(double lstar) noexcept {
  const double fy = (lstar + 16) / 116;
  return lstar > 8 ? fy * fy * fy : lstar / kKappa;
}

Lab rgb_to_lab(Rgb rgb, const Eigen::Matrix3d& matrix) noexcept {
  // X/Xw = G + (Mr (R - G) + Mb (B - G))/Xw: a grey leaves G alone, exactly.
  const FromGrey d = from_grey(rgb, matrix);
  return lab_of_ratios(rgb.g + d.xyz.x / d.white.x, rgb.g + d.xyz.y / d.white.y,
                       rgb.g + d.xyz.z / d.white.z);
}

Luv rgb_to_luv(Rgb rgb, const Eigen::Matrix3d& matrix) noexcept {
  // With S = X + 15Y + 3Z, u' - u'w = 4 (X Sw - Xw S)/(S Sw), and the part of G in X and S cancels.
  const FromGrey d = from_grey(rgb, matrix);
  const double l = lstar_from_luminance(rgb.g + d.xyz.y / d.white.y);
  const double white_sum = luv_sum(d.white);
  const double rest = luv_sum(d.xyz);
  const double sum = rgb.g * white_sum + rest;
  if (sum == 0) return {l, 0, 0};
  const double scale = 13 * l / (sum * white_sum);
  return {l, 4 * scale * (d.xyz.x * white_sum - d.white.x * rest),
          9 * scale * (d.xyz.y * white_sum - d.white.y * rest)};
}

Rgb lab_to_rgb(Lab lab, Xyz white, const Eigen::Matrix3d& matrix) noexcept {
  // RGB = Y/Yw (1, 1, 1) + M (X - Xw Y/Yw, 0, Z - Zw Y/Yw), as M takes the white to (1, 1, 1).
  const double fy = (lab.l + 16) / 116;
  const double y = luminance_from_lstar(lab.l);
  const double x = lab.a == 0 ? 0 : white.x * (f_inverse(fy + lab.a / 500) - y);
  const double z = lab.b == 0 ? 0 : white.z * (f_inverse(fy - lab.b / 200) - y);
  return off_grey(y, x, z, matrix);
}

Rgb luv_to_rgb(Luv luv, Xyz white, const Eigen::Matrix3d& matrix) noexcept {
  // As lab_to_rgb, with X/Y - Xw/Yw = 9 (u'/v' - u'w/v'w)/4 and its like written in du = u' - u'w.
  const double y = luminance_from_lstar(luv.l);
  const double white_sum = luv_sum(white);
  const double u = 4 * white.x / white_sum;
  const double v = 9 * white.y / white_sum;
  const double du = chromaticity_difference(luv.u, luv.l);
  const double dv = chromaticity_difference(luv.v, luv.l);
  const double scale = white.y * y / (4 * (v + dv) * v);
  const double x = 9 * scale * (du * v - u * dv);
  const double z = -3 * scale * (du * v + (4 - u) * dv);
  return off_grey(y, x, z, matrix);
}

}  // namespace tristim
