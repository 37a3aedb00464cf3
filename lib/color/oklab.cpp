#include "tristim/color/oklab.h"

#include <Eigen/LU>

#include "lib/color/oklab_matrices.h"
#include "lib/color/polar.h"
#include "lib/core/math.h"

namespace tristim {
namespace {

using detail::kLabFromRoots;
using detail::kLmsFromSrgb;

Eigen::Matrix3d inverse(const double (&m)[3][3]) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&m[0][0]).inverse();
}

double dot(const double (&row)[3], double x, double y, double z) noexcept {
  return row[0] * x + row[1] * y + row[2] * z;
}

// Oklab with `compress` in the place of the cube root.
template <typename Compress>
Oklab oklab_by(Compress&& compress, Rgb rgb) noexcept {
  const double l = compress(dot(kLmsFromSrgb[0], rgb.r, rgb.g, rgb.b));
  const double m = compress(dot(kLmsFromSrgb[1], rgb.r, rgb.g, rgb.b));
  const double s = compress(dot(kLmsFromSrgb[2], rgb.r, rgb.g, rgb.b));
  return {dot(kLabFromRoots[0], l, m, s), dot(kLabFromRoots[1], l, m, s),
          dot(kLabFromRoots[2], l, m, s)};
}

}  // namespace

Oklab linear_srgb_to_oklab(Rgb rgb) noexcept { return oklab_by(detail::cbrt, rgb); }

Oklab linear_srgb_to_oklab_with_toe(Rgb rgb, double toe) noexcept {
  const double root = detail::cbrt(toe);
  const double slope = 1 / (3 * root * root);
  return oklab_by([&](double x) { return x > 0 ? detail::cbrt(x + toe) - root : slope * x; }, rgb);
}

Rgb oklab_to_linear_srgb(Oklab oklab) noexcept {
  static const Eigen::Matrix3d roots_from_lab = inverse(kLabFromRoots);
  static const Eigen::Matrix3d rgb_from_lms = inverse(kLmsFromSrgb);
  const Eigen::Vector3d roots = roots_from_lab * Eigen::Vector3d(oklab.l, oklab.a, oklab.b);
  const Eigen::Vector3d rgb = rgb_from_lms * roots.cwiseProduct(roots).cwiseProduct(roots);
  return {rgb.x(), rgb.y(), rgb.z()};
}

Oklch oklab_to_oklch(Oklab oklab) noexcept {
  const detail::Polar polar = detail::to_polar({oklab.a, oklab.b}, kOklchNeutral);
  return {oklab.l, polar.chroma, polar.hue_deg};
}

Oklab oklch_to_oklab(Oklch oklch) noexcept {
  const detail::Plane plane = detail::from_polar({oklch.c, oklch.h}, kOklchNeutral);
  return {oklch.l, plane.a, plane.b};
}

bool same(const Oklch& first, const Oklch& second) noexcept {
  return detail::same_polar(first, second);
}

}  // namespace tristim
