#include "lib/render/visibility.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tristim/light/vector.h"

namespace tristim::detail {
namespace {

using Eigen::Vector3d;

struct Disc {
  double distance;
  double spread;  // tangent of the angular radius
};

Disc disc_of(const SoftLight& light, const Vector3d& point) noexcept {
  const auto* place = std::get_if<PointLight>(&light.light);
  if (place == nullptr) return {std::numeric_limits<double>::infinity(), light.size};
  const double distance = length(place->position - point);
  return {distance, light.size / distance};
}

}  // namespace

double hidden_part(double light, double blocker, double apart) noexcept {
  if (apart >= light + blocker) return 0;
  const double most = blocker < light ? blocker * blocker / (light * light) : 1;
  if (apart <= std::fabs(light - blocker)) return most;
  // -1: the smaller disc lies inside of the larger one, 1: outside.
  const double x = (apart - std::max(light, blocker)) / std::min(light, blocker);
  return most * (0.5 - x * (0.75 - 0.25 * x * x));
}

double visible_part(const SphereScene& scene, const SoftLight& light, const Vector3d& to_light,
                    const Vector3d& point, const Sphere* self) noexcept {
  const Disc disc = disc_of(light, point);
  double visible = 1;
  for (const Sphere& sphere : scene.spheres) {
    if (&sphere == self) continue;
    const Vector3d to_centre = sphere.centre - point;
    const double along = dot(to_centre, to_light);
    if (along <= 0 || along >= disc.distance) continue;
    const double apart_squared = dot(to_centre, to_centre) - along * along;
    const double radius = disc.spread * along;  // of the cone from the point to the light's disc
    const double reach = sphere.radius + radius;
    if (apart_squared >= reach * reach) continue;
    visible *= 1 - hidden_part(radius, sphere.radius, std::sqrt(std::max(apart_squared, 0.0)));
  }
  return visible;
}

double unblocked_part(const SphereScene& scene, const Vector3d& point, const Vector3d& normal,
                      const Sphere* self) noexcept {
  double open = 1;
  for (const Sphere& sphere : scene.spheres) {
    if (&sphere == self) continue;
    const Vector3d to_centre = sphere.centre - point;
    const double above = dot(normal, to_centre);  // d N.D
    if (above <= 0) continue;
    const double squared = dot(to_centre, to_centre);
    const double taken = above * sphere.radius * sphere.radius / (squared * std::sqrt(squared));
    open *= 1 - std::min(taken, 1.0);
  }
  return open;
}

}  // namespace tristim::detail
