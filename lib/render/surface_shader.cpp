#include "lib/render/surface_shader.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "lib/light/product.h"
#include "lib/render/cross.h"
#include "lib/render/row_models.h"
#include "tristim/light/normals.h"
#include "tristim/light/vector.h"

namespace tristim::detail {
namespace {

using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;
constexpr std::size_t kAllLights = static_cast<std::size_t>(-1);

LightRows three_rows(ColorRows& out, int channel, std::size_t size) {
  return {out.row(channel, size), out.row(channel + 1, size), out.row(channel + 2, size)};
}

void fill(const LightRows& out, const Rgb& color) {
  std::ranges::fill(out.r, static_cast<float>(color.r));
  std::ranges::fill(out.g, static_cast<float>(color.g));
  std::ranges::fill(out.b, static_cast<float>(color.b));
}

Light seen_from(Light light, const Vector3d& eye) {
  std::visit(
      [&](auto& each) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(each)>, DirectionalLight>) {
          each.position -= eye;
        }
      },
      light);
  return light;
}

// Points evenly spread over a triangle by `n` x `n` cells of equal area [Turk90].
template <class Use>
void for_points(const Vector3d& a, const Vector3d& b, const Vector3d& c, int n, Use&& use) {
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double s = std::sqrt((i + 0.5) / n);
      const double t = (j + 0.5) / n;
      use(Vector3d((1 - s) * a + s * (1 - t) * b + s * t * c));
    }
  }
}

}  // namespace

ColorPlan color_plan(const Scene& scene, const RenderOptions& options) {
  const auto asked = [&](const RenderLayer& layer) {
    return std::ranges::any_of(options.layers,
                               [&](const RenderLayer& each) { return each.name == layer.name; });
  };
  ColorPlan plan;
  const auto reserve = [&](int& first, bool wanted, std::size_t colors) {
    if (!wanted) return;
    first = plan.channels;
    plan.channels += 3 * static_cast<int>(colors);
  };
  reserve(plan.beauty, asked(kBeautyLayer) || asked(kMachLayer), 1);
  reserve(plan.ambient, asked(kAmbientLayer), 1);
  reserve(plan.diffuse, asked(kDiffuseLayer), scene.lights.size());
  reserve(plan.specular, asked(kSpecularLayer), scene.lights.size());
  reserve(plan.albedo, asked(kAlbedoLayer), 1);
  reserve(plan.difference, asked(kBlinnMinusPhongLayer), 1);
  return plan;
}

void ColorRows::resize(int channels, std::size_t most) {
  capacity = most;
  values.resize(static_cast<std::size_t>(channels) * most);
}

// One call: what does not change from part to part of the light.
struct SurfaceShader::Job {
  const SceneMaterial& material;
  const MaterialLook& look;
  const SurfaceRows& surface;
  std::size_t size() const noexcept { return surface.x.size(); }
};

// Some of the light: that of one source or of all, its matte part or its highlights or both.
struct SurfaceShader::Part {
  std::size_t light = kAllLights;
  bool ambient = true;
  bool diffuse = true;
  bool specular = true;

  bool has(std::size_t index) const noexcept { return light == kAllLights || light == index; }
};

SurfaceShader::SurfaceShader(const Scene& scene, const std::vector<MaterialLook>& looks,
                             const View& view, const ColorPlan& plan)
    : scene_(scene),
      looks_(looks),
      plan_(plan),
      eye_(view.orthographic ? view.back : Vector3d(0, 0, 0)),
      local_viewer_(!view.orthographic) {
  const CameraPose pose = pose_of(view);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const SceneLight& light = scene.lights[i];
    std::visit(
        [&](const auto& source) {
          if constexpr (std::is_same_v<std::decay_t<decltype(source)>, PolygonLight>) {
            PolygonLight placed = source;
            for (Vector3d& p : placed.polygon) {
              if (light.with_camera) p = pose.world_from_camera * p + pose.eye;
            }
            add_polygon(i, placed, view);
          } else {
            const Light placed = light.with_camera ? placed_with_camera(source, pose) : source;
            lights_.push_back({i, seen_from(placed, view.eye)});
          }
        },
        light.source);
  }
}

void SurfaceShader::add_polygon(std::size_t index, const PolygonLight& light, const View& view) {
  PlacedPolygon placed{index, light.polygon};
  for (Vector3d& p : placed.polygon) p -= view.eye;
  const auto& corners = placed.polygon;
  const Vector3d normal = unit_newell_normal(corners);
  constexpr AttenuationKind kInverseSquare = kAttenuations[1];
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const double area = length(cross(corners[i - 1] - corners[0], corners[i] - corners[0])) / 2;
    const double part = area / (light.samples * light.samples);
    // A small piece of the polygon radiates as the cosine of the angle to its normal.
    for_points(corners[0], corners[i - 1], corners[i], light.samples, [&](const Vector3d& at) {
      lights_.push_back({index,
                         SpotLight{.position = at,
                                   .direction = normal,
                                   .cutoff_deg = 90,
                                   .exponent = 1,
                                   .attenuation = {.kind = kInverseSquare}},
                         part, false});
    });
  }
  polygons_.push_back(std::move(placed));
}

