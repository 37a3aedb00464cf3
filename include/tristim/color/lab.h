#pragma once

#include "tristim/color/primaries.h"
#include "tristim/color/rgb.h"
#include "tristim/color/xyz.h"

namespace tristim {

/// CIE 1976 L*a*b*; L* of the white is 100.
struct Lab {
  double l = 0, a = 0, b = 0;
  friend constexpr bool operator==(const Lab&, const Lab&) = default;
};

/// XYZ to L*a*b* [CIE15 8.2.1] relative to `white` (its XYZ). The linear segment goes on below 0.
Lab xyz_to_lab(Xyz xyz, Xyz white) noexcept;

/// L*a*b* to XYZ: the inverse of xyz_to_lab.
Xyz lab_to_xyz(Lab lab, Xyz white) noexcept;

/// CIE 1976 L*u*v*; L* of the white is 100.
struct Luv {
  double l = 0, u = 0, v = 0;
  friend constexpr bool operator==(const Luv&, const Luv&) = default;
};

/// XYZ to L*u*v* [CIE15 8.2.2] relative to `white` (its XYZ). Black has u* = v* = 0.
Luv xyz_to_luv(Xyz xyz, Xyz white) noexcept;

/// L* of a luminance relative to the white, and back.
double lstar_from_luminance(double y) noexcept;
double luminance_from_lstar(double lstar) noexcept;

/// Linear RGB to L*a*b* with the white of its own primaries, so that a* and b* of greys are exactly
/// 0. `matrix` is xyz_from_rgb of the primaries.
Lab rgb_to_lab(Rgb rgb, const Eigen::Matrix3d& matrix) noexcept;

}  // namespace tristim
