#pragma once

#include <vector>

#include "lib/core/exponent.h"
#include "tristim/light/rows.h"

namespace tristim::detail {

/// A light as the kernels read it.
struct RowLight {
  double x = 0, y = 0, z = 0;  // the place, or the unit direction to it
  bool directional = false;
  bool attenuated = false;
  bool beer_lambert = false;  // f_att = 2^(c1 d), else 1/(c1 + c2 d + c3 d^2), at most `most`
  float c1 = 1, c2 = 0, c3 = 0;
  float most = 0;
  bool spot = false;
  double axis_x = 0, axis_y = 0, axis_z = 0;  // unit, from the cone back to the light
  double edge2 = 0;        // cos(cutoff) times its magnitude, less a few of a double's last bits
  Exponent spot_exponent;  // half of it, of the cosine's square
  // Ip kd Od (over pi for Cook-Torrance) and Ip ks Os
  float diffuse_r = 0, diffuse_g = 0, diffuse_b = 0;
  float specular_r = 0, specular_g = 0, specular_b = 0;
};

/// kFacets is kCookTorrance in parts, for Fresnel terms of any colour: of one light red becomes
/// f_att N.L rho_s for F = 1, green V.H.
enum class RowLobe { kNone, kPhong, kBlinnPhong, kCookTorrance, kFacets };

/// RowShading with everything computed that does not depend on the sample.
struct RowConstants {
  RowLobe lobe = RowLobe::kNone;
  std::vector<RowLight> lights;
  double eye_x = 0, eye_y = 0, eye_z = 0;
  bool local_viewer = true;
  Exponent exponent;          // n/2, of (R.V)^2 and (N.H)^2
  double tangent_scale = 0;   // -log2(e)/m^2, of tan^2 b in Beckmann's exponential
  float tangent_unscale = 0;  // its reciprocal
  float eta2_minus_1 = 0;     // eta^2 - 1
  float lobe_scale = 0;       // 1/(4 pi m^2) for Cook-Torrance
  float ambient_r = 0, ambient_g = 0, ambient_b = 0;  // ka Ia Od
};

/// Throws std::invalid_argument as shade_rows does.
RowConstants row_constants(const RowShading& shading, const SurfaceRows& surface,
                           const LightRows& light);

/// rows_simd.cpp: the fast versions of what rows.cpp defines.
void shade_rows_simd(const RowConstants& constants, const SurfaceRows& surface,
                     const LightRows& light);
void power_row_simd(std::span<const float> x, float n, std::span<float> out) noexcept;

}  // namespace tristim::detail
