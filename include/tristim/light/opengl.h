#pragma once

#include <Eigen/Core>
#include <span>

#include "tristim/color/rgb.h"

namespace tristim {

// The lighting of OpenGL 1.x [OpenGL 2.13.1], in the coordinates of the eye, which is at the
// origin. There is no emission, and nothing is clamped to [0, 1].

struct GlMaterial {
  Rgb ambient = {0.2, 0.2, 0.2};
  Rgb diffuse = {0.8, 0.8, 0.8};
  Rgb specular = {0, 0, 0};
  double shininess = 0;  // 0..128; at 0 the highlight is 1 inside its lobe, 0 outside
};

struct GlLight {
  Eigen::Vector3d position{0, 0, 1};
  double w = 0;  // 0: `position` is the direction to the light; else a place, divided by w
  Rgb ambient = {0, 0, 0};
  Rgb diffuse = {1, 1, 1};
  Rgb specular = {1, 1, 1};
  Eigen::Vector3d spot_direction{0, 0, -1};
  double spot_exponent = 0;
  double spot_cutoff_deg = 180;                    // 0..90, or 180: no cone
  double constant = 1, linear = 0, quadratic = 0;  // attenuation 1/(constant + linear d + ...)
};

struct GlLightModel {
  Rgb ambient = {0.2, 0.2, 0.2};
  bool local_viewer = false;  // false: V is (0, 0, 1) everywhere
};

/// The colour of a vertex. The attenuation of a light at a place and its spot scale its ambient
/// part too. `normal` is used as given. No finite input gives NaN.
Rgb gl_lighting(const GlMaterial& material, const GlLightModel& model,
                std::span<const GlLight> lights, const Eigen::Vector3d& position,
                const Eigen::Vector3d& normal) noexcept;

}  // namespace tristim
