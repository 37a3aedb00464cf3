#pragma once

#include "tristim/color/rgb.h"

namespace tristim {

// Hue is in degrees, [0, 360) out, any number modulo 360 in; red 0, green 120, blue 240. Saturation
// 0 is a grey: it has no hue (NaN), and the inverses take any there. Nothing is clamped: colours
// outside the cube follow the same formulas and come back. A NaN component makes all of them NaN.

/// Hexcone model.
struct Hsv {
  double h = 0, s = 0, v = 0;
  friend constexpr bool operator==(const Hsv&, const Hsv&) = default;
};

/// Double hexcone model in the order of its name.
struct Hls {
  double h = 0, l = 0, s = 0;
  friend constexpr bool operator==(const Hls&, const Hls&) = default;
};

/// The double hexcone in the order of CSS.
struct Hsl {
  double h = 0, s = 0, l = 0;
  friend constexpr bool operator==(const Hsl&, const Hsl&) = default;
};

/// RGB to HSV [Smith78, hexcone], [Shoaff 2.2.6]: V = max, S = (max - min)/max; black has S = 0.
/// Where max is 0 above a negative min, S is NaN. Largest error of the hue: 6e-14 degrees.
Hsv rgb_to_hsv(EncodedRgb rgb) noexcept;

/// The inverse of rgb_to_hsv.
EncodedRgb hsv_to_rgb(Hsv hsv) noexcept;

/// RGB to HLS [Shoaff 2.2.7]: L = (max + min)/2; S = (max - min)/(max + min) up to L = 1/2, else
/// (max - min)/((1 - max) + (1 - min)). Where that denominator is 0 outside the cube, S is NaN.
Hls rgb_to_hls(EncodedRgb rgb) noexcept;

/// The inverse of rgb_to_hls.
EncodedRgb hls_to_rgb(Hls hls) noexcept;

/// As HLS, with the components in the order of CSS [CSS4 7].
Hsl rgb_to_hsl(EncodedRgb rgb) noexcept;
EncodedRgb hsl_to_rgb(Hsl hsl) noexcept;

/// Whether two colours are one: what == says, but that hues count modulo 360 and not at all where
/// both saturations are 0, and that undefined components are equal.
bool same(const Hsv& first, const Hsv& second) noexcept;
bool same(const Hls& first, const Hls& second) noexcept;
bool same(const Hsl& first, const Hsl& second) noexcept;

}  // namespace tristim
