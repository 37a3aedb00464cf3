#pragma once

#include "tristim/color/rgb.h"

namespace tristim {

/// Oklab [Ottosson20]; L of the white is 1.
struct Oklab {
  double l = 0, a = 0, b = 0;
  friend constexpr bool operator==(const Oklab&, const Oklab&) = default;
};

/// L, chroma and hue of Oklab.
struct Oklch {
  double l = 0, c = 0, h = 0;
  friend constexpr bool operator==(const Oklch&, const Oklch&) = default;
};

/// Linear sRGB to Oklab with the published 10-digit matrices. Any finite input; cube roots are odd.
/// Greys have a and b within 4e-8 of 0, as the published matrices leave them.
Oklab linear_srgb_to_oklab(Rgb rgb) noexcept;

/// Oklab with cbrt(x + toe) - cbrt(toe) in place of the cube root, and its tangent below 0; toe >
/// 0, in light. L of the white is less than 1. There is no inverse: it is for measuring distances.
Oklab linear_srgb_to_oklab_with_toe(Rgb rgb, double toe) noexcept;

/// Oklab to linear sRGB by the exact inverse of those matrices.
Rgb oklab_to_linear_srgb(Oklab oklab) noexcept;

/// Below this chroma a colour is a grey: the published matrices leave 4e-8 on greys.
inline constexpr double kOklchNeutral = 1e-6;

/// C = sqrt(a^2 + b^2), h = atan2(b, a) in degrees, [0, 360); NaN where C is below kOklchNeutral.
Oklch oklab_to_oklch(Oklab oklab) noexcept;

/// The inverse, for any hue modulo 360. An undefined hue is taken below kOklchNeutral: the neutral
/// colour.
Oklab oklch_to_oklab(Oklch oklch) noexcept;

/// As same() of Lch.
bool same(const Oklch& first, const Oklch& second) noexcept;

}  // namespace tristim
