#pragma once

#include "tristim/color/lab.h"

namespace tristim {

// Hue is in degrees, [0, 360) out, any number modulo 360 in. Chroma 0 has no hue (NaN), and the
// inverses take any there.

/// L*, chroma and hue of CIE 1976 L*a*b*.
struct Lch {
  double l = 0, c = 0, h = 0;
  friend constexpr bool operator==(const Lch&, const Lch&) = default;
};

/// L*, chroma and hue of CIE 1976 L*u*v*.
struct LchUv {
  double l = 0, c = 0, h = 0;
  friend constexpr bool operator==(const LchUv&, const LchUv&) = default;
};

/// C = sqrt(a^2 + b^2), h = atan2(b, a) [CIE15 8.2.1.2], each within 1 ulp; and back.
Lch lab_to_lch(Lab lab) noexcept;
Lab lch_to_lab(Lch lch) noexcept;

/// C = sqrt(u^2 + v^2), h = atan2(v, u) [CIE15 8.2.2.2], each within 1 ulp; and back.
LchUv luv_to_lch(Luv luv) noexcept;
Luv lch_to_luv(LchUv lch) noexcept;

/// Whether two colours are one: what == says, but that hues count modulo 360 and not at all where
/// both chromas are 0, and that undefined components are equal.
bool same(const Lch& first, const Lch& second) noexcept;
bool same(const LchUv& first, const LchUv& second) noexcept;

}  // namespace tristim
