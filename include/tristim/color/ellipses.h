#pragma once

#include <span>

#include "tristim/color/plane.h"

namespace tristim {

/// Chromaticities that an observer could just tell from the one in the centre [MacAdam42]: an
/// ellipse in CIE 1931 x, y.
struct DiscriminationEllipse {
  Chromaticity centre;
  double semi_major_1e3, semi_minor_1e3;  // in thousandths
  double angle_deg;                       // of the long axis, counterclockwise from that of x
};

/// MacAdam's 25 ellipses of 1942.
std::span<const DiscriminationEllipse> macadam_ellipses() noexcept;

/// `corners` points of the outline, `magnified` times about the centre.
std::vector<Chromaticity> ellipse_outline(const DiscriminationEllipse& ellipse, double magnified,
                                          int corners);

}  // namespace tristim
