#include "lib/render/looks.h"

#include <Eigen/Core>
#include <array>

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

Rgb times(const Rgb& a, const std::array<double, 3>& b) noexcept {
  return {a.r * b[0], a.g * b[1], a.b * b[2]};
}

Rgb intensity_of(const SceneLight& light) {
  return std::visit([](const auto& source) { return source.intensity; }, light.source);
}

// Light times Os times F, by the cosine of V.H.
FresnelTable highlight_of(const Mixer& mixer, const SceneMaterial& material, const Color& light,
                          const Color& os) {
  const RoughSurface& rough = material.rough;
  if (rough.spectral) {
    return FresnelTable([&](double cosine) {
      SpectralColor reflected = os.spectrum != nullptr ? *os.spectrum : kWhiteOf<SpectralColor>;
      for (std::size_t i = 0; i < kSpectralSamples; ++i) {
        reflected.at[i] *= fresnel((*rough.spectral)[i], cosine);
      }
      const Rgb own = os.spectrum != nullptr ? Rgb{1, 1, 1} : os.rgb;
      const Color surface = mixer.surface({}, &reflected);
      return product(own, mixer.reflected(light, surface, material.surface.ks));
    });
  }
  const Rgb color = mixer.reflected(light, os, material.surface.ks);
  return FresnelTable([&](double cosine) {
    return times(color, {fresnel(rough.reflectors[0], cosine), fresnel(rough.reflectors[1], cosine),
                         fresnel(rough.reflectors[2], cosine)});
  });
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
  const bool tabled =
      material.model.name == kMicrofacetReflection.name && row_dielectric(material) == nullptr;
  for (const SceneLight& light : scene.lights) {
    const Color arriving = mixer.light(intensity_of(light), light.spectrum);
    look.lights.push_back(
        {mixer.reflected(arriving, od, surface.kd), mixer.reflected(arriving, os, surface.ks)});
    if (tabled) look.highlights.push_back(highlight_of(mixer, material, arriving, os));
  }
  return look;
}

}  // namespace

const Dielectric* row_dielectric(const SceneMaterial& material) {
  const RoughSurface& rough = material.rough;
  if (rough.spectral || rough.facets.distribution.name != kBeckmann.name ||
      rough.facets.normalization.name != kEnergyNormalization.name) {
    return nullptr;
  }
  const auto* first = std::get_if<Dielectric>(&rough.reflectors[0]);
  for (const Reflector& each : rough.reflectors) {
    const auto* other = std::get_if<Dielectric>(&each);
    if (first == nullptr || other == nullptr || first->eta_i != other->eta_i ||
        first->eta_t != other->eta_t) {
      return nullptr;
    }
  }
  return first;
}

std::vector<MaterialLook> looks_of(const Scene& scene) {
  const Mixer mixer(scene);
  std::vector<MaterialLook> looks;
  for (const SceneMaterial& material : scene.materials) {
    looks.push_back(look_of(mixer, scene, material));
  }
  return looks;
}

}  // namespace tristim::detail
