#pragma once

#include "tristim/color/hue.h"

namespace tristim::detail {

struct Polar {
  double chroma = 0, hue_deg = 0;
};
struct Plane {
  double a = 0, b = 0;
};

/// (a, b) to chroma and hue in [0, 360). The hue of chroma 0, and of less than `neutral`, is NaN.
Polar to_polar(Plane plane, double neutral = 0) noexcept;

/// The inverse. Where the hue is NaN, chroma 0 or less than `neutral` is the grey (0, 0).
Plane from_polar(Polar polar, double neutral = 0) noexcept;

/// Whether two colours {l, c, h} are one: hues count modulo 360, and not at all without chroma.
template <typename Color>
bool same_polar(const Color& first, const Color& second) noexcept {
  const bool grey = first.c == 0 && second.c == 0;
  return same_component(first.l, second.l) && same_component(first.c, second.c) &&
         (grey || same_hue(first.h, second.h));
}

}  // namespace tristim::detail
