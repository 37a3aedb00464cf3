#include "tristim/light/refraction.h"

#include <utility>

#include "lib/light/precise.h"

namespace tristim {

namespace detail {
namespace {

using Eigen::Vector3d;

// The ray as it comes from the side of the normal, with what all forms need.
struct Ray {
  PreciseVector to_light, normal;
  DoubleDouble eta;     // eta_i / eta_t
  DoubleDouble cos_i;   // N.L, 0 or more
  DoubleDouble sin2_i;  // 1 - (N.L)^2
};

Ray ray_of(const Vector3d& to_light, const Vector3d& normal, double eta_i, double eta_t) noexcept {
  Ray ray{.to_light = precise(to_light),
          .normal = precise(normal),
          .eta = {},
          .cos_i = {},
          .sin2_i = {}};
  ray.cos_i = dot(ray.normal, ray.to_light);
  if (ray.cos_i.hi < 0) {
    ray.normal = -ray.normal;
    ray.cos_i = -ray.cos_i;
    std::swap(eta_i, eta_t);
  }
  ray.eta = DoubleDouble(eta_i) / eta_t;
  ray.sin2_i = 1 - ray.cos_i * ray.cos_i;
  return ray;
}

Refraction nothing_passes() noexcept { return {.total_internal = true}; }

Refraction passing(const PreciseVector& transmitted, DoubleDouble cos_t) noexcept {
  return {rounded(transmitted), cos_t.hi, false};
}

}  // namespace

Refraction refract_in_plane(const Vector3d& to_light, const Vector3d& normal, double eta_i,
                            double eta_t) noexcept {
  const Ray ray = ray_of(to_light, normal, eta_i, eta_t);
  const DoubleDouble sin2_t = ray.eta * ray.eta * ray.sin2_i;
  if (!((1 - sin2_t).hi > 0)) return nothing_passes();
  const DoubleDouble cos_t = square_root(1 - sin2_t);
  if (!(sin2_t.hi > 0)) return passing(-cos_t * ray.normal, cos_t);  // M is any direction
  const DoubleDouble sin_i = square_root(ray.sin2_i);
  const PreciseVector m = DoubleDouble(1) / sin_i * (ray.cos_i * ray.normal - ray.to_light);
  return passing(square_root(sin2_t) * m - cos_t * ray.normal, cos_t);
}

Refraction refract_by_sines(const Vector3d& to_light, const Vector3d& normal, double eta_i,
                            double eta_t) noexcept {
  const Ray ray = ray_of(to_light, normal, eta_i, eta_t);
  const DoubleDouble sin_t = ray.eta * square_root(ray.sin2_i);
  const DoubleDouble cos2_t = (1 - sin_t) * (1 + sin_t);
  if (!(cos2_t.hi > 0)) return nothing_passes();
  const DoubleDouble cos_t = square_root(cos2_t);
  return passing((ray.eta * ray.cos_i - cos_t) * ray.normal - ray.eta * ray.to_light, cos_t);
}

Refraction refract_by_dots(const Vector3d& to_light, const Vector3d& normal, double eta_i,
                           double eta_t) noexcept {
  const Ray ray = ray_of(to_light, normal, eta_i, eta_t);
  const DoubleDouble cos2_t = 1 - ray.eta * ray.eta * ray.sin2_i;
  if (!(cos2_t.hi > 0)) return nothing_passes();
  const DoubleDouble cos_t = square_root(cos2_t);
  return passing((ray.eta * ray.cos_i - cos_t) * ray.normal - ray.eta * ray.to_light, cos_t);
}

}  // namespace detail

Refraction refract(const Eigen::Vector3d& to_light, const Eigen::Vector3d& normal, double eta_i,
                   double eta_t) noexcept {
  return detail::refract_by_dots(to_light, normal, eta_i, eta_t);
}

double snell_sine(double sin_i, double eta_i, double eta_t) noexcept {
  return eta_i * sin_i / eta_t;
}

}  // namespace tristim
