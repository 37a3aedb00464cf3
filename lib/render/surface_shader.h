#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "lib/render/looks.h"
#include "lib/render/view.h"
#include "tristim/light/rows.h"
#include "tristim/render/render.h"

namespace tristim::detail {

/// Which colours are computed of a sample, and where: the first of three channels, or -1.
struct ColorPlan {
  int beauty = -1;
  int ambient = -1;
  int diffuse = -1;   // of the first light; the others follow
  int specular = -1;  // likewise
  int albedo = -1;
  int difference = -1;  // blinn_minus_phong
  int channels = 0;

  /// Whether the parts of the light are asked for one by one.
  bool split() const noexcept { return ambient >= 0 || diffuse >= 0 || specular >= 0; }
};

ColorPlan color_plan(const Scene& scene, const RenderOptions& options);

/// Colours of samples, a row for each channel.
struct ColorRows {
  std::size_t capacity = 0;
  std::vector<float> values;

  void resize(int channels, std::size_t most);
  std::span<float> row(int channel, std::size_t size) noexcept {
    return {values.data() + static_cast<std::size_t>(channel) * capacity, size};
  }
  const float* row(int channel) const noexcept {
    return values.data() + static_cast<std::size_t>(channel) * capacity;
  }
};

/// Where a shader is used: the lights as seen from the eye, whose place is 0.
struct PlacedLight {
  std::size_t index = 0;  // of the scene's
  Light light;
  double share = 1;     // of the light's specular colour
  bool diffuse = true;  // else it stands for a part of a polygon
};
struct PlacedPolygon {
  std::size_t index = 0;
  std::vector<Eigen::Vector3d> polygon;
};

/// Runs the illumination models of a scene on rows of points.
class SurfaceShader {
 public:
  SurfaceShader(const Scene& scene, const std::vector<MaterialLook>& looks, const View& view,
                const ColorPlan& plan);

  /// The plan's channels of points of one material; places relative to the eye.
  void shade(std::size_t material, const SurfaceRows& surface, ColorRows& out) const;

 private:
  struct Job;
  struct Part;
  void add_polygon(std::size_t index, const PolygonLight& light, const View& view);
  void run(const Job& job, const Part& part, const LightRows& out) const;
  void run_model(const Job& job, const Part& part, const LightRows& out) const;
  void shade_split(const Job& job, ColorRows& out) const;
  void shade_difference(const Job& job, ColorRows& out) const;

  const Scene& scene_;
  const std::vector<MaterialLook>& looks_;
  ColorPlan plan_;
  std::vector<PlacedLight> lights_;
  std::vector<PlacedPolygon> polygons_;
  Eigen::Vector3d eye_;
  bool local_viewer_;
};

}  // namespace tristim::detail
