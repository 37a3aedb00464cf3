#include "tristim/color/primaries.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "lib/color/adaptation.h"

namespace tristim {
namespace {

using detail::ExactMatrix;
using detail::ExactVector;

constexpr NamedPrimaries kPrimaries[] = {
#include "luts/primaries.csv"
};

// 1e-9, twice the area of the triangle, is below any display's.
void check_triangle(const Primaries& p) {
  const double area =
      (p.green.x - p.red.x) * (p.blue.y - p.red.y) - (p.blue.x - p.red.x) * (p.green.y - p.red.y);
  if (std::fabs(area) > 1e-9) return;
  throw std::invalid_argument("primaries: the three chromaticities lie on a line");
}

ExactMatrix exact_xyz_from_rgb(const Primaries& p) {
  check_triangle(p);
  detail::check_white(p.white);
  ExactMatrix directions;
  const ExactVector columns[] = {detail::exact_chromaticity(p.red),
                                 detail::exact_chromaticity(p.green),
                                 detail::exact_chromaticity(p.blue)};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) directions[i][j] = columns[j][i];
  }
  return scale_columns(directions, inverse(directions) * detail::exact_white(p.white));
}

Eigen::Vector3d white_of(const Primaries& p) {
  return detail::rounded(detail::exact_white(p.white));
}

}  // namespace

std::span<const NamedPrimaries> primaries_list() noexcept { return kPrimaries; }

Eigen::Matrix3d xyz_from_rgb(const Primaries& primaries) {
  return rounded(exact_xyz_from_rgb(primaries), Eigen::Vector3d::Ones(), white_of(primaries));
}

Eigen::Matrix3d rgb_from_xyz(const Primaries& primaries) {
  return rounded(inverse(exact_xyz_from_rgb(primaries)), white_of(primaries),
                 Eigen::Vector3d::Ones());
}

Chromaticity white_from_luminances(const Primaries& phosphors, double yr, double yg, double yb) {
  if (!(yr + yg + yb > 0)) {
    throw std::invalid_argument("luminances: their sum must be above 0");
  }
  const auto light = [](Chromaticity c, double y) -> Eigen::Vector3d {
    return Eigen::Vector3d(c.x, c.y, 1 - c.x - c.y) * (y / c.y);
  };
  const Eigen::Vector3d white =
      light(phosphors.red, yr) + light(phosphors.green, yg) + light(phosphors.blue, yb);
  return {white.x() / white.sum(), white.y() / white.sum()};
}

Eigen::Matrix3d rgb_from_rgb(const Primaries& to, const Primaries& from, Adaptation method) {
  const ExactMatrix source = exact_xyz_from_rgb(from);
  const ExactMatrix target = inverse(exact_xyz_from_rgb(to));
  if (to == from) return Eigen::Matrix3d::Identity();
  const ExactMatrix adaptation = detail::exact_adaptation(from.white, to.white, method);
  const ExactMatrix exact = target * adaptation * source;
  const bool moves = method == Adaptation::kNone && from.white != to.white;
  const Eigen::Vector3d white = moves
                                    ? detail::rounded(exact * ExactVector{{{1, 0}, {1, 0}, {1, 0}}})
                                    : Eigen::Vector3d::Ones();
  return rounded(exact, Eigen::Vector3d::Ones(), white);
}

}  // namespace tristim
