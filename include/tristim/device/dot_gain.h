#pragma once

#include <string>
#include <variant>
#include <vector>

namespace tristim {

/// Dots cover what they are asked to.
struct NoGain {};

/// Dots that grow by a parabola: a + 4 g a (1 - a), g the area gained at half tone; as seen by the
/// formula of [Murray36], which counts all that is lost in light as area.
struct MurrayDaviesGain {
  double at_half = 0;  // [0, 0.25]: 0.2 where 50 % of dots cover 70 %
};

/// Light that spreads in the paper: R = (a Rs^(1/n) + 1 - a)^n [Yule51], Rs the light of the solid.
struct YuleNielsenGain {
  double n = 1;         // 1 (none) to 10; 2 where light spreads far beyond the dots
  double solid = 0.02;  // (0, 1): light of the solid ink relative to the paper
};

/// Measured: pairs of area asked for and area covered, as [Murray36] counts it, both strictly
/// ascending from (0, 0) to (1, 1), joined by straight lines.
struct MeasuredGain {
  std::vector<double> asked, covered;
};

/// What a process makes of the dots of a screen.
using DotGain = std::variant<NoGain, MurrayDaviesGain, YuleNielsenGain, MeasuredGain>;

/// The area, 0 to 1, that dots of an area seem to cover: light is 1 - covered (1 - light of the
/// solid). Areas outside of [0, 1] count as the nearer end.
double covered_area(const DotGain& gain, double asked) noexcept;

/// The area to ask for so that `covered` comes out: the inverse of covered_area.
double asked_area(const DotGain& gain, double covered) noexcept;

/// One line of formula with its numbers, for reports; empty for NoGain.
std::string describe(const DotGain& gain);

}  // namespace tristim
