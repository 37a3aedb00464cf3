#include "tristim/light/phong.h"

#include "lib/core/math.h"
#include "lib/light/power.h"
#include "lib/light/product.h"
#include "tristim/light/vector.h"

namespace tristim {
namespace {

using detail::product;
using Eigen::Vector3d;

// Most exponents are small integers, for which squaring is as good as the cosine itself.
double lobe_power(double cosine, double n) noexcept {
  constexpr double kLargestSquared = 4096;
  if (!(cosine > 0)) return 0;
  if (n >= 0 && n <= kLargestSquared && n == static_cast<int>(n)) {
    return detail::integer_power(cosine, static_cast<int>(n));
  }
  return detail::pow(cosine, n);
}

}  // namespace

double lambert(const Vector3d& normal, const Vector3d& to_light) noexcept {
  const double n_dot_l = dot(normal, to_light);
  return n_dot_l > 0 ? n_dot_l : 0;
}

double phong_lobe(const Vector3d& normal, const Vector3d& to_light, const Vector3d& to_eye,
                  double n) noexcept {
  const double n_dot_l = dot(normal, to_light);
  if (!(n_dot_l > 0)) return 0;
  return lobe_power(2 * dot(normal, to_eye) * n_dot_l - dot(to_light, to_eye), n);
}

double blinn_phong_lobe(const Vector3d& normal, const Vector3d& to_light, const Vector3d& to_eye,
                        double n) noexcept {
  if (!(dot(normal, to_light) > 0)) return 0;
  return lobe_power(dot(normal, half_vector(to_light, to_eye)), n);
}

Rgb ambient_reflection(const Material& material, const Rgb& ambient) noexcept {
  return product(material.ka, product(ambient, material.od));
}

Rgb direct_reflection(const Material& material, const SpecularModel& model, const Vector3d& normal,
                      const Vector3d& to_eye, const Incident& incident) noexcept {
  const double n_dot_l = lambert(normal, incident.to_light);
  if (n_dot_l == 0) return {};
  const double lobe = model.lobe(normal, incident.to_light, to_eye, material.n);
  const Rgb reflected = detail::sum(product(product(material.kd, n_dot_l), material.od),
                                    product(product(material.ks, lobe), material.os));
  return product(incident.intensity, reflected);
}

Rgb shade(const Material& material, const SpecularModel& model, const Vector3d& normal,
          const Vector3d& to_eye, const Vector3d& point, const Rgb& ambient,
          std::span<const Light> lights) noexcept {
  Rgb radiance = ambient_reflection(material, ambient);
  for (const Light& light : lights) {
    const Incident arriving = incident(light, point);
    radiance = detail::sum(radiance, direct_reflection(material, model, normal, to_eye, arriving));
  }
  return radiance;
}

}  // namespace tristim
