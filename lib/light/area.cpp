#include "tristim/light/area.h"

#include <algorithm>
#include <vector>

#include "lib/light/angle.h"
#include "lib/light/precise.h"
#include "lib/light/product.h"

namespace tristim {
namespace {

using detail::DoubleDouble;
using detail::precise;
using detail::PreciseVector;
using detail::product;
using Eigen::Vector3d;

// A vertex as the point sees it.
struct Sight {
  PreciseVector toward;  // any length
  DoubleDouble height;   // above the horizon, times that length
};

PreciseVector between(const Sight& a, const Sight& b) noexcept {
  const DoubleDouble t = a.height / (a.height - b.height);
  return a.toward + t * (b.toward - a.toward);
}

// The part of the polygon above the horizon, by the algorithm of [Sutherland74] with one edge.
std::vector<PreciseVector> above_horizon(std::span<const Vector3d> polygon, const Vector3d& point,
                                         const Vector3d& normal) {
  std::vector<Sight> all;
  for (const Vector3d& vertex : polygon) {
    const PreciseVector toward = precise(vertex) - precise(point);
    all.push_back({toward, dot(toward, precise(normal))});
  }
  const auto above = [](const Sight& sight) { return sight.height.hi > 0; };
  std::vector<PreciseVector> kept;
  if (std::none_of(all.begin(), all.end(), above)) return kept;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Sight& here = all[i];
    const Sight& next = all[(i + 1) % all.size()];
    if (here.height.hi >= 0) kept.push_back(here.toward);
    if ((here.height.hi > 0 && next.height.hi < 0) || (here.height.hi < 0 && next.height.hi > 0)) {
      kept.push_back(between(here, next));
    }
  }
  return kept;
}

}  // namespace

double polygon_form_factor(std::span<const Vector3d> polygon, const Vector3d& point,
                           const Vector3d& normal) {
  std::vector<PreciseVector> seen = above_horizon(polygon, point, normal);
  if (seen.size() < 3) return 0;
  for (PreciseVector& toward : seen) toward = normalize(toward);
  DoubleDouble sum = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const PreciseVector& a = seen[i];
    const PreciseVector& b = seen[(i + 1) % seen.size()];
    const PreciseVector across = cross(b, a);  // the lit side sees the vertices run clockwise
    const DoubleDouble sine = length(across);
    if (!(sine.hi > 0)) continue;
    sum = sum + detail::arctangent(sine, dot(a, b)) * dot(across, precise(normal)) / sine;
  }
  const double factor = (sum / (2 * detail::kPi)).hi;
  return factor > 0 ? factor : 0;
}

double polygon_irradiance(std::span<const Vector3d> polygon, const Vector3d& point,
                          const Vector3d& normal, double radiance) {
  return detail::kPi.hi * product(radiance, polygon_form_factor(polygon, point, normal));
}

Rgb area_reflection(const Material& material, const AreaLight& light, const Vector3d& point,
                    const Vector3d& normal) {
  const double factor = polygon_form_factor(light.polygon, point, normal);
  return product(product(material.kd, factor), product(material.od, light.radiance));
}

SpectralColor area_reflection(const SpectralMaterial& material, const SpectralAreaLight& light,
                              const Vector3d& point, const Vector3d& normal) {
  const double factor = polygon_form_factor(light.polygon, point, normal);
  return product(product(material.kd, factor), product(material.od, light.radiance));
}

}  // namespace tristim
