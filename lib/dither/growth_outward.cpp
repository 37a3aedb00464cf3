#include <algorithm>
#include <cmath>

#include "lib/dither/growth_rules.h"
#include "lib/dither/lit_cells.h"

namespace tristim::detail {
namespace {

using Step = PatternSequence::Step;

// How far a cell is from the nearest dot's centre, the short way round.
struct Reach {
  double distance;  // pixels
  double ring;      // the larger of both coordinates: squares around the centre
};

// `shift`: where in its pixel a dot's centre lies, -1/2 to 1/2.
Reach reach_of(const PatternSequence& s, const std::vector<int>& dots, double shift_x,
               double shift_y, int cell) {
  const auto short_way = [](double d, int size) {
    const double around = std::fabs(d);
    return std::min(around, size - around);
  };
  const Place at = place_of(s, cell);
  Reach nearest{1e30, 1e30};
  for (const int dot : dots) {
    const Place centre = place_of(s, dot);
    const double dx = short_way(at.x - centre.x - shift_x, s.width);
    const double dy = short_way(at.y - centre.y - shift_y, s.height);
    const double distance = std::sqrt(dx * dx + dy * dy);
    if (distance < nearest.distance) nearest = {distance, std::max(dx, dy)};
  }
  return nearest;
}

// The first cell that lies farther in than growth outward allows, as its place in the order of
// lighting; the number of cells where there is none.
std::size_t first_inward(const PatternSequence& s, const std::vector<int>& dots, double shift_x,
                         double shift_y) {
  Reach farthest{0, 0};
  bool by_distance = true;
  bool by_ring = true;
  std::size_t order = 0;
  for (const Step& step : s.steps) {
    Reach next = farthest;
    for (const int cell : step.lit) {
      const Reach reach = reach_of(s, dots, shift_x, shift_y, cell);
      by_distance = by_distance && reach.distance > farthest.distance - 1;
      by_ring = by_ring && reach.ring >= farthest.ring;
      if (!by_distance && !by_ring) return order;
      next = {std::max(next.distance, reach.distance), std::max(next.ring, reach.ring)};
      ++order;
    }
    farthest = next;
  }
  return order;
}

std::size_t lit_count(const PatternSequence& s) {
  std::size_t count = 0;
  for (const Step& step : s.steps) count += step.lit.size();
  return count;
}

struct Cell {
  std::size_t step;
  int cell;
};

Cell cell_in_order(const PatternSequence& s, std::size_t order) {
  for (std::size_t step = 0; step < s.steps.size(); ++step) {
    const auto& lit = s.steps[step].lit;
    if (order < lit.size()) return {step, lit[order]};
    order -= lit.size();
  }
  return {0, 0};
}

}  // namespace

GrowthFinding judge_outward(const PatternSequence& sequence) {
  const std::vector<int> dots = first_dots(sequence);
  LitCells lit(sequence);
  std::size_t begun = 0;
  for (std::size_t step = 0; step < sequence.steps.size(); ++step) {
    for (const int cell : sequence.steps[step].lit) {
      if (begun++ >= dots.size() && !lit.touches_with_corners(cell)) {
        return {false,
                level_text(step) + " begins another dot at " + place_text(sequence, cell),
                {{"level", static_cast<double>(step + 1)}}};
      }
    }
    lit.take(sequence.steps[step]);
  }
  std::size_t outward = 0;
  for (const double x : {-0.5, 0.0, 0.5}) {
    for (const double y : {-0.5, 0.0, 0.5}) {
      outward = std::max(outward, first_inward(sequence, dots, x, y));
    }
  }
  if (outward < lit_count(sequence)) {
    const auto [step, cell] = cell_in_order(sequence, outward);
    return {false,
            level_text(step) + " goes back in at " + place_text(sequence, cell),
            {{"level", static_cast<double>(step + 1)}}};
  }
  const auto count = static_cast<double>(dots.size());
  return {true,
          dots.size() == 1 ? "from " + place_text(sequence, dots.front())
                           : std::to_string(dots.size()) + " dots a cell",
          {{"dots", count}}};
}

}  // namespace tristim::detail
