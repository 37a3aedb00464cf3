#include "lib/render/row_models.h"

#include <algorithm>
#include <variant>

#include "lib/light/product.h"
#include "tristim/light/area.h"
#include "tristim/light/gooch.h"
#include "tristim/light/vector.h"

namespace tristim::detail {
namespace {

using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;

// A sample of the rows, in double.
struct Point {
  Vector3d at, normal, to_eye;
};

Point point_of(const RowModelJob& job, const SurfaceRows& s, std::size_t i) {
  const Vector3d at(s.x[i], s.y[i], s.z[i]);
  const Vector3d normal = normalize(Vector3d(s.nx[i], s.ny[i], s.nz[i]));
  return {at, normal, job.local_viewer ? view_vector(at, job.eye) : normalize(job.eye)};
}

void add(const LightRows& out, std::size_t i, const Rgb& color) {
  out.r[i] += static_cast<float>(color.r);
  out.g[i] += static_cast<float>(color.g);
  out.b[i] += static_cast<float>(color.b);
}

// Microfacets that the rows have in single precision: Beckmann's, with one index.
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

void run_rows(const RowModelJob& job, const RowModel& model, const SurfaceRows& surface,
              const LightRows& out) {
  RowShading shading{.model = job.specular ? model : kLambertRows};
  shading.material = {.ka = 1, .n = job.material.surface.n};
  shading.ambient = job.ambient;
  shading.eye = job.eye;
  shading.local_viewer = job.local_viewer;
  shading.lights = job.lights;
  std::vector<RowLightColors> colors = job.colors;
  if (const Dielectric* dielectric = row_dielectric(job.material)) {
    shading.m = job.material.rough.facets.m;
    shading.eta = dielectric->eta_t / dielectric->eta_i;
  }
  if (!job.specular && model.name == kCookTorranceRows.name) {
    for (RowLightColors& each : colors) each.diffuse = product(1 / kPi, each.diffuse);
  }
  shading.colors = colors;
  shade_rows(shading, surface, out);
}

void run_gooch(const RowModelJob& job, const SurfaceRows& surface, const LightRows& out) {
  RowModelJob highlights{.material = job.material, .look = job.look};
  highlights.eye = job.eye;
  highlights.local_viewer = job.local_viewer;
  for (std::size_t k = 0; k < job.lights.size(); ++k) {
    if (job.index[k] != 0) continue;
    highlights.lights.push_back(job.lights[k]);
    highlights.colors.push_back({{}, job.colors[k].specular});
  }
  run_rows(highlights, kPhongRows, surface, out);
  const bool toned = !job.lights.empty() && job.index[0] == 0 && job.tones;
  if (!toned) return;
  for (std::size_t i = 0; i < surface.x.size(); ++i) {
    const Point p = point_of(job, surface, i);
    const Incident arriving = incident(job.lights[0], p.at);
    add(out, i,
        gooch(p.normal, arriving.to_light, job.material.gooch.warm, job.material.gooch.cool));
  }
}

// rho_s in colour times f_att N.L, for a light of intensity 1.
Rgb rough_highlight(const RowModelJob& job, const Point& p, const Incident& arriving) {
  const RoughSurface& rough = job.material.rough;
  const double irradiance = arriving.intensity.r * std::max(dot(p.normal, arriving.to_light), 0.0);
  return product(irradiance, torrance_sparrow(rough.facets, rough.reflectors, p.normal,
                                              arriving.to_light, p.to_eye));
}

Light with_unit_intensity(Light light) {
  std::visit([](auto& each) { each.intensity = {1, 1, 1}; }, light);
  return light;
}

void run_definition(const RowModelJob& job, const SurfaceRows& surface, const LightRows& out) {
  RowModelJob matte = job;
  matte.specular = false;
  run_rows(matte, kCookTorranceRows, surface, out);
  if (!job.specular) return;
  for (std::size_t k = 0; k < job.lights.size(); ++k) {
    const Light light = with_unit_intensity(job.lights[k]);
    for (std::size_t i = 0; i < surface.x.size(); ++i) {
      const Point p = point_of(job, surface, i);
      add(out, i, product(rough_highlight(job, p, incident(light, p.at)), job.colors[k].specular));
    }
  }
}

}  // namespace

void run_row_model(const RowModelJob& job, const SurfaceRows& surface, const LightRows& out) {
  const std::string_view model = job.material.model.name;
  if (model == kPhongReflection.name) return run_rows(job, kPhongRows, surface, out);
  if (model == kBlinnReflection.name) return run_rows(job, kBlinnPhongRows, surface, out);
  if (model == kGoochReflection.name) return run_gooch(job, surface, out);
  if (row_dielectric(job.material) != nullptr) {
    return run_rows(job, kCookTorranceRows, surface, out);
  }
  run_definition(job, surface, out);
}

void add_matte(std::span<const Vector3d> polygon, const Rgb& color, const SurfaceRows& s,
               const LightRows& out) {
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    const double factor = polygon_form_factor(polygon, Vector3d(s.x[i], s.y[i], s.z[i]),
                                              Vector3d(s.nx[i], s.ny[i], s.nz[i]));
    add(out, i, product(factor, color));
  }
}

}  // namespace tristim::detail
