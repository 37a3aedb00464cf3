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

/// L*u*v* to XYZ: the inverse of xyz_to_luv. L* = 0 is black, whatever u* and v* are.
Xyz luv_to_xyz(Luv luv, Xyz white) noexcept;

/// L* of a luminance relative to the white, and back.
double lstar_from_luminance(double y) noexcept;
double luminance_from_lstar(double lstar) noexcept;

// Between linear RGB and the models above with a white that RGB (1, 1, 1) makes, in one step: a*,
// b*, u* and v* of every grey are exactly 0, and such a colour gives R = G = B, which the way
// through XYZ cannot promise.

/// Linear RGB to L*a*b*. `matrix` leads to XYZ; its white is that of RGB (1, 1, 1).
Lab rgb_to_lab(Rgb rgb, const Eigen::Matrix3d& matrix) noexcept;

/// Linear RGB to L*u*v*. `matrix` leads to XYZ; its white is that of RGB (1, 1, 1).
Luv rgb_to_luv(Rgb rgb, const Eigen::Matrix3d& matrix) noexcept;

/// L*a*b* under `white` to linear RGB. `matrix` leads from XYZ and takes the white to (1, 1, 1).
Rgb lab_to_rgb(Lab lab, Xyz white, const Eigen::Matrix3d& matrix) noexcept;

/// L*u*v* under `white` to linear RGB. `matrix` leads from XYZ and takes the white to (1, 1, 1).
Rgb luv_to_rgb(Luv luv, Xyz white, const Eigen::Matrix3d& matrix) noexcept;

}  // namespace tristim
