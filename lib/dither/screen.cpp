#include "tristim/dither/screen.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "lib/core/trigonometry.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

constexpr double kLeastCell = 2;     // dots a side: below it nothing can grow
constexpr double kMostCell = 1000;   // a page of one cell
constexpr double kAngleDeg = 0.05;   // how far the angle may be off
constexpr double kGoodError = 1e-3;  // of the frequency's vector: what a larger tile need not mend
// Sides of supercells, in dots: 65536 dots, a rank for each; finer; and where the last corner is
// half a dot off at most, atan(.5 / 574) = .05 degree.
constexpr double kSides[] = {256, 512, 640};
// Of a supercell, in dots: tiles that repeat sooner show their repetition in the tones of an area.
constexpr double kLeastSide = 128;

struct Corner {
  int a = 0, b = 0, cells = 0;
  double error = 0;  // of the frequency's vector, relative
};

double angle_error_deg(double a, double b, double angle_deg) {
  const double off = std::fabs(detail::angle_deg(b, a) - angle_deg);
  return std::min(off, 360 - off);
}

// The vector of frequency of `cells` cells along (a, b) against the asked one, cell side 1/f.
double frequency_error(int a, int b, int cells, double side, detail::SineCosine direction) {
  const double square = double(a) * a + double(b) * b;
  const double along = cells * side * a / square - direction.cosine;
  const double across = cells * side * b / square - direction.sine;
  return std::sqrt(along * along + across * across);
}

// The corners of the grid around the ideal corner of `cells` cells.
template <typename Visit>
void corners(int cells, double side, detail::SineCosine direction, Visit&& visit) {
  const double length = cells * side;
  const auto a = static_cast<int>(std::floor(length * direction.cosine));
  const auto b = static_cast<int>(std::floor(length * direction.sine));
  for (int i = 0; i <= 1; ++i) {
    for (int j = 0; j <= 1; ++j) {
      if (a + i == 0 && b + j == 0) continue;
      visit(Corner{a + i, b + j, cells, frequency_error(a + i, b + j, cells, side, direction)});
    }
  }
}

Corner nearest_corner(double side, detail::SineCosine direction) {
  Corner best{.error = 1e9};
  corners(1, side, direction, [&](const Corner& corner) {
    if (corner.error < best.error) best = corner;
  });
  return best;
}

// The best corner of a supercell of at most `most` dots a side; cells = 0 where none has the angle.
Corner best_supercell(double side, double angle_deg, detail::SineCosine direction, double most) {
  Corner best{.error = 1e9};
  for (int cells = 1; cells == 1 || cells * side <= most; ++cells) {
    corners(cells, side, direction, [&](const Corner& corner) {
      const bool tones = cells * side >= kLeastSide || 2 * cells * side > most;
      if (!tones || corner.error >= best.error) return;
      if (angle_error_deg(corner.a, corner.b, angle_deg) <= kAngleDeg) best = corner;
    });
  }
  return best;
}

void check(const Screen& screen) {
  if (!(screen.dpi > 0) || !std::isfinite(screen.dpi)) {
    throw std::invalid_argument("screen: a resolution of " + shortest(screen.dpi) +
                                " dpi, expected above 0");
  }
  if (!std::isfinite(screen.angle_deg)) {
    throw std::invalid_argument("screen: an angle of " + shortest(screen.angle_deg) +
                                " degrees, expected a number");
  }
  const RulingRange range = possible_rulings(screen.dpi);
  if (screen.lpi >= range.least && screen.lpi <= range.most) return;
  throw std::invalid_argument("screen: " + shortest(screen.dpi) + " dpi cannot hold a ruling of " +
                              shortest(screen.lpi) + " lpi; possible are " +
                              rounded(range.least, 4) + " to " + rounded(range.most, 6) +
                              " lpi, cells of 1000 to 2 dots");
}

}  // namespace

double ReachedScreen::cell_dots() const noexcept {
  return (double(a) * a + double(b) * b) / (double(cells) * cells);
}

RulingRange possible_rulings(double dpi) noexcept { return {dpi / kMostCell, dpi / kLeastCell}; }

ReachedScreen reach(const Screen& screen) {
  check(screen);
  const double side = screen.dpi / screen.lpi;
  double angle = std::fmod(screen.angle_deg, 360);
  if (angle < 0) angle += 360;
  const detail::SineCosine direction = detail::sine_cosine_deg(angle);
  Corner found;
  if (screen.single_cell) {
    found = nearest_corner(side, direction);
  } else {
    for (const double most : kSides) {
      const bool last = most == kSides[std::size(kSides) - 1];
      found = best_supercell(side, angle, direction, last ? most + side : most);
      if (found.cells > 0 && (found.error <= kGoodError || most > kSides[0])) break;
    }
  }
  const double length = std::sqrt(double(found.a) * found.a + double(found.b) * found.b);
  return {found.a, found.b, found.cells, screen.dpi * found.cells / length,
          detail::angle_deg(found.b, found.a)};
}

}  // namespace tristim
