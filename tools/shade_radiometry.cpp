#include <array>

#include "tools/report.h"
#include "tools/shade_model.h"
#include "tristim/light/microfacet.h"
#include "tristim/light/radiometry.h"

namespace tristim::tools {
namespace {

using Eigen::Vector3d;

constexpr ColumnKind kHalfAngle{"", "0 to 180", [](double x) { return x >= 0 && x <= 180; }};

constexpr Column kConeIn[] = {{"half_angle_deg", kHalfAngle}, {"flux", kNotNegative}};
constexpr Column kConeOut[] = {{"solid_angle_sr", kNumber}, {"radiant_intensity", kNumber}};
void cone(const ShadeRow& in, ShadeRow& out) {
  const double solid_angle = cone_solid_angle_sr(in.number("half_angle_deg"));
  out.set("solid_angle_sr", solid_angle);
  out.set("radiant_intensity", radiant_intensity(in.number("flux"), solid_angle));
}

constexpr Column kRadianceIn[] = {
    {"I", kNotNegative}, {"A", kNotNegative}, {"N", kVector}, {"V", kVector}};
constexpr Column kRadianceOut[] = {{"foreshortened_area", kNumber}, {"radiance", kNumber}};
void seen_radiance(const ShadeRow& in, ShadeRow& out) {
  const Vector3d n = in.vector("N");
  const Vector3d v = in.vector("V");
  out.set("foreshortened_area", foreshortened_area(in.number("A"), n, v));
  out.set("radiance", radiance(in.number("I"), in.number("A"), n, v));
}

constexpr Column kIrradianceIn[] = {{"Ii", kNotNegative},     {"N", kVector},    {"L", kVector},
                                    {"domega", kNotNegative}, {"kd", kNumber},   {"rho_d", kNumber},
                                    {"ks", kNumber},          {"rho_s", kNumber}};
constexpr Column kIrradianceOut[] = {{"E_i", kNumber}, {"rho", kNumber}, {"I_r", kNumber}};
void reflected(const ShadeRow& in, ShadeRow& out) {
  const double e = irradiance(in.number("Ii"), in.vector("N"), in.vector("L"), in.number("domega"));
  const double rho =
      reflectivity({in.number("kd"), in.number("ks")}, in.number("rho_d"), in.number("rho_s"));
  out.set("E_i", e);
  out.set("rho", rho);
  out.set("I_r", e * rho);
}

constexpr Column kSourcesIn[] = {{"N", kJson},     {"V", kJson},     {"kd", kJson},
                                 {"ks", kJson},    {"rho_d", kJson}, {"m", kJson},
                                 {"eta_t", kJson}, {"Ia", kJson},    {"lights", kJson}};
constexpr Column kExpect[] = {{"expect", kJson}};
Json n_sources(const JsonRow& in) {
  const Vector3d n = in.vector("N");
  const Vector3d v = in.vector("V");
  const Microfacets rough{.m = in.above_zero("m")};
  const Reflector glass = Dielectric{1, in.above_zero("eta_t")};
  std::vector<RadiantSource> sources;
  Json irradiances = Json::array();
  for (const JsonRow& light : in.objects("lights")) {
    const Vector3d l = light.vector("L");
    sources.push_back(
        {l, light.number("I"), light.number("domega"), torrance_sparrow(rough, glass, n, l, v)});
    irradiances.push_back(
        number_json(irradiance(sources.back().radiance, n, l, sources.back().domega_sr)));
  }
  const double radiance = reflected_radiance({in.number("kd"), in.number("ks")}, in.number("rho_d"),
                                             in.number("Ia"), n, sources);
  return {{"expect", {{"E_i", irradiances}, {"I_r", number_json(radiance)}}}};
}

constexpr std::array kModels{
    ShadeModel{"solid_angle", "2 pi (1 - cos), flux over it", "[Shoaff 3.8]", kConeIn, kConeOut,
               cone},
    ShadeModel{"radiance", "I/(A N.V)", "[Shoaff 3.8]", kRadianceIn, kRadianceOut, seen_radiance},
    ShadeModel{"reflectivity", "E_i = Ii N.L domega, rho = kd rho_d + ks rho_s, I_r = rho E_i",
               "[Shoaff 3.8]", kIrradianceIn, kIrradianceOut, reflected},
    ShadeModel{"radiometry", "I_r = rho_d Ia + sum I N.L domega (kd rho_d + ks rho_s)",
               "[Shoaff 3.8]", kSourcesIn, kExpect, nullptr, n_sources},
};

}  // namespace

std::span<const ShadeModel> radiometry_models() { return kModels; }

}  // namespace tristim::tools
