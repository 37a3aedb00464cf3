#include <array>

#include "tools/report.h"
#include "tools/shade_model.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/light/phong.h"
#include "tristim/light/spectral.h"

namespace tristim::tools {
namespace {

SpectralColor illuminant_of(const JsonRow& in) {
  const std::string name = in.text("illuminant");
  const Illuminant* found = find_by_name(illuminants(), name);
  if (found == nullptr) {
    in.refuse("illuminant", "is unknown: " + name, name_hint(illuminants(), name));
  }
  return sampled_illuminant(*found);
}

SpectralColor reflectance_of(const JsonRow& in) {
  const std::string kind = in.text("kind");
  const ReflectanceShape* shape = find_by_name(kReflectanceShapes, kind);
  if (shape == nullptr) {
    in.refuse("kind", "is unknown: " + kind, name_hint(kReflectanceShapes, kind));
  }
  const double mu2 = shape->two_peaks ? in.number("mu2") : 0;
  const double sd = in.above_zero("sd");
  SpectralColor color;
  for (std::size_t i = 0; i < kSpectralSamples; ++i) {
    color.at[i] =
        shape->at(sample_nm(i), in.number("lo"), in.number("hi"), in.number("mu"), mu2, sd);
  }
  return color;
}

// "phong" and "blinn", as the outputs of local_illumination are named, or the model's own name.
const SpecularModel& specular_model(const JsonRow& in) {
  const std::string name = in.text("spec");
  if (same_name(name, "blinn")) return *find_by_name(kSpecularModels, kBlinnPhong.name);
  const SpecularModel* found = find_by_name(kSpecularModels, name);
  if (found == nullptr) in.refuse("spec", "is unknown: " + name, "use phong or blinn");
  return *found;
}

SpectralColor scaled(double factor, SpectralColor color) {
  for (double& sample : color.at) sample *= factor;
  return color;
}

Json xyz_json(const Xyz& xyz) {
  return {number_json(xyz.x), number_json(xyz.y), number_json(xyz.z)};
}

constexpr Column kIn[] = {
    {"illuminant", kJson}, {"reflectance", kJson}, {"L", kJson},   {"N", kJson}, {"V", kJson},
    {"ka", kJson},         {"kd", kJson},          {"ks", kJson},  {"n", kJson}, {"fatt", kJson},
    {"Os", kJson},         {"Ia_scale", kJson},    {"spec", kJson}};
constexpr Column kExpect[] = {{"expect", kJson}};

Json spectral(const JsonRow& in) {
  const SpectralColor white = illuminant_of(in);
  const SpectralMaterial material{.ka = in.number("ka"),
                                  .kd = in.number("kd"),
                                  .ks = in.number("ks"),
                                  .n = in.not_negative("n"),
                                  .od = reflectance_of(in.object("reflectance")),
                                  .os = flat_spectrum(in.number("Os"))};
  const SpectralIncident arriving{in.vector("L"), scaled(in.number("fatt"), white)};
  const SpectralColor ambient = ambient_reflection(material, scaled(in.number("Ia_scale"), white));
  SpectralColor light =
      direct_reflection(material, specular_model(in), in.vector("N"), in.vector("V"), arriving);
  for (std::size_t i = 0; i < kSpectralSamples; ++i) light.at[i] += ambient.at[i];
  return {{"expect",
           {{"XYZ", xyz_json(xyz_of_samples(light, white))},
            {"white_XYZ", xyz_json(xyz_of_samples(white, white))}}}};
}

constexpr std::array kModels{
    ShadeModel{"spectral",
               "ka Ia_scale P O + fatt P (kd O N.L + ks Os s) at 81 wavelengths, summed to XYZ",
               "[Shoaff 3.7, CIE15]", kIn, kExpect, nullptr, spectral},
};

}  // namespace

std::span<const ShadeModel> spectral_models() { return kModels; }

}  // namespace tristim::tools
