#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "lib/dither/cells.h"
#include "tristim/dither/matrices.h"

namespace tristim {
namespace {

struct Cell {
  int x, y;
  int distance2;  // to the nearest dot's centre, in half pixels squared
  int turn;       // the octant around the centre, so that growth goes round
  int dx, dy;     // from the centre, in half pixels
  int dot;        // which of the two dots it belongs to
};

int octant(int dx, int dy) {
  const int quadrant = dy < 0 ? (dx < 0 ? 0 : 1) : (dx < 0 ? 3 : 2);
  const bool steep = std::abs(dy) > std::abs(dx);
  return 2 * quadrant + ((quadrant % 2 == 0) == steep ? 0 : 1);
}

// From a dot's centre to a pixel's in half pixels, the short way round a cell of `side`.
int offset(int twice_centre, int at, int side) {
  int d = 2 * at + 1 - twice_centre;
  while (d > side) d -= 2 * side;
  while (d <= -side) d += 2 * side;
  return d;
}

// The dots are centred a quarter and three quarters along the diagonal.
Cell cell_at(int x, int y, int side) {
  const int centre[2] = {side / 2, side / 2 + side};
  const int dx[2] = {offset(centre[0], x, side), offset(centre[1], x, side)};
  const int dy[2] = {offset(centre[0], y, side), offset(centre[1], y, side)};
  const int d2[2] = {dx[0] * dx[0] + dy[0] * dy[0], dx[1] * dx[1] + dy[1] * dy[1]};
  // What lies between the dots goes by halves, so that each hole fills in step with the other.
  const int dot = d2[1] != d2[0] ? (d2[1] < d2[0] ? 1 : 0) : x / (side / 2);
  return {x, y, d2[dot], octant(dx[dot], dy[dot]), dx[dot], dy[dot], dot};
}

}  // namespace

// Both dots grow alike: pixels sorted by distance from their dot, then by turn, then the one dot
// before the other.
ThresholdMatrix clustered_matrix(const MatrixParameters& parameters) {
  const int side = detail::cell_size("clustered screen", parameters);
  if (side % 2 == 1) {
    throw std::invalid_argument("size of a clustered screen: " + std::to_string(side) +
                                "; expected an even number, for two dots");
  }
  std::vector<Cell> cells;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) cells.push_back(cell_at(x, y, side));
  }
  std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) {
    return std::tie(a.distance2, a.turn, a.dy, a.dx, a.dot) <
           std::tie(b.distance2, b.turn, b.dy, b.dx, b.dot);
  });
  ThresholdMatrix matrix = detail::square_matrix(side);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    matrix.rank[static_cast<std::size_t>(cells[i].y * side + cells[i].x)] =
        static_cast<std::uint16_t>(i);
  }
  return matrix;
}

// Runs of 1, 1, 2, 2, 3, 3, ... pixels, turning right after each.
ThresholdMatrix spiral_matrix(const MatrixParameters& parameters) {
  const int n = detail::cell_size("spiral", parameters);
  ThresholdMatrix matrix = detail::square_matrix(n);
  constexpr int kStep[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  int x = (n - 1) / 2;
  int y = (n - 1) / 2;
  int rank = 0;
  for (int run = 0; rank < n * n; ++run) {
    for (int i = 0; i < run / 2 + 1 && rank < n * n; ++i) {
      matrix.rank[static_cast<std::size_t>(y * n + x)] = static_cast<std::uint16_t>(rank++);
      x += kStep[run % 4][0];
      y += kStep[run % 4][1];
    }
  }
  return matrix;
}

}  // namespace tristim
