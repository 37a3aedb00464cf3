#include "tristim/color/deficiency.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "tristim/color/primaries.h"
#include "tristim/color/wavelength.h"

namespace tristim {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Cone responses of [Smith75].
Matrix3d lms_from_xyz() {
  Matrix3d m;
  m << 0.15514, 0.54312, -0.03286,  //
      -0.15514, 0.45684, 0.03286,   //
      0, 0, 0.01608;
  return m;
}

// The projection along `axis` onto the plane of `white` and `anchor`: c - axis (n c)/(n axis).
Matrix3d projection(const Vector3d& axis, const Vector3d& white, const Vector3d& anchor) {
  const Vector3d normal = white.cross(anchor);
  return Matrix3d::Identity() - axis * normal.transpose() / normal.dot(axis);
}

// In linear sRGB: two projections, and the plane that parts the colours of the one from the
// other's.
struct Simulation {
  Matrix3d first, second;
  Eigen::RowVector3d side;  // times a colour: above 0 for those of the first
};

Vector3d spectral_xyz(double lambda_nm) {
  const Chromaticity c = spectral_locus(lambda_nm);
  return {c.x, c.y, 1 - c.x - c.y};
}

Simulation simulation_of(const ColorDeficiency& deficiency) {
  const Matrix3d lms_from_rgb = lms_from_xyz() * xyz_from_rgb(Primaries{});
  const Matrix3d rgb_from_lms = lms_from_rgb.inverse();
  const Vector3d white = lms_from_rgb * Vector3d::Ones();
  const Vector3d axis = Vector3d::Unit(deficiency.missing_cone);
  const bool spectral = deficiency.anchors_nm[0] > 0;
  const auto anchor = [&](double nm) -> Vector3d {
    return spectral ? Vector3d(lms_from_xyz() * spectral_xyz(nm)) : Vector3d(lms_from_rgb.col(2));
  };
  const Vector3d first = anchor(deficiency.anchors_nm[0]);
  const Vector3d second = anchor(deficiency.anchors_nm[1]);
  Vector3d parting = white.cross(axis);
  if (parting.dot(first) < 0) parting = -parting;
  return {rgb_from_lms * projection(axis, white, first) * lms_from_rgb,
          rgb_from_lms * projection(axis, white, second) * lms_from_rgb,
          parting.transpose() * lms_from_rgb};
}

const Simulation& simulation(int missing_cone) {
  static const std::array all{simulation_of(kColorDeficiencies[0]),
                              simulation_of(kColorDeficiencies[1]),
                              simulation_of(kColorDeficiencies[2])};
  return all.at(static_cast<std::size_t>(missing_cone));
}

}  // namespace

Rgb simulate_deficiency(Rgb linear_srgb, const ColorDeficiency& deficiency) noexcept {
  const Simulation& s = simulation(deficiency.missing_cone);
  const Vector3d rgb(linear_srgb.r, linear_srgb.g, linear_srgb.b);
  const Vector3d seen = s.side.dot(rgb) >= 0 ? s.first * rgb : s.second * rgb;
  return {seen.x(), seen.y(), seen.z()};
}

}  // namespace tristim
