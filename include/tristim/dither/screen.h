#pragma once

#include "tristim/dither/spot.h"
#include "tristim/dither/threshold_matrix.h"

namespace tristim {

/// A halftone screen: dots at `lpi` lines an inch and `angle_deg` on a device of `dpi` dots an
/// inch.
struct Screen {
  double dpi = 600;
  double lpi = 85;
  double angle_deg = 45;  // of the cells' x axis, counterclockwise on the page
  Spot spot = kSpotFunctions[1];
  bool single_cell = false;  // one cell of whole dots (rational tangent) instead of a supercell
  int smallest_dot = 1;  // dots of the device that come and go together: above 1 a hybrid screen
};

/// What dots on a square grid make of a screen: `cells` x `cells` cells in a square of the sides
/// (a, b) and (-b, a) dots, y up, which tiles the page.
struct ReachedScreen {
  int a = 0, b = 0;
  int cells = 1;
  double lpi = 0;
  double angle_deg = 0;               // [0, 360)
  double cell_dots() const noexcept;  // in a cell, on average
};

/// The range of rulings, in lines an inch, that a resolution can hold: cells of 2 to 1000 dots a
/// side.
struct RulingRange {
  double least = 0, most = 0;
};
RulingRange possible_rulings(double dpi) noexcept;

/// The nearest screen that the dots can make: of the squares of up to 256 dots a side (where those
/// do not suffice, more) whose angle is within 0.05 degree, the one whose vector of frequency is
/// nearest to the asked. A single cell takes the nearest corner, whatever its angle.
///
/// Throws std::invalid_argument for a resolution that is not above 0, an angle that is not finite
/// and a ruling that the resolution cannot hold; the text says which it can.
ReachedScreen reach(const Screen& screen);

/// The thresholds of a screen. Cells are inked alike, from the spot's dot outward and towards its
/// hole; where their dots differ by one, in a dispersed order of the cells, so that the tones are
/// as many as the tile has dots. Ink comes where a pixel is not lit.
///
/// Up to half tone it is dots that grow alike, above it holes that shrink alike. With
/// `smallest_dot` above 1 the ends of the scale have dots (holes) of that size, dispersed over the
/// cells: a hybrid of amplitude and frequency modulation.
///
/// Throws std::invalid_argument as reach() and check_spot() do, and for a smallest dot that is not
/// from 1 to a quarter of a cell.
ThresholdMatrix screen_matrix(const Screen& screen);

}  // namespace tristim
