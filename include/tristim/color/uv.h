#pragma once

#include "tristim/color/xyz.h"

namespace tristim {

/// CIE 1960 chromaticity and luminance; Y of the white is 1.
struct Uv {
  double u = 0, v = 0, luminance = 0;
  friend constexpr bool operator==(const Uv&, const Uv&) = default;
};

/// CIE 1976 chromaticity u', v' and luminance; Y of the white is 1.
struct UvPrime {
  double u = 0, v = 0, luminance = 0;
  friend constexpr bool operator==(const UvPrime&, const UvPrime&) = default;
};

/// XYZ to u = 4X/(X + 15Y + 3Z), v = 6Y/(X + 15Y + 3Z) [CIE15 8.1]. Black has none: NaN.
Uv xyz_to_uv(Xyz xyz) noexcept;

/// The inverse of xyz_to_uv. A luminance of 0 gives black, whatever u and v are; v = 0 above it
/// gives no finite value.
Xyz uv_to_xyz(Uv uv) noexcept;

/// As xyz_to_uv and back with v' = 9Y/(X + 15Y + 3Z) [CIE15 8.1].
UvPrime xyz_to_uv_prime(Xyz xyz) noexcept;
Xyz uv_prime_to_xyz(UvPrime uv) noexcept;

}  // namespace tristim
