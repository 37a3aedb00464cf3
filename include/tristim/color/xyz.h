#pragma once

#include <string_view>

namespace tristim {

/// CIE 1931 XYZ, relative: Y of the white is 1.
struct Xyz {
  double x = 0, y = 0, z = 0;
  friend constexpr bool operator==(const Xyz&, const Xyz&) = default;
};

/// CIE 1931 chromaticity: x = X/(X+Y+Z), y = Y/(X+Y+Z) [CIE15].
struct Chromaticity {
  double x = 0, y = 0;
  friend constexpr bool operator==(const Chromaticity&, const Chromaticity&) = default;
};

/// Chromaticity and luminance, relative: Y of the white is 1.
struct Xyy {
  double x = 0, y = 0, luminance = 0;
  friend constexpr bool operator==(const Xyy&, const Xyy&) = default;
};

/// XYZ to xyY [CIE15]. Black has no chromaticity: its x and y are NaN.
Xyy xyz_to_xyy(Xyz xyz) noexcept;

/// xyY to XYZ [CIE15]. A luminance of 0 gives black, whatever x and y are; y = 0 above it gives no
/// finite value.
Xyz xyy_to_xyz(Xyy xyy) noexcept;

/// The XYZ of a white with Y = 1.
Xyz white_xyz(Chromaticity white) noexcept;

/// White points as video, ICC and the ACES fix them; not the integrals of the spectra.
inline constexpr Chromaticity kD50{0.3457, 0.3585};
inline constexpr Chromaticity kD65{0.3127, 0.3290};

struct WhitePoint {
  std::string_view name;
  Chromaticity chromaticity;
  std::string_view source;
};

/// White points by name. The device files and the command line read this list.
inline constexpr WhitePoint kWhitePoints[] = {
    {"a", {0.44758, 0.40745}, "[CIE15] table T.3"},
    {"b", {0.34842, 0.35161}, "[CIE15] table T.3"},
    {"c", {0.31006, 0.31616}, "[CIE15] table T.3"},
    {"d50", kD50, "[CIE15] table T.3, as ICC uses it"},
    {"d55", {0.33243, 0.34744}, "[CIE15] table T.3"},
    {"d60", {0.32168, 0.33767}, "[ST2065] ACES"},
    {"d65", kD65, "[IEC61966], [BT709]"},
    {"d75", {0.29903, 0.31488}, "[CIE15] table T.3"},
    {"e", {1.0 / 3, 1.0 / 3}, "[CIE15], equal energy"},
    {"dci", {0.314, 0.351}, "[RP431]"},
};

}  // namespace tristim
