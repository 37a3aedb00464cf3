#pragma once

#include <array>
#include <optional>

#include "tristim/color/primaries.h"
#include "tristim/color/xyz.h"

namespace tristim {

/// What a meter read off a display with each channel alone at its highest code, and with all of
/// them (white) and none (black). One unit for all.
struct MeasuredPrimaries {
  Xyz red, green, blue;
  std::optional<Xyz> white, black;
};

/// The chromaticities of the phosphors, less the light that the black has anyway, and of their
/// white: the measured one, else their sum. Throws std::invalid_argument where one gives no light
/// or they lie on a line.
Primaries primaries_of(const MeasuredPrimaries& measured);

/// How well the channels add up to the white [Berns93]: light that they lend one another, or a
/// supply that sags, shows here.
struct Additivity {
  Xyz sum;                       // red + green + blue, less the black that was counted thrice
  Xyz white;                     // as measured
  std::array<double, 3> excess;  // of X, Y, Z: sum/white - 1
  double ciede2000 = 0;          // between both, the measured white as white
};

/// Nothing where no white was measured.
std::optional<Additivity> additivity_of(const MeasuredPrimaries& measured);

}  // namespace tristim
