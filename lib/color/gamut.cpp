#include "tristim/color/gamut.h"

#include <algorithm>
#include <limits>

namespace tristim {

Polygon gamut_triangle(const Primaries& primaries, const ChromaticityPlane& plane) {
  return {plane.point(primaries.red), plane.point(primaries.green), plane.point(primaries.blue)};
}

double gamut_area(const Primaries& primaries, const ChromaticityPlane& plane) {
  return polygon_area(gamut_triangle(primaries, plane));
}

Polygon gamut_intersection(const Primaries& a, const Primaries& b, const ChromaticityPlane& plane) {
  return convex_intersection(gamut_triangle(a, plane), gamut_triangle(b, plane));
}

double gamut_coverage(const Primaries& covering, const Primaries& covered,
                      const ChromaticityPlane& plane) {
  const double common = polygon_area(gamut_intersection(covered, covering, plane));
  const double area = gamut_area(covered, plane);
  if (!(area > 0)) return std::numeric_limits<double>::quiet_NaN();
  return std::min(common / area, 1.0);  // corners of the intersection are rounded
}

GamutPosition gamut_position(Xyz xyz, const Primaries& primaries, double slack) {
  const Eigen::Vector3d rgb = rgb_from_xyz(primaries) * Eigen::Vector3d(xyz.x, xyz.y, xyz.z);
  GamutPosition position{.rgb = {rgb.x(), rgb.y(), rgb.z()}};
  const double least = rgb.minCoeff<Eigen::PropagateNaN>();
  const double greatest = rgb.maxCoeff<Eigen::PropagateNaN>();
  if (!(least >= -slack)) position.below = -least;
  if (!(greatest <= 1 + slack)) position.above = greatest - 1;
  const bool black = xyz == Xyz{};
  const bool mixable = least >= -slack;
  if (!black && !mixable) {
    const Xyy xyy = xyz_to_xyy(xyz);
    position.distance =
        distance_outside(gamut_triangle(primaries, kCie1976Plane), uv76_from_xy({xyy.x, xyy.y}));
  }
  return position;
}

}  // namespace tristim
