#include "lib/render/looks.h"

#include <Eigen/Core>

#include "lib/light/product.h"
#include "tristim/color/illuminant.h"
#include "tristim/color/primaries.h"
#include "tristim/core/find.h"
#include "tristim/light/spectral.h"

namespace tristim::detail {
namespace {

// Light or a reflectance, with its spectrum where it has one.
struct Color {
  Rgb rgb;
  const SpectralColor* spectrum = nullptr;
};

class Mixer {
 public:
  explicit Mixer(const Scene& scene)
      : d65_(sampled_illuminant(*find_by_name(illuminants(), "D65"))),
        white_(scene.white.value_or(d65_)) {}

  Color light(const Rgb& rgb, const std::optional<SpectralColor>& spectrum) const {
    if (!spectrum) return {rgb};
    return {rgb_of(*spectrum, white_), &*spectrum};
  }

  Color surface(const Rgb& rgb, const SpectralColor* spectrum) const {
    if (spectrum == nullptr) return {rgb};
    return {rgb_of(product(d65_, *spectrum), d65_), spectrum};
  }

  Rgb reflected(const Color& light, const Color& surface, double k) const {
    if (light.spectrum != nullptr && surface.spectrum != nullptr) {
      return product(k, rgb_of(product(*light.spectrum, *surface.spectrum), white_));
    }
    return product(k, product(light.rgb, surface.rgb));
  }

 private:
  Rgb rgb_of(const SpectralColor& light, const SpectralColor& white) const {
    const Xyz xyz = xyz_of_samples(light, white);
    const Eigen::Vector3d rgb = rgb_from_xyz_ * Eigen::Vector3d(xyz.x, xyz.y, xyz.z);
    return {rgb.x(), rgb.y(), rgb.z()};
  }

  SpectralColor d65_;
  SpectralColor white_;
  Eigen::Matrix3d rgb_from_xyz_ = rgb_from_xyz(Primaries{});
};

Rgb intensity_of(const SceneLight& light) {
  return std::visit([](const auto& source) { return source.intensity; }, light.source);
}

MaterialLook look_of(const Mixer& mixer, const Scene& scene, const SceneMaterial& material) {
  const Material& surface = material.surface;
  const auto* spectral = material.spectral ? &*material.spectral : nullptr;
  const Color od = mixer.surface(surface.od, spectral != nullptr ? &spectral->od : nullptr);
  const Color os = mixer.surface(surface.os, spectral != nullptr ? &spectral->os : nullptr);
  MaterialLook look;
  look.ambient =
      mixer.reflected(mixer.light(scene.ambient, scene.ambient_spectrum), od, surface.ka);
  look.flat = od.rgb;
  look.albedo = product(surface.kd, od.rgb);
  for (const SceneLight& light : scene.lights) {
    const Color arriving = mixer.light(intensity_of(light), light.spectrum);
    look.lights.push_back(
        {mixer.reflected(arriving, od, surface.kd), mixer.reflected(arriving, os, surface.ks)});
  }
  return look;
}

}  // namespace

std::vector<MaterialLook> looks_of(const Scene& scene) {
  const Mixer mixer(scene);
  std::vector<MaterialLook> looks;
  for (const SceneMaterial& material : scene.materials) {
    looks.push_back(look_of(mixer, scene, material));
  }
  return looks;
}

}  // namespace tristim::detail
