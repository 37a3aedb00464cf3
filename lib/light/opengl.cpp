#include "tristim/light/opengl.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/light/product.h"
#include "tristim/light/phong.h"
#include "tristim/light/source.h"
#include "tristim/light/vector.h"

namespace tristim {
namespace {

using detail::product;
using detail::sum;
using Eigen::Vector3d;

// L, and what distance and cone leave of the light.
struct Arrival {
  Vector3d to_light;
  double factor;
};

Arrival arrival_of(const GlLight& light, const Vector3d& position) noexcept {
  if (light.w == 0) {
    const Vector3d from_light = -light.position;
    return {normalize(light.position), spot_factor(from_light, light.spot_direction,
                                                   light.spot_cutoff_deg, light.spot_exponent)};
  }
  // w times the way to the light: what is divided by a tiny w would overflow.
  const Vector3d toward = (light.w < 0 ? -1 : 1) * (light.position - light.w * position);
  const double d =
      std::min(length(toward) / std::fabs(light.w), std::numeric_limits<double>::max());
  const double attenuation =
      detail::inverse_quadratic(d, light.constant, light.linear, light.quadratic);
  const double spot =
      spot_factor(-toward, light.spot_direction, light.spot_cutoff_deg, light.spot_exponent);
  return {normalize(toward), product(attenuation, spot)};
}

Rgb light_of(const GlMaterial& material, const GlLight& light, const Vector3d& position,
             const Vector3d& normal, const Vector3d& to_eye) noexcept {
  const Arrival arrival = arrival_of(light, position);
  const double lobe = blinn_phong_lobe(normal, arrival.to_light, to_eye, material.shininess);
  const Rgb ambient = product(material.ambient, light.ambient);
  const Rgb diffuse =
      product(lambert(normal, arrival.to_light), product(material.diffuse, light.diffuse));
  const Rgb specular = product(lobe, product(material.specular, light.specular));
  return product(arrival.factor, sum(ambient, sum(diffuse, specular)));
}

}  // namespace

Rgb gl_lighting(const GlMaterial& material, const GlLightModel& model,
                std::span<const GlLight> lights, const Vector3d& position,
                const Vector3d& normal) noexcept {
  const Vector3d to_eye = model.local_viewer ? normalize(-position) : Vector3d(0, 0, 1);
  Rgb color = product(material.ambient, model.ambient);
  for (const GlLight& light : lights) {
    color = sum(color, light_of(material, light, position, normal, to_eye));
  }
  return color;
}

}  // namespace tristim
