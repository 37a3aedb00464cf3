#include "tristim/light/source.h"

#include <algorithm>
#include <limits>

#include "lib/core/math.h"
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

double beer_lambert(double d, double c1, double, double) noexcept { return exp(-c1 * d); }

}  // namespace detail

namespace {

Incident arriving(const DirectionalLight& light, const Eigen::Vector3d&) noexcept {
  return {normalize(light.to_light), light.intensity};
}

Incident arriving(const PointLight& light, const Eigen::Vector3d& point) noexcept {
  const Eigen::Vector3d toward = light.position - point;
  const Attenuation& a = light.attenuation;
  // Finite places may be infinitely far apart; 0 times that distance would be NaN.
  const double d = std::min(length(toward), std::numeric_limits<double>::max());
  const double f_att = a.kind.factor(d, a.c1, a.c2, a.c3);
  return {normalize(toward), detail::product(f_att, light.intensity)};
}

}  // namespace

Incident incident(const Light& light, const Eigen::Vector3d& point) noexcept {
  if (const auto* directional = std::get_if<DirectionalLight>(&light)) {
    return arriving(*directional, point);
  }
  return arriving(*std::get_if<PointLight>(&light), point);
}

}  // namespace tristim
