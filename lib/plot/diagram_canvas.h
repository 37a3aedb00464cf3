#pragma once

#include <string>
#include <vector>

#include "lib/plot/labels.h"
#include "tristim/color/plane.h"
#include "tristim/plot/axes.h"

namespace tristim::detail {

/// What the parts of a chromaticity diagram are drawn with.
struct DiagramCanvas {
  SvgDrawing& svg;
  const PlotAxes& axes;
  LabelPlacer& labels;
  const ChromaticityPlane& plane;

  SvgPoint at(Chromaticity c) const {
    const PlanePoint p = plane.point(c);
    return axes.at({p.x, p.y});
  }
  std::vector<SvgPoint> at(const std::vector<Chromaticity>& chromaticities) const;
};

/// The spectral locus from 380 to 700 nm, a point a nanometre.
std::vector<Chromaticity> locus_chromaticities();

/// The sRGB colour of a chromaticity that is as bright and as saturated as a display can show,
/// "#rrggbb".
std::string display_color(Chromaticity c);

/// The parts, in the order in which they are drawn.
void draw_inside(const DiagramCanvas& canvas);
void draw_locus(const DiagramCanvas& canvas);
void draw_temperatures(const DiagramCanvas& canvas);

inline constexpr SvgStroke kPlanckianStroke{"#222", 1.3};
inline constexpr SvgStroke kDaylightStroke{"#222", 1.1, "2 3"};

}  // namespace tristim::detail
