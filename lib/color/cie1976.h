#pragma once

#include <Eigen/Core>
#include <array>

#include "lib/core/double_double.h"
#include "tristim/color/rgb.h"
#include "tristim/color/xyz.h"

namespace tristim::detail {

// What L*a*b* and L*u*v* have in common. Differences of nearly equal numbers make their last two
// components, so these are computed in 106 bits and rounded once.

inline constexpr double kCieEpsilon = 216.0 / 24389;  // exact [CIE15 note to 8.2.1]
inline constexpr double kCieKappa = 24389.0 / 27;

/// XYZ as grey * white + rest: what a grey is made of cancels before anything is rounded.
struct RelativeXyz {
  double grey = 0;
  std::array<DoubleDouble, 3> rest, white;

  /// X/Xn, Y/Yn or Z/Zn.
  DoubleDouble ratio(std::size_t axis) const noexcept {
    return add({grey, 0}, divide(rest[axis], white[axis]));
  }
};

/// XYZ with nothing taken apart.
RelativeXyz relative_xyz(Xyz xyz, Xyz white) noexcept;

/// The XYZ that `matrix` makes of linear RGB, with G as the grey, relative to that of (1, 1, 1).
RelativeXyz relative_xyz(Rgb rgb, const Eigen::Matrix3d& matrix) noexcept;

/// Linear RGB of a colour whose X and Z differ by `x` and `z` from those of grey `y`. `m` leads
/// from XYZ and takes the white to (1, 1, 1).
Rgb off_grey(double y, double x, double z, const Eigen::Matrix3d& m) noexcept;

/// Whether 106 bits can do it: finite numbers, below 1e100.
bool is_moderate(double a, double b, double c) noexcept;

/// f(t) [CIE15 8.2.1]: the cube root above kCieEpsilon, else (kappa t + 16)/116.
DoubleDouble cie_f(DoubleDouble t) noexcept;

/// L* = 116 f(y) - 16.
DoubleDouble cie_lightness(DoubleDouble y) noexcept;

}  // namespace tristim::detail
