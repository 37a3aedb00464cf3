#include "tristim/light/source.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/core/math.h"
#include "lib/core/trigonometry.h"
#include "lib/light/power.h"
#include "lib/light/precise.h"
#include "lib/light/product.h"
#include "tristim/light/vector.h"

namespace tristim {

namespace detail {

double unattenuated(double, double, double, double) noexcept { return 1; }

double inverse_square(double d, double, double, double) noexcept { return 1 / (d * d); }

double inverse_linear(double d, double c1, double c2, double) noexcept { return 1 / (c1 + c2 * d); }

// Horner's order: c2 d and c3 d^2 apart could overflow to infinities of opposite signs, NaN.
double inverse_quadratic(double d, double c1, double c2, double c3) noexcept {
  return 1 / (c1 + d * (c2 + c3 * d));
}

double clamped_quadratic(double d, double c1, double c2, double c3) noexcept {
  return std::min(inverse_quadratic(d, c1, c2, c3), 1.0);
}

double beer_lambert(double d, double c1, double, double) noexcept {
  constexpr double kBeyond = 800;     // no number any more
  constexpr double kLargest = 1e290;  // of exact products
  const bool exact = std::fabs(c1 * d) < kBeyond && std::fabs(c1) < kLargest && d < kLargest;
  if (!exact) return exp(-c1 * d);
  return exp_precise(-(DoubleDouble(c1) * d)).hi;
}

}  // namespace detail

namespace {

using detail::product;
using Eigen::Vector3d;

// Made unit, unless it is that already: turned by the rounding of its length, light that grazes
// could pass to the other side of the surface.
Vector3d direction(const Vector3d& v) noexcept {
  constexpr double kRounding = 1e-15;  // of the three parts of a unit vector
  return std::fabs(v.squaredNorm() - 1) <= kRounding ? v : normalize(v);
}

template <typename Color>
IncidentOf<Color> arriving(const DirectionalLightOf<Color>& light, const Vector3d&) noexcept {
  return {direction(light.to_light), light.intensity};
}

template <typename Color>
IncidentOf<Color> arriving(const PointLightOf<Color>& light, const Vector3d& point) noexcept {
  const Vector3d toward = light.position - point;
  const Attenuation& a = light.attenuation;
  // Finite places may be infinitely far apart; 0 times that distance would be NaN.
  const double d = std::min(length(toward), std::numeric_limits<double>::max());
  const double f_att = a.kind.factor(d, a.c1, a.c2, a.c3);
  return {view_vector(point, light.position), product(f_att, light.intensity)};
}

template <typename Color>
IncidentOf<Color> arriving(const SpotLightOf<Color>& light, const Vector3d& point) noexcept {
  const double factor =
      spot_factor(point - light.position, light.direction, light.cutoff_deg, light.exponent);
  return arriving(
      PointLightOf<Color>{light.position, product(factor, light.intensity), light.attenuation},
      point);
}

template <typename Color>
IncidentOf<Color> incident_of(const LightOf<Color>& light, const Vector3d& point) noexcept {
  if (const auto* directional = std::get_if<DirectionalLightOf<Color>>(&light)) {
    return arriving(*directional, point);
  }
  if (const auto* spot = std::get_if<SpotLightOf<Color>>(&light)) return arriving(*spot, point);
  return arriving(*std::get_if<PointLightOf<Color>>(&light), point);
}

}  // namespace

Incident incident(const Light& light, const Vector3d& point) noexcept {
  return incident_of<Rgb>(light, point);
}

SpectralIncident incident(const SpectralLight& light, const Vector3d& point) noexcept {
  return incident_of<SpectralColor>(light, point);
}

double spot_factor(const Vector3d& from_light, const Vector3d& axis, double cutoff_deg,
                   double exponent) noexcept {
  constexpr double kNoCone = 180;
  if (cutoff_deg == kNoCone) return 1;
  const detail::DoubleDouble cosine =
      dot(normalize(detail::precise(from_light)), normalize(detail::precise(axis)));
  const detail::DoubleDouble edge = detail::precise_sine_cosine_deg(cutoff_deg).cosine;
  constexpr double kRounding = 1e-30;  // of both: what lies on the edge is inside
  return (cosine - edge).hi >= -kRounding ? detail::lobe_power(cosine, exponent) : 0;
}

Light placed_with_camera(const Light& in_camera, const CameraPose& camera) noexcept {
  const auto turned = [&](const Vector3d& v) -> Vector3d { return camera.world_from_camera * v; };
  Light light = in_camera;
  if (auto* directional = std::get_if<DirectionalLight>(&light)) {
    directional->to_light = turned(directional->to_light);
  } else if (auto* point = std::get_if<PointLight>(&light)) {
    point->position = camera.eye + turned(point->position);
  } else if (auto* spot = std::get_if<SpotLight>(&light)) {
    spot->position = camera.eye + turned(spot->position);
    spot->direction = turned(spot->direction);
  }
  return light;
}

}  // namespace tristim
