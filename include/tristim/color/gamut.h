#pragma once

#include "tristim/color/plane.h"
#include "tristim/color/primaries.h"
#include "tristim/color/rgb.h"

namespace tristim {

/// The chromaticities that three primaries mix: red, green and blue as corners [Shoaff 2.2.3].
Polygon gamut_triangle(const Primaries& primaries, const ChromaticityPlane& plane);

/// The triangle's area in units of the plane.
double gamut_area(const Primaries& primaries, const ChromaticityPlane& plane);

/// What two gamuts have in common: three to six corners; fewer where they do not overlap.
Polygon gamut_intersection(const Primaries& a, const Primaries& b, const ChromaticityPlane& plane);

/// How much of `covered` `covering` can mix: the area of the intersection over that of `covered`,
/// [0, 1]; exactly 1 where it holds all corners, and within 1e-15 where one is on an edge. NaN
/// where the primaries of `covered` lie on a line.
double gamut_coverage(const Primaries& covering, const Primaries& covered,
                      const ChromaticityPlane& plane);

/// Where a colour lies relative to a gamut.
struct GamutPosition {
  Rgb rgb;           ///< linear light of the primaries that would make it
  double below = 0;  ///< how far the least of r, g, b is below 0: light that cannot be taken away
  double above = 0;  ///< how far the greatest is above 1: brighter than the primaries are
  double distance = 0;  ///< from its chromaticity to the triangle in u'v'; black is inside
  bool inside() const noexcept { return below == 0 && above == 0; }
  bool chromaticity_inside() const noexcept { return distance == 0; }
};

/// Light within `slack` of the gamut counts as inside, so that what the rounding of a conversion
/// leaves does not.
inline constexpr double kGamutSlack = 1e-9;

/// Where `xyz`, relative to a white of Y = 1 and not adapted, lies relative to the gamut. NaN in
/// gives NaN out, which is not inside. Throws std::invalid_argument as xyz_from_rgb does.
GamutPosition gamut_position(Xyz xyz, const Primaries& primaries, double slack = kGamutSlack);

}  // namespace tristim
