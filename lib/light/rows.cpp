#include "tristim/light/rows.h"

#include <hwy/base.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>

#include "lib/core/lanes_scalar.h"
#include "lib/light/degrees.h"
#include "lib/light/product.h"
#include "lib/light/rows_constants.h"
#include "tristim/core/text.h"
#include "tristim/light/vector.h"

namespace tristim {
namespace detail {
namespace {

// clang-format off: each builds on those before
#include "lib/core/power-inl.h"
#include "lib/light/rows_geometry-inl.h"
#include "lib/light/rows_kernel-inl.h"
#include "lib/light/rows_lobes-inl.h"
// clang-format on

constexpr double kPi = 3.14159265358979323846;
constexpr double kLog2E = 1.4426950408889634;

void set_place(RowLight& light, const Eigen::Vector3d& place) {
  light.x = place.x();
  light.y = place.y();
  light.z = place.z();
}

void set_attenuation(RowLight& light, const Attenuation& a) {
  const std::string_view kind = a.kind.name;
  light.attenuated = kind != "none";
  light.beer_lambert = kind == "beer_lambert";
  light.most = kind == "clamped_quadratic" ? 1 : 1e18F;
  const double c1 = light.beer_lambert ? -kLog2E * a.c1 : kind == "inverse_square" ? 0 : a.c1;
  const double c2 = kind == "inverse_square" ? 0 : a.c2;
  const double c3 = kind == "inverse_square" ? 1 : kind == "linear" ? 0 : a.c3;
  light.c1 = static_cast<float>(c1);
  light.c2 = static_cast<float>(c2);
  light.c3 = static_cast<float>(c3);
}

// Sums of so many terms stay finite.
float limited(double value, double most) {
  return static_cast<float>(std::clamp(value, -most, most));
}

void check(const char* what, double value, bool good, const char* expected) {
  if (good) return;
  throw std::invalid_argument(std::string(what) + ": " + shortest(value) + "; expected " +
                              expected);
}

void set_spot(RowLight& light, const SpotLight& spot) {
  const double cutoff = spot.cutoff_deg;
  check("cutoff of a spot", cutoff, cutoff >= 0 && cutoff <= 180, "0 to 180");
  check("exponent of a spot", spot.exponent, spot.exponent >= 0 && spot.exponent <= 1e6,
        "0 to 1e6");
  light.spot = cutoff < 180;
  const Eigen::Vector3d back = normalize(-spot.direction);
  light.axis_x = back.x();
  light.axis_y = back.y();
  light.axis_z = back.z();
  const double edge = cos_deg(cutoff);
  constexpr double kRounding = 1e-15;  // what lies on the edge is inside
  light.edge2 = edge * std::fabs(edge) - kRounding;
  light.spot_exponent = exponent_of(spot.exponent / 2);
}

struct PlacedLight {
  RowLight row;
  Rgb intensity;
};

PlacedLight placed(const DirectionalLight& light) {
  PlacedLight at{.row = {}, .intensity = light.intensity};
  at.row.directional = true;
  set_place(at.row, normalize(light.to_light));
  return at;
}

// A point light or a spot.
template <class Lamp>
PlacedLight placed(const Lamp& light) {
  PlacedLight at{.row = {}, .intensity = light.intensity};
  set_place(at.row, light.position);
  set_attenuation(at.row, light.attenuation);
  if constexpr (std::is_same_v<Lamp, SpotLight>) set_spot(at.row, light);
  return at;
}

void set_colors(RowLight& row, const RowLightColors& colors, double diffuse_scale, double most) {
  row.diffuse_r = limited(diffuse_scale * colors.diffuse.r, most);
  row.diffuse_g = limited(diffuse_scale * colors.diffuse.g, most);
  row.diffuse_b = limited(diffuse_scale * colors.diffuse.b, most);
  row.specular_r = limited(colors.specular.r, most);
  row.specular_g = limited(colors.specular.g, most);
  row.specular_b = limited(colors.specular.b, most);
}

void add_lights(RowConstants& c, const RowShading& shading, double most) {
  const Material& material = shading.material;
  const Rgb diffuse = product(material.kd, material.od);
  const Rgb specular = product(material.ks, material.os);
  const double diffuse_scale = c.lobe == RowLobe::kCookTorrance ? 1 / kPi : 1;
  for (std::size_t i = 0; i < shading.lights.size(); ++i) {
    auto [row, intensity] =
        std::visit([](const auto& each) { return placed(each); }, shading.lights[i]);
    const RowLightColors own{product(intensity, diffuse), product(intensity, specular)};
    set_colors(row, shading.colors.empty() ? own : shading.colors[i], diffuse_scale, most);
    c.lights.push_back(row);
  }
}

void check_sizes(const SurfaceRows& s, const LightRows& out) {
  const std::size_t size = s.x.size();
  for (const std::size_t other : {s.y.size(), s.z.size(), s.nx.size(), s.ny.size(), s.nz.size(),
                                  out.r.size(), out.g.size(), out.b.size()}) {
    check("samples of a row", static_cast<double>(other), other == size, "as many as in the first");
  }
}

// The part that differs between the models.
void set_lobe(RowConstants& c, const RowShading& shading) {
  const Material& material = shading.material;
  c.exponent = exponent_of(material.n / 2);
  if (shading.model.name == kPhongRows.name) c.lobe = RowLobe::kPhong;
  if (shading.model.name == kBlinnPhongRows.name) c.lobe = RowLobe::kBlinnPhong;
  if (shading.model.name != kCookTorranceRows.name) return;
  const double m2 = shading.m * shading.m;
  c.lobe = RowLobe::kCookTorrance;
  c.tangent_scale = -kLog2E / m2;
  c.tangent_unscale = static_cast<float>(-m2 / kLog2E);
  c.eta2_minus_1 = static_cast<float>((shading.eta - 1) * (shading.eta + 1));
  c.lobe_scale = static_cast<float>(1 / (4 * kPi * m2));
}

}  // namespace

RowConstants row_constants(const RowShading& shading, const SurfaceRows& surface,
                           const LightRows& light) {
  check_sizes(surface, light);
  const Material& material = shading.material;
  check("exponent n", material.n, material.n >= 0 && material.n <= 1e6, "0 to 1e6");
  check("roughness m", shading.m, shading.m >= 1e-4 && shading.m <= 1e4, "0.0001 to 10000");
  check("index eta", shading.eta, shading.eta > 0 && shading.eta <= 1e6, "above 0, to 1e6");
  RowConstants c;
  set_lobe(c, shading);
  check("colors", static_cast<double>(shading.colors.size()),
        shading.colors.empty() || shading.colors.size() == shading.lights.size(),
        "none, or one for each light");
  const double most = 1e18 / (1.0 + static_cast<double>(shading.lights.size()));
  add_lights(c, shading, most);
  c.local_viewer = shading.local_viewer;
  const Eigen::Vector3d eye = c.local_viewer ? shading.eye : normalize(shading.eye);
  c.eye_x = eye.x();
  c.eye_y = eye.y();
  c.eye_z = eye.z();
  const Rgb ambient = ambient_reflection(material, shading.ambient);
  c.ambient_r = limited(ambient.r, most);
  c.ambient_g = limited(ambient.g, most);
  c.ambient_b = limited(ambient.b, most);
  return c;
}

void shade_rows_scalar(const RowShading& shading, const SurfaceRows& surface,
                       const LightRows& light) {
  shade_with_lobe<ScalarLanes>(row_constants(shading, surface, light), surface, light);
}

void power_row_scalar(std::span<const float> x, float n, std::span<float> out) noexcept {
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = power_of<ScalarLanes>(&x[i], double{n});
}

}  // namespace detail

void shade_rows(const RowShading& shading, const SurfaceRows& surface, const LightRows& light) {
  detail::shade_rows_simd(detail::row_constants(shading, surface, light), surface, light);
}

void power_row(std::span<const float> x, float n, std::span<float> out) noexcept {
  detail::power_row_simd(x, n, out);
}

}  // namespace tristim
