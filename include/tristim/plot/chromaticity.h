#pragma once

#include <string>
#include <vector>

#include "tristim/color/plane.h"
#include "tristim/color/primaries.h"

namespace tristim {

/// A colour on the diagram, with its name.
struct DiagramColor {
  std::string name;
  Chromaticity chromaticity;
};

/// The triangle of a set of primaries, with its name.
struct DiagramGamut {
  std::string name;
  Primaries primaries;
};

/// What a chromaticity diagram shows besides the spectral locus.
struct ChromaticityDiagram {
  const ChromaticityPlane* plane = &kCie1931Plane;
  DiagramColor white{"D65", kD65};  ///< from which the dominant wavelengths are seen
  std::vector<DiagramGamut> gamuts;
  std::vector<DiagramColor> colors;  ///< with rays to their dominant wavelengths; dots if over 24
  std::vector<double> limits;        ///< luminance factors of MacAdam limits, under illuminant C
  bool temperatures = true;          ///< the Planckian and the daylight locus
  bool ellipses = false;             ///< MacAdam's of 1942, ten times their size
};

/// The diagram as an SVG file: axes, spectral locus with its wavelengths, an inside in the colours
/// that sRGB has for it, and what `diagram` adds, with a legend. The axes are extended to what
/// reaches beyond them, within [-1, 2]; colours without a chromaticity (black) are left out.
std::string chromaticity_diagram(const ChromaticityDiagram& diagram);

}  // namespace tristim
