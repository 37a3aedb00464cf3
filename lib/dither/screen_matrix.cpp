#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "lib/dither/void_and_cluster.h"
#include "tristim/core/text.h"
#include "tristim/dither/screen.h"

namespace tristim {
namespace {

constexpr int kMostRanks = 65536;

// The tile of a screen's square: the lattice of (a, -b) and (b, a), y down, has a rectangle of
// (a^2 + b^2)/g by g dots, g their common divisor, of which the next row lies `shift` dots to the
// right.
struct Tile {
  int width = 0, height = 0, shift = 0;
};

Tile tile_of(const ReachedScreen& s) {
  // i a - j b = g by Euclid's algorithm: the way i (b, a) + j (a, -b) leads g dots down.
  std::array<long long, 3> last{s.a, 1, 0};
  std::array<long long, 3> next{-s.b, 0, 1};
  while (next[0] != 0) {
    const long long q = last[0] / next[0];
    for (std::size_t k = 0; k < 3; ++k) last[k] = std::exchange(next[k], last[k] - q * next[k]);
  }
  const long long sign = last[0] < 0 ? -1 : 1;
  const auto g = static_cast<int>(sign * last[0]);
  const int width = (s.a * s.a + s.b * s.b) / g;
  const long long right = sign * (last[1] * s.b + last[2] * s.a) % width;
  return {width, g, static_cast<int>((right + width) % width)};
}

// A dot of the device.
struct Dot {
  double value = 0;     // of the spot
  double x = 0, y = 0;  // in its cell, [-1, 1)
  int cell = 0;         // whose centre it is nearest to
  int hole_cell = 0;    // whose hole it is nearest to
  int place = 0;        // in the tile
};

// The cell around whose `centre` (in [-1, 1] of a cell) a place lies, given in cells.
int cell_around(double u, double v, double centre_x, double centre_y, int cells) {
  const auto column = static_cast<int>(std::floor(u - centre_x / 2)) % cells;
  const auto row = static_cast<int>(std::floor(v - centre_y / 2)) % cells;
  return (row + cells) % cells * cells + (column + cells) % cells;
}

std::vector<Dot> dots_of(const Spot& spot, const ReachedScreen& s, const Tile& tile) {
  const SpotCentres centres = spot_centres(spot);
  const long long unit = 2LL * (s.a * s.a + s.b * s.b);  // a cell has so many steps a side
  const auto inside = [unit](long long steps) {
    const long long rest = (steps % unit + unit) % unit;
    return 2 * static_cast<double>(rest) / static_cast<double>(unit) - 1;
  };
  std::vector<Dot> dots;
  dots.reserve(static_cast<std::size_t>(unit / 2));
  for (int y = 0; y < tile.height; ++y) {
    for (int x = 0; x < tile.width; ++x) {
      const long long right = 2LL * x + 1;
      const long long down = 2LL * y + 1;
      const long long along = (right * s.a - down * s.b) * s.cells;
      const long long across = (-right * s.b - down * s.a) * s.cells;
      Dot dot{.x = inside(along), .y = inside(across), .place = y * tile.width + x};
      dot.value = spot_value(spot, dot.x, dot.y);
      const double u = static_cast<double>(along) / static_cast<double>(unit);
      const double v = static_cast<double>(across) / static_cast<double>(unit);
      dot.cell = cell_around(u, v, centres.dot_x, centres.dot_y, s.cells);
      dot.hole_cell = cell_around(u, v, centres.hole_x, centres.hole_y, s.cells);
      dots.push_back(dot);
    }
  }
  return dots;
}

// Where each cell stands among the others when they take their next dot, in (0, 1).
std::vector<double> cell_turns(int cells) {
  const std::vector<std::size_t> order = detail::void_and_cluster({cells, cells}, 0);
  std::vector<double> turns(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    turns[order[i]] = (static_cast<double>(i) + 0.5) / static_cast<double>(order.size());
  }
  return turns;
}

// Reorders dots, given as they would come by their values alone, so that all cells fill alike: of a
// cell with n dots the k-th comes at (k + turn)/n. The first `smallest` come together.
void fill_alike(std::vector<Dot>& dots, int Dot::*cell, const std::vector<double>& turns,
                int smallest) {
  std::vector<int> count(turns.size(), 0);
  for (const Dot& dot : dots) ++count[static_cast<std::size_t>(dot.*cell)];
  struct Timed {
    double time;
    Dot dot;
  };
  std::vector<int> taken(turns.size(), 0);
  std::vector<Timed> timed;
  timed.reserve(dots.size());
  for (const Dot& dot : dots) {
    const auto c = static_cast<std::size_t>(dot.*cell);
    const int k = taken[c]++;
    const double place = k < smallest ? smallest * turns[c] : k + turns[c];
    timed.push_back({place / count[c], dot});
  }
  std::stable_sort(timed.begin(), timed.end(),
                   [](const Timed& a, const Timed& b) { return a.time < b.time; });
  for (std::size_t i = 0; i < dots.size(); ++i) dots[i] = timed[i].dot;
}

// Of dots with equal values, on opposite sides of the centre by turns.
int quadrant(const Dot& dot) {
  if (dot.x > 0) return dot.y > 0 ? 0 : 2;
  return dot.y > 0 ? 3 : 1;
}

// By falling values; what is equal comes in the same order in every cell, then cell by cell.
void sort_by_value(std::vector<Dot>& dots, const std::vector<double>& turns) {
  const auto rest = [&turns](const Dot& dot) {
    return std::tuple(quadrant(dot), dot.x, dot.y, turns[static_cast<std::size_t>(dot.cell)],
                      dot.place);
  };
  std::sort(dots.begin(), dots.end(), [&rest](const Dot& a, const Dot& b) {
    return a.value != b.value ? a.value > b.value : rest(a) < rest(b);
  });
}

// The dots of the tile in the order of inking: the darker half by its dots, the other by its holes.
std::vector<Dot> inked_in_order(std::vector<Dot> dots, int cells, int smallest) {
  const std::vector<double> turns = cell_turns(cells);
  sort_by_value(dots, turns);
  const auto middle = dots.begin() + static_cast<std::ptrdiff_t>(dots.size() / 2);
  std::vector<Dot> holes(dots.rbegin(), std::make_reverse_iterator(middle));
  dots.erase(middle, dots.end());
  fill_alike(dots, &Dot::cell, turns, smallest);
  fill_alike(holes, &Dot::hole_cell, turns, smallest);
  dots.insert(dots.end(), holes.rbegin(), holes.rend());
  return dots;
}

void check_smallest(int smallest, const ReachedScreen& reached) {
  const int most = std::max(1, static_cast<int>(reached.cell_dots() / 4));
  if (smallest >= 1 && smallest <= most) return;
  throw std::invalid_argument("screen: a smallest dot of " + std::to_string(smallest) +
                              " device dots, expected 1 to " + std::to_string(most) +
                              ", a quarter of a cell");
}

}  // namespace

ThresholdMatrix screen_matrix(const Screen& screen) {
  const ReachedScreen reached = reach(screen);
  check_smallest(screen.smallest_dot, reached);
  check_spot(screen.spot);
  const Tile tile = tile_of(reached);
  const std::vector<Dot> inked =
      inked_in_order(dots_of(screen.spot, reached, tile), reached.cells, screen.smallest_dot);
  ThresholdMatrix matrix;
  matrix.name = spot_name(screen.spot) + " screen, " + rounded(reached.lpi, 5) + " lpi, " +
                rounded(reached.angle_deg, 5) + " degrees";
  matrix.source = "supercell [Kang99]";
  matrix.width = tile.width;
  matrix.height = tile.height;
  matrix.shift = tile.shift;
  const std::size_t count = inked.size();
  matrix.ranks = static_cast<int>(std::min<std::size_t>(count, kMostRanks));
  matrix.rank.resize(count);
  for (std::size_t i = 0; i < count; ++i) {  // what is inked first is lit last
    const std::size_t lit = (count - 1 - i) * static_cast<std::size_t>(matrix.ranks) / count;
    matrix.rank[static_cast<std::size_t>(inked[i].place)] = static_cast<std::uint16_t>(lit);
  }
  return matrix;
}

}  // namespace tristim
