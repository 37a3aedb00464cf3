#pragma once

#include <array>
#include <string>
#include <vector>

#include "tristim/render/scene.h"

namespace tristim::detail {

// What glTF says of materials, lights and cameras, as scenes have it.

inline constexpr double kDegreesPerGltfRadian = 57.295779513082320876798;

/// The factors of a material; textures do not count.
struct MetallicRoughness {
  std::array<double, 4> base{1, 1, 1, 1};
  double metallic = 1, roughness = 1;
  bool blended = false;
};

/// Cook-Torrance of the slope m = roughness^2, whose F0 is .04 for a dielectric and the base colour
/// for a metal. Factors outside [0, 1] count as the nearer end.
SceneMaterial metallic_material(const MetallicRoughness& factors);

/// The exponent of a spot that fades between two cones, of half angles in radians: cos^n is half of
/// the light in their middle. 0 where the cones are one.
double spot_exponent(double inner, double outer) noexcept;

/// The local transformation of a node: its matrix by columns, or scale, rotation (x, y, z, w) and
/// translation, each empty where it is not given.
Eigen::Matrix4d node_placement(const std::vector<double>& matrix,
                               const std::vector<double>& translation,
                               const std::vector<double>& rotation,
                               const std::vector<double>& scale);

}  // namespace tristim::detail
