#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "lib/render/looks.h"
#include "tristim/light/rows.h"
#include "tristim/render/scene.h"

namespace tristim::detail {

/// Some lights on one material.
struct RowModelJob {
  const SceneMaterial& material;
  const MaterialLook& look;
  Eigen::Vector3d eye{0, 0, 0};
  bool local_viewer = true;
  bool specular = true;
  bool tones = true;  // of kGoochReflection, whose matte part they are
  Rgb ambient = {};
  std::vector<Light> lights = {};
  std::vector<std::size_t> index = {};      // of the scene's light that each belongs to
  std::vector<double> share = {};           // of that light's highlights
  std::vector<RowLightColors> colors = {};  // of each
};

/// The light that the material's model makes of them: the rows of rows.h where they have it, else
/// the double functions of `light`, sample by sample.
void run_row_model(const RowModelJob& job, const SurfaceRows& surface, const LightRows& out);

/// Adds what a matte surface makes of a polygon: `color` times its form factor.
void add_matte(std::span<const Eigen::Vector3d> polygon, const Rgb& color,
               const SurfaceRows& surface, const LightRows& out);

}  // namespace tristim::detail
