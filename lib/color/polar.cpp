#include "lib/color/polar.h"

#include <cmath>
#include <limits>

#include "lib/core/trigonometry.h"

namespace tristim::detail {

Polar to_polar(Plane plane, double neutral) noexcept {
  const double chroma = hypotenuse(plane.a, plane.b);
  if (chroma == 0 || chroma < neutral) return {chroma, std::numeric_limits<double>::quiet_NaN()};
  return {chroma, angle_deg(plane.b, plane.a)};
}

Plane from_polar(Polar polar, double neutral) noexcept {
  const bool grey = polar.chroma == 0 || (std::isnan(polar.hue_deg) && polar.chroma < neutral);
  if (grey) return {0, 0};
  const SineCosine direction = sine_cosine_deg(polar.hue_deg);
  return {polar.chroma * direction.cosine, polar.chroma * direction.sine};
}

}  // namespace tristim::detail
