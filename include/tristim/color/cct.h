#pragma once

#include "tristim/color/planckian.h"
#include "tristim/color/xyz.h"

namespace tristim {

/// Correlated colour temperature in kelvins, and the distance from the Planckian locus in the CIE
/// 1960 diagram, above 0 where the colour lies above the locus (greenish).
struct ColorTemperature {
  double temperature_k = 0, duv = 0;
  friend constexpr bool operator==(const ColorTemperature&, const ColorTemperature&) = default;
};

/// The point of the Planckian locus nearest to a chromaticity in CIE 1960 u, v [CIE15 9.4]: the
/// true minimum, no approximation to it. CIE 1931 observer, sum at 1 nm from 360 to 830.
///
/// Maximum error from 1000 to 25000 K with |Duv| <= .02: 1e-5 K and 1e-12. The temperature is +inf
/// where the nearest point is that end of the locus. Both are NaN where |Duv| would exceed .1,
/// where the nearest radiator is colder than 200 K (its colour no longer changes), and for NaN.
ColorTemperature color_temperature(Chromaticity c, double c2 = kC2) noexcept;

/// The chromaticity at a distance from the locus: the inverse of color_temperature. +inf is a
/// temperature; NaN below 200 K.
Chromaticity chromaticity_of(ColorTemperature t, double c2 = kC2) noexcept;

}  // namespace tristim
