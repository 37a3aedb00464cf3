#include "tristim/light/phong.h"

#include "lib/light/power.h"
#include "lib/light/precise.h"
#include "lib/light/product.h"

namespace tristim {
namespace {

using detail::precise;
using detail::product;
using Eigen::Vector3d;

template <typename Color>
Color ambient_of(const MaterialOf<Color>& material, const Color& ambient) noexcept {
  return product(material.ka, product(ambient, material.od));
}

template <typename Color>
Color direct_of(const MaterialOf<Color>& material, const SpecularModel& model,
                const Vector3d& normal, const Vector3d& to_eye,
                const IncidentOf<Color>& incident) noexcept {
  const double n_dot_l = lambert(normal, incident.to_light);
  if (n_dot_l == 0) return {};
  const double lobe = model.lobe(normal, incident.to_light, to_eye, material.n);
  const Color reflected = detail::sum(product(product(material.kd, n_dot_l), material.od),
                                      product(product(material.ks, lobe), material.os));
  return product(incident.intensity, reflected);
}

template <typename Color>
Color shade_of(const MaterialOf<Color>& material, const SpecularModel& model,
               const Vector3d& normal, const Vector3d& to_eye, const Vector3d& point,
               const Color& ambient, std::span<const LightOf<Color>> lights) noexcept {
  Color radiance = ambient_of(material, ambient);
  for (const LightOf<Color>& light : lights) {
    radiance =
        detail::sum(radiance, direct_of(material, model, normal, to_eye, incident(light, point)));
  }
  return radiance;
}

}  // namespace

double lambert(const Vector3d& normal, const Vector3d& to_light) noexcept {
  const double n_dot_l = dot(precise(normal), precise(to_light)).hi;
  return n_dot_l > 0 ? n_dot_l : 0;
}

double phong_lobe(const Vector3d& normal, const Vector3d& to_light, const Vector3d& to_eye,
                  double n) noexcept {
  const detail::PreciseVector light = precise(to_light);
  const detail::PreciseVector up = precise(normal);
  if (!(dot(up, light).hi > 0)) return 0;
  return detail::lobe_power(detail::r_dot_v(up, light, precise(to_eye)), n);
}

double blinn_phong_lobe(const Vector3d& normal, const Vector3d& to_light, const Vector3d& to_eye,
                        double n) noexcept {
  const detail::PreciseVector light = precise(to_light);
  const detail::PreciseVector up = precise(normal);
  if (!(dot(up, light).hi > 0)) return 0;
  return detail::lobe_power(dot(up, detail::half_vector(light, precise(to_eye))), n);
}

Rgb ambient_reflection(const Material& material, const Rgb& ambient) noexcept {
  return ambient_of(material, ambient);
}

SpectralColor ambient_reflection(const SpectralMaterial& material,
                                 const SpectralColor& ambient) noexcept {
  return ambient_of(material, ambient);
}

Rgb direct_reflection(const Material& material, const SpecularModel& model, const Vector3d& normal,
                      const Vector3d& to_eye, const Incident& incident) noexcept {
  return direct_of(material, model, normal, to_eye, incident);
}

SpectralColor direct_reflection(const SpectralMaterial& material, const SpecularModel& model,
                                const Vector3d& normal, const Vector3d& to_eye,
                                const SpectralIncident& incident) noexcept {
  return direct_of(material, model, normal, to_eye, incident);
}

Rgb shade(const Material& material, const SpecularModel& model, const Vector3d& normal,
          const Vector3d& to_eye, const Vector3d& point, const Rgb& ambient,
          std::span<const Light> lights) noexcept {
  return shade_of(material, model, normal, to_eye, point, ambient, lights);
}

SpectralColor shade(const SpectralMaterial& material, const SpecularModel& model,
                    const Vector3d& normal, const Vector3d& to_eye, const Vector3d& point,
                    const SpectralColor& ambient, std::span<const SpectralLight> lights) noexcept {
  return shade_of(material, model, normal, to_eye, point, ambient, lights);
}

}  // namespace tristim
