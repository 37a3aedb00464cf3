#include "lib/color/cie1976.h"
#include "tristim/color/lab.h"

namespace tristim {
namespace {

using Dd = detail::DoubleDouble;

// X + 15 Y + 3 Z, which u' = 4X/S and v' = 9Y/S are relative to.
double luv_sum(Xyz xyz) noexcept { return xyz.x + 15 * xyz.y + 3 * xyz.z; }

Dd luv_sum(const std::array<Dd, 3>& xyz) noexcept {
  return detail::add(xyz[0],
                     detail::add(detail::multiply(xyz[1], 15), detail::multiply(xyz[2], 3)));
}

// u' - u'n = 4 (X Sn - Xn S)/(S Sn) and v' - v'n likewise: the grey in X and S cancels.
Luv luv_of(const detail::RelativeXyz& xyz) noexcept {
  const Dd l = detail::cie_lightness(xyz.ratio(1));
  const Dd white_sum = luv_sum(xyz.white);
  const Dd rest = luv_sum(xyz.rest);
  const Dd sum = detail::add(detail::multiply(white_sum, xyz.grey), rest);
  if (sum.hi == 0) return {l.value(), 0, 0};
  const Dd scale = detail::divide(detail::multiply(l, 13), detail::multiply(sum, white_sum));
  const auto difference = [&](std::size_t axis, double factor) {
    const Dd cross = detail::subtract(detail::multiply(xyz.rest[axis], white_sum),
                                      detail::multiply(xyz.white[axis], rest));
    return detail::multiply(detail::multiply(scale, cross), factor).value();
  };
  return {l.value(), difference(0, 4), difference(1, 9)};
}

// For numbers without end, and so large that their products have none.
Luv immoderate_luv(Xyz xyz, Xyz white) noexcept {
  const double l = lstar_from_luminance(xyz.y / white.y);
  const double sum = luv_sum(xyz);
  const double white_sum = luv_sum(white);
  return {l, 13 * l * (4 * xyz.x / sum - 4 * white.x / white_sum),
          13 * l * (9 * xyz.y / sum - 9 * white.y / white_sum)};
}

// u' - u'n of u*, and v' - v'n of v*; black has the chromaticity of the white.
double chromaticity_difference(double u, double l) noexcept {
  return l == 0 ? 0 * u : u / (13 * l);
}

}  // namespace

Luv xyz_to_luv(Xyz xyz, Xyz white) noexcept {
  if (detail::is_moderate(xyz.x, xyz.y, xyz.z)) return luv_of(detail::relative_xyz(xyz, white));
  return immoderate_luv(xyz, white);
}

Xyz luv_to_xyz(Luv luv, Xyz white) noexcept {
  const double y = white.y * luminance_from_lstar(luv.l);
  const double white_sum = luv_sum(white);
  const double u = chromaticity_difference(luv.u, luv.l) + 4 * white.x / white_sum;
  const double v = chromaticity_difference(luv.v, luv.l) + 9 * white.y / white_sum;
  return {9 * y * u / (4 * v), y, (12 - 3 * u - 20 * v) * y / (4 * v)};
}

Luv rgb_to_luv(Rgb rgb, const Eigen::Matrix3d& matrix) noexcept {
  if (detail::is_moderate(rgb.r, rgb.g, rgb.b)) return luv_of(detail::relative_xyz(rgb, matrix));
  const Eigen::Vector3d white = matrix.rowwise().sum();
  const Eigen::Vector3d xyz = matrix * Eigen::Vector3d(rgb.r, rgb.g, rgb.b);
  return immoderate_luv({xyz.x(), xyz.y(), xyz.z()}, {white.x(), white.y(), white.z()});
}

Rgb luv_to_rgb(Luv luv, Xyz white, const Eigen::Matrix3d& matrix) noexcept {
  // As lab_to_rgb, with X/Y - Xn/Yn = 9 (u'/v' - u'n/v'n)/4 and its like written in du = u' - u'n.
  const double y = luminance_from_lstar(luv.l);
  const double white_sum = luv_sum(white);
  const double u = 4 * white.x / white_sum;
  const double v = 9 * white.y / white_sum;
  const double du = chromaticity_difference(luv.u, luv.l);
  const double dv = chromaticity_difference(luv.v, luv.l);
  const double scale = white.y * y / (4 * (v + dv) * v);
  const double x = 9 * scale * (du * v - u * dv);
  const double z = -3 * scale * (du * v + (4 - u) * dv);
  return detail::off_grey(y, x, z, matrix);
}

}  // namespace tristim
