#include "lib/render/scene_check.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

void check(const std::string& what, double value, bool good, const char* expected) {
  if (good) return;
  throw std::invalid_argument(what + ": " + shortest(value) + "; expected " + expected);
}

void check_finite(const std::string& what, const Rgb& color) {
  for (const double value : {color.r, color.g, color.b}) {
    check(what, value, std::isfinite(value), "a finite number");
  }
}

void check_finite(const std::string& what, const Eigen::Vector3d& v) {
  for (const double value : {v.x(), v.y(), v.z()}) {
    check(what, value, std::isfinite(value), "a finite number");
  }
}

void check_material(const SceneMaterial& material) {
  const std::string name = "material '" + material.name + "': ";
  const Material& surface = material.surface;
  for (const double k : {surface.ka, surface.kd, surface.ks}) {
    check(name + "ka, kd or ks", k, std::isfinite(k), "a finite number");
  }
  // A highlight of blinn_minus_phong has four times the exponent.
  check(name + "n", surface.n, surface.n >= 0 && surface.n <= 250000, "0 to 250000");
  check_finite(name + "od", surface.od);
  check_finite(name + "os", surface.os);
  const double m = material.rough.facets.m;
  check(name + "m", m, m >= 1e-4 && m <= 1e4, "0.0001 to 10000");
  const double kt = material.transparent.kt;
  check(name + "kt", kt, kt >= 0 && kt <= 1, "0 to 1");
  check_finite(name + "ot", material.transparent.tint);
}

void check_spot(const std::string& name, const SpotLight& spot) {
  check(name + "cutoff_deg", spot.cutoff_deg, spot.cutoff_deg >= 0 && spot.cutoff_deg <= 180,
        "0 to 180");
  check(name + "exponent", spot.exponent, spot.exponent >= 0 && spot.exponent <= 1e6, "0 to 1e6");
  check_finite(name + "direction", spot.direction);
}

void check_light(const SceneLight& light) {
  const std::string name = "light '" + light.name + "': ";
  std::visit(
      [&](const auto& source) {
        using Source = std::decay_t<decltype(source)>;
        check_finite(name + "intensity", source.intensity);
        if constexpr (std::is_same_v<Source, SpotLight>) check_spot(name, source);
        if constexpr (std::is_same_v<Source, DirectionalLight>) {
          check_finite(name + "to_light", source.to_light);
        } else if constexpr (std::is_same_v<Source, PolygonLight>) {
          for (const Eigen::Vector3d& corner : source.polygon) {
            check_finite(name + "polygon", corner);
          }
          check(name + "samples", source.samples, source.samples >= 1 && source.samples <= 64,
                "1 to 64");
        } else {
          check_finite(name + "position", source.position);
        }
      },
      light.source);
}

}  // namespace

void check_scene(const Scene& scene) {
  check_finite("ambient", scene.ambient);
  for (const SceneMaterial& material : scene.materials) check_material(material);
  for (const SceneLight& light : scene.lights) check_light(light);
  const EdgeLines& edges = scene.edges;
  check("width of edges", edges.width, edges.width > 0 && edges.width <= 1000, "above 0, to 1000");
  check("crease_deg", edges.crease_deg, edges.crease_deg >= 0 && edges.crease_deg <= 180,
        "0 to 180");
}

}  // namespace tristim::detail
