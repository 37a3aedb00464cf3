#include "lib/render/io/gltf_parts.h"

#include <algorithm>

#include "lib/core/math.h"
#include "lib/core/trigonometry.h"
#include "tristim/light/fresnel.h"

namespace tristim::detail {
namespace {

Eigen::Matrix3d rotation_of(const std::vector<double>& q) {
  const double x = q[0];
  const double y = q[1];
  const double z = q[2];
  const double w = q[3];
  const double squared = x * x + y * y + z * z + w * w;
  const double s = squared > 0 ? 2 / squared : 0;
  Eigen::Matrix3d m;
  m << 1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w),  //
      s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w),   //
      s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y);
  return m;
}

}  // namespace

SceneMaterial metallic_material(const MetallicRoughness& factors) {
  const auto base = [&](std::size_t i) { return std::clamp(factors.base[i], 0.0, 1.0); };
  const double metallic = std::clamp(factors.metallic, 0.0, 1.0);
  const double roughness = std::clamp(factors.roughness, 0.0, 1.0);
  SceneMaterial material{.model = kMicrofacetReflection};
  material.surface.od = {base(0), base(1), base(2)};
  material.surface.kd = material.surface.ka = 1 - metallic;
  material.surface.ks = 1;
  material.rough.facets.m = std::max(roughness * roughness, 0.01);
  for (std::size_t i = 0; i < 3; ++i) {
    constexpr double kMostF0 = 0.999;  // of 1 the index would be infinite
    const double f0 = (1 - metallic) * 0.04 + metallic * base(i);
    material.rough.reflectors[i] = Dielectric{1, eta_from_f0(std::min(f0, kMostF0))};
  }
  if (factors.blended && base(3) < 1) {
    material.transparency = Transparency::kInterpolated;
    material.transparent.kt = 1 - base(3);
  }
  return material;
}

double spot_exponent(double inner, double outer) noexcept {
  constexpr double kMost = 1e6;
  const double cosine = sine_cosine_deg(kDegreesPerGltfRadian * (inner + outer) / 2).cosine;
  if (!(cosine > 0 && cosine < 1) || !(inner < outer)) return 0;
  return std::min(log(0.5) / log(cosine), kMost);
}

Eigen::Matrix4d node_placement(const std::vector<double>& matrix,
                               const std::vector<double>& translation,
                               const std::vector<double>& rotation,
                               const std::vector<double>& scale) {
  Eigen::Matrix4d placement = Eigen::Matrix4d::Identity();
  if (matrix.size() == 16) {
    for (int i = 0; i < 16; ++i) placement(i % 4, i / 4) = matrix[static_cast<std::size_t>(i)];
    return placement;
  }
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  if (rotation.size() == 4) linear = rotation_of(rotation);
  for (int i = 0; i < 3; ++i) {
    const auto part = static_cast<std::size_t>(i);
    placement.block<3, 1>(0, i) = (scale.size() == 3 ? scale[part] : 1) * linear.col(i);
    if (translation.size() == 3) placement(i, 3) = translation[part];
  }
  return placement;
}

}  // namespace tristim::detail
