#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>

#include "tristim/color/adaptation.h"
#include "tristim/color/xyz.h"

namespace tristim {

/// Phosphors (or filters, or axes) and the white that RGB (1, 1, 1) makes.
struct Primaries {
  Chromaticity red{0.64, 0.33};  // the defaults are sRGB's [IEC61966]
  Chromaticity green{0.30, 0.60};
  Chromaticity blue{0.15, 0.06};
  Chromaticity white = kD65;
  friend constexpr bool operator==(const Primaries&, const Primaries&) = default;
};

/// A published set.
struct NamedPrimaries {
  std::string_view name;
  Primaries primaries;
  std::string_view white_name;
  std::string_view transfer;  // the curve that usually goes with it, informative
  std::string_view source;
};

/// Every published set, from luts/primaries.csv. The command line, the device files and the tests
/// read it.
std::span<const NamedPrimaries> primaries_list() noexcept;

/// Linear RGB to CIE XYZ, scaled so that RGB (1, 1, 1) is the white with Y = 1 [Shoaff 2.2.4].
///
/// Columns (x, y, 1-x-y) C, with C solved from the white.
/// Throws std::invalid_argument when the primaries lie on a line or the white has y = 0.
Eigen::Matrix3d xyz_from_rgb(const Primaries& primaries);

/// CIE XYZ to linear RGB: the inverse of xyz_from_rgb. Throws as it does.
Eigen::Matrix3d rgb_from_xyz(const Primaries& primaries);

/// The white that three phosphors of chromaticity red, green and blue make at luminances Yr, Yg, Yb
/// (any unit) [Shoaff 2.2.4]. Throws std::invalid_argument when the sum of the luminances is not
/// above 0.
Chromaticity white_from_luminances(const Primaries& phosphors, double yr, double yg, double yb);

/// Linear RGB of one set to linear RGB of another: rgb_from_xyz(to) * adaptation *
/// xyz_from_rgb(from) [Shoaff 2.2.4]. Throws std::invalid_argument when either set lies on a line.
Eigen::Matrix3d rgb_from_rgb(const Primaries& to, const Primaries& from, Adaptation method);

}  // namespace tristim
