#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "tristim/dither/formula.h"

namespace tristim {

/// How the dot of a screen grows: places of a cell, x to the right along the screen's angle and y
/// up, both in [-1, 1], are inked in the order of falling values.
struct SpotFunction {
  std::string_view name;
  double (*value)(double x, double y) noexcept;
  std::string_view what;
  std::string_view source;
};

/// 1 - (x^2 + y^2): a round dot up to 78 %, then what is left between dots shrinks.
double round_spot(double x, double y) noexcept;

/// Round dots, squares on their corners at half tone, round holes.
double euclidean_spot(double x, double y) noexcept;

/// Ellipses that join along x first.
double ellipse_spot(double x, double y) noexcept;

/// -|y|: lines along x.
double line_spot(double x, double y) noexcept;

/// Round dots, then diamonds that join along x before they join along y, round holes.
double diamond_spot(double x, double y) noexcept;

/// -max(|x|, |y|): squares.
double square_spot(double x, double y) noexcept;

/// (cos pi x + cos pi y)/2: round, a chessboard at half tone, round; softer than euclidean.
double cosine_spot(double x, double y) noexcept;

/// Every spot function. The command line, the docs and the property tests read this list.
inline constexpr SpotFunction kSpotFunctions[] = {
    {"round", round_spot, "round dots until they overlap", "[Iso32000 10.5.3] SimpleDot"},
    {"euclidean", euclidean_spot, "round dots, squares at half tone, round holes",
     "[Iso32000 10.5.3] Round"},
    {"ellipse", ellipse_spot, "elliptical dots that join along one direction first",
     "[Iso32000 10.5.3] Ellipse"},
    {"line", line_spot, "lines along the angle", "[Iso32000 10.5.3] Line"},
    {"diamond", diamond_spot, "diamonds that join in two steps", "[Iso32000 10.5.3] Diamond"},
    {"square", square_spot, "square dots", "[Iso32000 10.5.3] Square"},
    {"cosine", cosine_spot, "soft round dots, a chessboard at half tone",
     "[Iso32000 10.5.3] CosineDot"},
};

/// A grey picture of the cell: its light places are inked first, as those of the highest threshold.
/// Rows from the top; between pixels it is interpolated, beyond its edges repeated.
struct SpotPicture {
  std::string name;  // for reports
  int width = 0, height = 0;
  std::vector<float> value;
};

/// What decides the order in which a cell is inked.
using Spot = std::variant<SpotFunction, Formula, SpotPicture>;

/// The value at a place of the cell.
double spot_value(const Spot& spot, double x, double y) noexcept;

/// Its name, its formula, or the picture's name.
std::string spot_name(const Spot& spot);

/// Throws std::invalid_argument where the spot is not finite somewhere in the cell, with the place,
/// or has one value everywhere.
void check_spot(const Spot& spot);

/// Where a spot's dot and its hole begin.
struct SpotCentres {
  double dot_x = 0, dot_y = 0;
  double hole_x = 1, hole_y = 1;
};
SpotCentres spot_centres(const Spot& spot) noexcept;

}  // namespace tristim