void SurfaceShader::shade(std::size_t material, const SurfaceRows& surface, ColorRows& out) const {
  const Job job{scene_.materials[material], looks_[material], surface};
  if (plan_.split()) {
    shade_split(job, out);
  } else if (plan_.beauty >= 0) {
    run(job, {}, three_rows(out, plan_.beauty, job.size()));
  }
  if (plan_.albedo >= 0) fill(three_rows(out, plan_.albedo, job.size()), job.look.albedo);
  if (plan_.difference >= 0) shade_difference(job, out);
}

void SurfaceShader::run(const Job& job, const Part& part, const LightRows& out) const {
  const std::string_view model = job.material.model.name;
  if (model == kFlatColor.name) {
    fill(out, part.ambient ? job.look.flat : Rgb{});
    return;
  }
  run_model(job, part, out);
  if (!part.diffuse) return;
  for (const PlacedPolygon& polygon : polygons_) {
    if (part.has(polygon.index)) {
      add_matte(polygon.polygon, job.look.lights[polygon.index].diffuse, job.surface, out);
    }
  }
}

void SurfaceShader::run_model(const Job& job, const Part& part, const LightRows& out) const {
  RowModelJob rows{.material = job.material, .look = job.look};
  rows.eye = eye_;
  rows.local_viewer = local_viewer_;
  rows.specular = part.specular;
  rows.tones = part.diffuse;
  if (part.ambient) rows.ambient = job.look.ambient;
  for (const PlacedLight& light : lights_) {
    if (!part.has(light.index)) continue;
    const RowLightColors& colors = job.look.lights[light.index];
    const Rgb none{};
    // Of a polygon Le dw counts as Ip pi [add_matte], but where the model itself divides by pi.
    const bool whole = light.diffuse || job.material.model.name == kMicrofacetReflection.name;
    const double share = whole ? light.share : light.share / kPi;
    rows.lights.push_back(light.light);
    rows.index.push_back(light.index);
    rows.share.push_back(share);
    rows.colors.push_back({part.diffuse && light.diffuse ? colors.diffuse : none,
                           part.specular ? product(share, colors.specular) : none});
  }
  run_row_model(rows, job.surface, out);
}

// Beauty is the sum of its parts, which are rounded on their own.
void SurfaceShader::shade_split(const Job& job, ColorRows& out) const {
  std::vector<double> sums(3 * job.size());
  ColorRows part;
  part.resize(3, job.size());
  const LightRows rows = three_rows(part, 0, job.size());
  const auto add = [&](const Part& which, int layer) {
    run(job, which, rows);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += part.values[i];
    if (layer < 0) return;
    for (int c = 0; c < 3; ++c) {
      std::ranges::copy(part.row(c, job.size()), out.row(layer + c, job.size()).begin());
    }
  };
  constexpr std::size_t kNoLight = kAllLights - 1;
  add({.light = kNoLight, .diffuse = false, .specular = false}, plan_.ambient);
  for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
    const int at = 3 * static_cast<int>(i);
    add({.light = i, .ambient = false, .specular = false},
        plan_.diffuse < 0 ? -1 : plan_.diffuse + at);
    add({.light = i, .ambient = false, .diffuse = false},
        plan_.specular < 0 ? -1 : plan_.specular + at);
  }
  if (plan_.beauty < 0) return;
  for (int c = 0; c < 3; ++c) {
    const std::span<float> beauty = out.row(plan_.beauty + c, job.size());
    const double* sum = sums.data() + static_cast<std::size_t>(c) * job.size();
    for (std::size_t i = 0; i < beauty.size(); ++i) beauty[i] = static_cast<float>(sum[i]);
  }
}

// sum ks Os f_att Ip ((N.H)^4n - (R.V)^n), n the exponent of Phong's lobe [FisherWoo].
void SurfaceShader::shade_difference(const Job& job, ColorRows& out) const {
  SceneMaterial phong = job.material;
  const double n =
      job.material.model.name == kBlinnReflection.name ? phong.surface.n / 4 : phong.surface.n;
  phong.model = kPhongReflection;
  phong.surface.n = n;
  SceneMaterial blinn = phong;
  blinn.model = kBlinnReflection;
  blinn.surface.n = 4 * n;
  const Part highlights{.ambient = false, .diffuse = false};
  const LightRows difference = three_rows(out, plan_.difference, job.size());
  ColorRows other;
  other.resize(3, job.size());
  run_model({phong, job.look, job.surface}, highlights, three_rows(other, 0, job.size()));
  run_model({blinn, job.look, job.surface}, highlights, difference);
  for (int c = 0; c < 3; ++c) {
    const std::span<float> row = out.row(plan_.difference + c, job.size());
    for (std::size_t i = 0; i < row.size(); ++i) row[i] -= other.row(c)[i];
  }
}

}  // namespace tristim::detail
