#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tristim/color/xyz.h"

namespace tristim {

/// A colour of the Munsell system under illuminant C. Neutrals have chroma 0 and no hue: NaN.
struct Munsell {
  double hue = 0;     // hue number [ASTMD1535], modulo 100: 5R is 5, 10R is 10, 10RP is 100
  double value = 0;   // 0 black to 10 white
  double chroma = 0;  // from 0; the largest depends on hue and value, 50 at the most
  friend constexpr bool operator==(const Munsell&, const Munsell&) = default;
};

/// Whether two are equal, undefined hues being one.
bool same(Munsell a, Munsell b) noexcept;

/// The white that the renotation is of: illuminant C.
inline constexpr Chromaticity kMunsellWhite{0.31006, 0.31616};

/// Munsell to xyY [Newhall43], [Judd56]; the luminance is 1 for the perfect diffuser [ASTMD1535].
///
/// Between the cells of the table: linear in chroma, linear or radial in hue as the charts are
/// drawn, linear in luminance from value to value [Centore12]. Below value 0.2 chromaticities are
/// those of 0.2. The table goes beyond real colours. No value, all NaN: outside of its chroma or of
/// value 0 to 10.
Xyy munsell_to_xyy(Munsell munsell) noexcept;

/// xyY to Munsell: the inverse of munsell_to_xyy, which takes the result back to x and y within
/// 1e-10. Chroma below 1e-6 is neutral; so is black, whatever its x and y. Hue is in (0, 100].
///
/// No value, all NaN: outside of luminance 0 to 1, of the table, or of the MacAdam limits of
/// illuminant C, which are asked for where the table has no real colours around. Everything that an
/// sRGB display shows, adapted to illuminant C, has one.
Munsell xyy_to_munsell(Xyy xyy) noexcept;

/// Why xyy_to_munsell or munsell_to_xyy has no value; empty where it has one.
std::string munsell_refusal(Xyy xyy);
std::string munsell_refusal(Munsell munsell);

/// The largest chroma of the table at a hue and a value, of real colours and beyond; NaN for values
/// outside of 0 to 10.
double munsell_largest_chroma(double hue, double value) noexcept;

/// Notation [ASTMD1535] to a colour: "7.5YR 5/12", "N 5/", "n5"; any decimals, spaces and cases. A
/// hue is 0 to 10 of its family, 0 being 10 of the one before; a value 0 to 10; a chroma from 0 on.
/// Nothing where it is none.
std::optional<Munsell> parse_munsell(std::string_view text);

/// What to do about a text that is no notation.
std::string munsell_hint(std::string_view text);

/// A colour in notation: "7.5YR 5/12", "N 5/", with `decimals` decimals at the most, or as many as
/// read back as the same colour where it is negative. A colour without value is "none".
std::string munsell_notation(Munsell munsell, int decimals = -1);

}  // namespace tristim
