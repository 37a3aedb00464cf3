#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <string_view>

#include "tristim/color/rgb.h"
#include "tristim/light/phong.h"
#include "tristim/light/source.h"

namespace tristim {

// Illumination of whole rows in single precision, several samples at a time. The double functions
// of phong.h and microfacet.h are the definition; a row keeps to them within
//
//     2e-6 + 1.1e-7 n    relative to each light's diffuse and specular part,
//
// n the exponent (2/m^2 for Cook-Torrance), since it amplifies the error of the cosine. Dot
// products are double, so that this holds at grazing angles too; what follows them is float.

/// Points of a surface with their unit normals, each coordinate a row of its own; six rows of the
/// same length. Distances to lights and eye between 1e-9 and 1e9.
struct SurfaceRows {
  std::span<const float> x, y, z;     // the points
  std::span<const float> nx, ny, nz;  // the normals
};

/// Light reflected, a row for each primary; as long as the surface's. They may not overlap the
/// surface's.
struct LightRows {
  std::span<float> r, g, b;
};

/// A model of whole rows.
struct RowModel {
  std::string_view name;
  std::string_view formula;  // of the light of one source
  std::string_view source;
};

inline constexpr RowModel kLambertRows{"lambert", "f_att Ip kd Od (N.L)", "[Shoaff 3.2]"};
inline constexpr RowModel kPhongRows{"phong", "f_att Ip [kd Od (N.L) + ks Os (R.V)^n]",
                                     "[Phong75]"};
inline constexpr RowModel kBlinnPhongRows{"blinn-phong", "f_att Ip [kd Od (N.L) + ks Os (N.H)^n]",
                                          "[Blinn77]"};
/// Beckmann's distribution, normalised (`energy`); F of a dielectric, at V.H.
inline constexpr RowModel kCookTorranceRows{
    "cook-torrance", "f_att Ip (N.L) [kd Od/pi + ks Os F D G/(4 pi N.V N.L)]",
    "[Cook82, Walter07]"};

/// Every model of rows.
inline constexpr std::array kRowModels{kLambertRows, kPhongRows, kBlinnPhongRows,
                                       kCookTorranceRows};

/// The colours of a light on a material where the caller has multiplied them, as for spectra.
struct RowLightColors {
  Rgb diffuse = {};   // Ip kd Od
  Rgb specular = {};  // Ip ks Os
};

/// How rows are lit. What a model's formula does not name does not count.
struct RowShading {
  RowModel model = kPhongRows;
  Material material = {};  // n, 0 or more, is that of Phong and Blinn
  double m = 0.3;          // Beckmann's roughness, above 0
  double eta = 1.5;        // index of the surface, relative to what is in front of it, above 0
  Rgb ambient = {};        // Ia
  Eigen::Vector3d eye{0, 0, 1};                 // its place, or the direction to it
  bool local_viewer = true;                     // `eye` is a place
  std::span<const Light> lights = {};           // directional, point and spot lights
  std::span<const RowLightColors> colors = {};  // of each light, or none: those of its intensity
};

/// The complete illumination equation for each sample, ka Ia Od and the lights one after the other;
/// lights behind the surface count as nothing, and an eye behind it does for Cook-Torrance. Powers
/// below 2^-126 are 0. Same bits on every processor.
///
/// A spot's exponent adds to n in the bound, and its edge is sharp to 1e-15 of the cosine's square.
///
/// Throws std::invalid_argument where rows differ in length, `colors` are fewer or more than
/// lights, and for n, m, eta or a spot's cutoff or exponent out of range.
void shade_rows(const RowShading& shading, const SurfaceRows& surface, const LightRows& light);

/// x^n for each sample by the kernel that the lobes use: within 2 ulp (measured: 1.4) for x > 0 and
/// |n| up to 1e6, 0 for other x; results below 2^-126 are 0. `out` may be `x`.
void power_row(std::span<const float> x, float n, std::span<float> out) noexcept;

namespace detail {
/// The same one sample after the other: what the fast versions are tested against.
void shade_rows_scalar(const RowShading& shading, const SurfaceRows& surface,
                       const LightRows& light);
void power_row_scalar(std::span<const float> x, float n, std::span<float> out) noexcept;
}  // namespace detail

}  // namespace tristim
