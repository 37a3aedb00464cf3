#include "tristim/color/primaries.h"

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

namespace tristim {
namespace {

constexpr NamedPrimaries kPrimaries[] = {
#include "luts/primaries.csv"
};

Eigen::Vector3d xyz_direction(Chromaticity c) { return {c.x, c.y, 1 - c.x - c.y}; }

Eigen::Vector3d vector(Xyz xyz) { return {xyz.x, xyz.y, xyz.z}; }

Eigen::Vector3d white_vector(Chromaticity white) {
  if (!(white.y != 0) || !std::isfinite(white.x) || !std::isfinite(white.y)) {
    throw std::invalid_argument("white: y must be finite and not 0");
  }
  return vector(white_xyz(white));
}

// Cone-like responses in which an adaptation scales.
Eigen::Matrix3d adaptation_basis(Adaptation method) {
  Eigen::Matrix3d basis;
  if (method == Adaptation::kBradford) {
    basis << 0.8951, 0.2664, -0.1614,  //
        -0.7502, 1.7135, 0.0367,       //
        0.0389, -0.0685, 1.0296;
  } else {
    basis << 0.401288, 0.650173, -0.051461,  //
        -0.250268, 1.204414, 0.045854,       //
        -0.002079, 0.048952, 0.953127;
  }
  return basis;
}

}  // namespace

std::span<const NamedPrimaries> primaries_list() noexcept { return kPrimaries; }

Eigen::Matrix3d xyz_from_rgb(const Primaries& primaries) {
  Eigen::Matrix3d directions;
  directions << xyz_direction(primaries.red), xyz_direction(primaries.green),
      xyz_direction(primaries.blue);
  const double determinant = directions.determinant();
  if (!(std::fabs(determinant) >
        1e-9)) {  // twice the area of the triangle: 1e-9 is below any display's
    throw std::invalid_argument("primaries: the three chromaticities lie on a line");
  }
  const Eigen::Vector3d c = directions.inverse() * white_vector(primaries.white);
  return directions * c.asDiagonal();
}

Eigen::Matrix3d rgb_from_xyz(const Primaries& primaries) {
  return xyz_from_rgb(primaries).inverse();
}

Chromaticity white_from_luminances(const Primaries& phosphors, double yr, double yg, double yb) {
  if (!(yr + yg + yb > 0)) {
    throw std::invalid_argument("luminances: their sum must be above 0");
  }
  const auto light = [](Chromaticity c, double y) -> Eigen::Vector3d {
    return xyz_direction(c) * (y / c.y);
  };
  const Eigen::Vector3d white =
      light(phosphors.red, yr) + light(phosphors.green, yg) + light(phosphors.blue, yb);
  return {white.x() / white.sum(), white.y() / white.sum()};
}

Eigen::Matrix3d adaptation_matrix(Chromaticity from, Chromaticity to, Adaptation method) {
  const Eigen::Vector3d source = white_vector(from);
  const Eigen::Vector3d target = white_vector(to);
  if (method == Adaptation::kNone || from == to) return Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d basis = adaptation_basis(method);
  const Eigen::Vector3d gain = (basis * target).cwiseQuotient(basis * source);
  return basis.inverse() * gain.asDiagonal() * basis;
}

Eigen::Matrix3d rgb_from_rgb(const Primaries& to, const Primaries& from, Adaptation method) {
  const Eigen::Matrix3d source = xyz_from_rgb(from);
  const Eigen::Matrix3d target = rgb_from_xyz(to);
  if (to == from) return Eigen::Matrix3d::Identity();
  return target * adaptation_matrix(from.white, to.white, method) * source;
}

}  // namespace tristim
