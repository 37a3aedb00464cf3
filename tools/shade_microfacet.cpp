#include <array>

#include "tools/shade_model.h"
#include "tristim/light/fresnel.h"
#include "tristim/light/microfacet.h"

namespace tristim::tools {
namespace {

constexpr ColumnKind kTheta{"", "0 or more, below 90", [](double x) { return x >= 0 && x < 90; }};

constexpr Column kDensityIn[] = {{"cos_beta", kNumber}, {"m", kAboveZero}};
constexpr Column kDensityOut[] = {{"D_gauss_c1eq1", kNumber},
                                  {"D_beckmann_seed", kNumber},
                                  {"D_beckmann_normalised", kNumber},
                                  {"D_blinn_n_2overm2minus2", kNumber}};
void densities(const ShadeRow& in, ShadeRow& out) {
  const double cos_beta = in.number("cos_beta");
  const double m = in.number("m");
  const double beckmann = microfacet_density(kBeckmann, cos_beta, m);
  out.set("D_gauss_c1eq1", microfacet_density(kGauss, cos_beta, m));
  out.set("D_beckmann_seed", beckmann);
  out.set("D_beckmann_normalised", beckmann * microfacet_normaliser(kBeckmann, m));
  out.set("D_blinn_n_2overm2minus2", microfacet_density(kBlinn, cos_beta, m));
}

constexpr Column kRoughness[] = {{"m", kAboveZero}};
constexpr Column kNormaliserOut[] = {{"c1_gauss", kNumber}, {"c_beckmann", kNumber}};
void normalisers(const ShadeRow& in, ShadeRow& out) {
  out.set("c1_gauss", microfacet_normaliser(kGauss, in.number("m")));
  out.set("c_beckmann", microfacet_normaliser(kBeckmann, in.number("m")));
}

constexpr Column kDielectricIn[] = {
    {"cos_i", kNumber}, {"eta_i", kAboveZero}, {"eta_t", kAboveZero}};
constexpr Column kFresnelOut[] = {{"F", kNumber}};
void dielectric(const ShadeRow& in, ShadeRow& out) {
  out.set("F", fresnel_dielectric(in.number("cos_i"), in.number("eta_i"), in.number("eta_t")));
}

constexpr Column kFormsOut[] = {{"F_angles", kNumber}, {"F_indices", kNumber}};
void fresnel_forms(const ShadeRow& in, ShadeRow& out) {
  for (const FresnelForm& form : kFresnelForms) {
    out.set("F_" + std::string(form.name),
            form.reflectance(in.number("cos_i"), in.number("eta_i"), in.number("eta_t")));
  }
}

constexpr Column kConductorIn[] = {{"cos_i", kNumber}, {"eta", kAboveZero}, {"k", kNotNegative}};
void conductor(const ShadeRow& in, ShadeRow& out) {
  out.set("F", fresnel_conductor(in.number("cos_i"), in.number("eta"), in.number("k")));
}

constexpr Column kEtaIn[] = {{"eta", kAboveZero}};
constexpr Column kEtaOut[] = {{"F0", kNumber}, {"eta_from_F0", kNumber}};
void f0_eta(const ShadeRow& in, ShadeRow& out) {
  const double f0 = f0_from_eta(in.number("eta"));
  out.set("F0", f0);
  out.set("eta_from_F0", eta_from_f0(f0));
}

constexpr Column kSurfaceIn[] = {{"L", kVector},    {"N", kVector},        {"V", kVector},
                                 {"m", kAboveZero}, {"eta_i", kAboveZero}, {"eta_t", kAboveZero}};
constexpr Column kSurfaceOut[] = {{"G_b", kNumber},
                                  {"G_s", kNumber},
                                  {"G", kNumber},
                                  {"rho_s_gauss_seed", kNumber},
                                  {"rho_s_beckmann_seed", kNumber},
                                  {"rho_s_beckmann_energy", kNumber}};
void surface(const ShadeRow& in, ShadeRow& out) {
  const Eigen::Vector3d l = in.vector("L");
  const Eigen::Vector3d n = in.vector("N");
  const Eigen::Vector3d v = in.vector("V");
  const Reflector reflector = Dielectric{in.number("eta_i"), in.number("eta_t")};
  const auto rho_s = [&](const MicrofacetDistribution& distribution,
                         const MicrofacetNormalization& normalization) {
    return torrance_sparrow({distribution, normalization, in.number("m")}, reflector, n, l, v);
  };
  const GeometricAttenuation g = geometric_attenuation(n, l, v);
  out.set("G_b", g.blocked);
  out.set("G_s", g.shadowed);
  out.set("G", g.factor);
  out.set("rho_s_gauss_seed", rho_s(kGauss, kSeedNormalization));
  out.set("rho_s_beckmann_seed", rho_s(kBeckmann, kSeedNormalization));
  out.set("rho_s_beckmann_energy", rho_s(kBeckmann, kEnergyNormalization));
}

constexpr Column kAlbedoIn[] = {
    {"theta_deg", kTheta}, {"m", kAboveZero}, {"eta", kAboveZero}, {"k", kNotNegative}};
constexpr Column kAlbedoOut[] = {{"albedo_seed", kNumber}, {"albedo_energy", kNumber}};
void albedo(const ShadeRow& in, ShadeRow& out) {
  const Reflector metal = Conductor{in.number("eta"), in.number("k")};
  for (const MicrofacetNormalization& normalization : kMicrofacetNormalizations) {
    const Microfacets rough{kBeckmann, normalization, in.number("m")};
    out.set("albedo_" + std::string(normalization.name),
            directional_albedo(rough, metal, in.number("theta_deg")));
  }
}

constexpr std::array kModels{
    ShadeModel{"microfacet_D",
               "exp(-(beta/m)^2); exp(-(tan beta/m)^2)/(m^2 cos^4 beta), and over pi; "
               "(n + 2)/(2 pi) cos^n beta, n = max(2/m^2 - 2, 0)",
               "[Torrance67, Beckmann63, Blinn77]", kDensityIn, kDensityOut, densities},
    ShadeModel{"microfacet_normaliser", "c of the integral of c D cos beta = 1", "[Walter07]",
               kRoughness, kNormaliserOut, normalisers},
    ShadeModel{"fresnel_dielectric", kFresnelForms[1].formula, kFresnelForms[1].source,
               kDielectricIn, kFresnelOut, dielectric},
    ShadeModel{"fresnel_forms", kFresnelForms[0].formula, kFresnelForms[0].source, kDielectricIn,
               kFormsOut, fresnel_forms},
    ShadeModel{"fresnel_conductor", "Fresnel's equations with the index eta + i k, from vacuum",
               "[Born99 14.2]", kConductorIn, kFresnelOut, conductor},
    ShadeModel{"f0_eta", "F0 = ((eta - 1)/(eta + 1))^2, eta = (1 + sqrt F0)/(1 - sqrt F0)",
               "[Shoaff 3.8.1]", kEtaIn, kEtaOut, f0_eta},
    ShadeModel{"torrance_sparrow", "seed F D G/(pi N.V N.L), energy F (D/pi) G/(4 N.V N.L)",
               "[Shoaff 3.8.1, Cook82, Walter07]", kSurfaceIn, kSurfaceOut, surface},
    ShadeModel{"directional_albedo", "the integral of rho_s N.V over the hemisphere, Beckmann",
               "[Walter07]", kAlbedoIn, kAlbedoOut, albedo},
};

}  // namespace

std::span<const ShadeModel> microfacet_models() { return kModels; }

}  // namespace tristim::tools
