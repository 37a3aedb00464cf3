#include "lib/render/row_models.h"

#include <algorithm>
#include <array>
#include <variant>

#include "lib/light/product.h"
#include "lib/light/rows_constants.h"
#include "tristim/light/area.h"
#include "tristim/light/gooch.h"
#include "tristim/light/microfacet.h"
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

Light with_unit_intensity(Light light) {
  std::visit([](auto& each) { each.intensity = {1, 1, 1}; }, light);
  return light;
}

// Rows are within 1.1e-7 n of a highlight: where that is too much for a sharp one, its brightest
// samples are those of the double functions.
constexpr double kSharp = 100;

void run_sharp(const RowModelJob& job, const RowModel& model, const SpecularModel& lobe,
               const SurfaceRows& surface, const LightRows& out) {
  RowModelJob matte{.material = job.material, .look = job.look};
  matte.eye = job.eye;
  matte.local_viewer = job.local_viewer;
  matte.specular = false;
  matte.ambient = job.ambient;
  matte.lights = job.lights;
  matte.colors = job.colors;
  run_rows(matte, model, surface, out);
  if (!job.specular) return;
  const double n = job.material.surface.n;
  const double exact_to = 4e-6 / (1.1e-7 * n);
  const std::size_t size = surface.x.size();
  std::array<std::vector<float>, 3> rows{std::vector<float>(size), std::vector<float>(size),
                                         std::vector<float>(size)};
  for (std::size_t k = 0; k < job.lights.size(); ++k) {
    RowModelJob one{.material = job.material, .look = job.look};
    one.eye = job.eye;
    one.local_viewer = job.local_viewer;
    one.lights = {job.lights[k]};
    one.colors = {{{}, {1, 1, 1}}};
    run_rows(one, model, surface, {rows[0], rows[1], rows[2]});
    const Light unit = with_unit_intensity(job.lights[k]);
    for (std::size_t i = 0; i < size; ++i) {
      double highlight = double{rows[0][i]};
      if (highlight == 0) continue;
      if (highlight > exact_to) {
        const Point p = point_of(job, surface, i);
        const Incident arriving = incident(unit, p.at);
        highlight = arriving.intensity.r * lobe.lobe(p.normal, arriving.to_light, p.to_eye, n);
      }
      add(out, i, product(highlight, job.colors[k].specular));
    }
  }
}

// f_att N.L rho_s for F = 1, and V.H, of each sample: in single precision, or by the double
// functions of `light`.
struct FacetRows {
  std::vector<float> lobe, cosine;
};

void run_facet_rows(const RowModelJob& job, const Light& light, const SurfaceRows& surface,
                    FacetRows& out) {
  std::vector<float> unused(out.lobe.size());
  RowShading shading{.model = kCookTorranceRows, .m = job.material.rough.facets.m};
  shading.eye = job.eye;
  shading.local_viewer = job.local_viewer;
  shading.lights = {&light, 1};
  const LightRows rows{out.lobe, out.cosine, unused};
  RowConstants constants = row_constants(shading, surface, rows);
  constants.lobe = RowLobe::kFacets;
  shade_rows_simd(constants, surface, rows);
}

void run_facet_definition(const RowModelJob& job, const Light& light, const SurfaceRows& surface,
                          FacetRows& out) {
  const Microfacets& facets = job.material.rough.facets;
  const Light unit = with_unit_intensity(light);
  const double scale =
      (facets.normalization.normalised ? microfacet_normaliser(facets.distribution, facets.m) : 1) /
      facets.normalization.divisor;
  for (std::size_t i = 0; i < out.lobe.size(); ++i) {
    const Point p = point_of(job, surface, i);
    const Incident arriving = incident(unit, p.at);
    const Vector3d half = half_vector(arriving.to_light, p.to_eye);
    const double n_dot_v = dot(p.normal, p.to_eye);
    const bool seen = n_dot_v > 0 && dot(p.normal, arriving.to_light) > 0;
    const double density = microfacet_density(facets.distribution, dot(p.normal, half), facets.m);
    const double g = geometric_attenuation(p.normal, arriving.to_light, p.to_eye).factor;
    out.lobe[i] =
        static_cast<float>(seen ? arriving.intensity.r * scale * density * g / n_dot_v : 0);
    out.cosine[i] = static_cast<float>(dot(p.to_eye, half));
  }
}

// A matte part, and highlights whose colour is that of a table.
void run_facets(const RowModelJob& job, const SurfaceRows& surface, const LightRows& out) {
  RowModelJob matte = job;
  matte.specular = false;
  run_rows(matte, kCookTorranceRows, surface, out);
  if (!job.specular) return;
  const Microfacets& facets = job.material.rough.facets;
  const bool fast = facets.distribution.name == kBeckmann.name &&
                    facets.normalization.name == kEnergyNormalization.name;
  const std::size_t size = surface.x.size();
  FacetRows rows{std::vector<float>(size), std::vector<float>(size)};
  for (std::size_t k = 0; k < job.lights.size(); ++k) {
    (fast ? run_facet_rows : run_facet_definition)(job, job.lights[k], surface, rows);
    const FresnelTable& table = job.look.highlights[job.index[k]];
    for (std::size_t i = 0; i < size; ++i) {
      if (rows.lobe[i] == 0) continue;
      add(out, i, product(job.share[k] * double{rows.lobe[i]}, table.at(double{rows.cosine[i]})));
    }
  }
}

}  // namespace

void run_row_model(const RowModelJob& job, const SurfaceRows& surface, const LightRows& out) {
  const std::string_view model = job.material.model.name;
  const bool sharp = job.material.surface.n > kSharp;
  if (model == kPhongReflection.name) {
    if (sharp) return run_sharp(job, kPhongRows, kPhong, surface, out);
    return run_rows(job, kPhongRows, surface, out);
  }
  if (model == kBlinnReflection.name) {
    if (sharp) return run_sharp(job, kBlinnPhongRows, kBlinnPhong, surface, out);
    return run_rows(job, kBlinnPhongRows, surface, out);
  }
  if (model == kGoochReflection.name) return run_gooch(job, surface, out);
  if (row_dielectric(job.material) != nullptr) {
    return run_rows(job, kCookTorranceRows, surface, out);
  }
  run_facets(job, surface, out);
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
