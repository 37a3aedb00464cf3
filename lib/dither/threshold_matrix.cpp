#include "tristim/dither/threshold_matrix.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace tristim {
namespace {

constexpr int kClusteredSide = 8;
constexpr int kClusteredCells = kClusteredSide * kClusteredSide;

struct Cell {
  int x, y;
  int distance2;  // to the nearest dot's centre, in quarter pixels squared
  int dot;        // which of the two dots it belongs to
  int turn;       // the octant around the centre, so that growth goes round
};

// Dots sit at (2, 2) and (6, 6) in pixel corners; the torus wraps.
int offset(int centre, int at) {
  int d = 2 * at + 1 - 2 * centre;  // half pixels
  while (d > kClusteredSide) d -= 2 * kClusteredSide;
  while (d <= -kClusteredSide) d += 2 * kClusteredSide;
  return d;
}

int octant(int dx, int dy) {
  const int quadrant = dy < 0 ? (dx < 0 ? 0 : 1) : (dx < 0 ? 3 : 2);
  const bool steep = std::abs(dy) > std::abs(dx);
  return 2 * quadrant + ((quadrant % 2 == 0) == steep ? 0 : 1);
}

// Both dots grow alike: pixels sorted by distance from their dot, then by turn, then the one dot
// before the other. From half tone on the dots touch, and what grows is the joined shape.
std::array<std::uint16_t, kClusteredCells> clustered_ranks() {
  std::array<Cell, kClusteredCells> cells{};
  for (int y = 0; y < kClusteredSide; ++y) {
    for (int x = 0; x < kClusteredSide; ++x) {
      const int dx[2] = {offset(2, x), offset(6, x)};
      const int dy[2] = {offset(2, y), offset(6, y)};
      const int d2[2] = {dx[0] * dx[0] + dy[0] * dy[0], dx[1] * dx[1] + dy[1] * dy[1]};
      // What lies between the dots goes by halves, so that each hole fills in step with the other.
      const int dot = d2[1] != d2[0] ? (d2[1] < d2[0] ? 1 : 0) : x / (kClusteredSide / 2);
      cells[static_cast<std::size_t>(y * kClusteredSide + x)] = {x, y, d2[dot], dot,
                                                                 octant(dx[dot], dy[dot])};
    }
  }
  std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) {
    if (a.distance2 != b.distance2) return a.distance2 < b.distance2;
    if (a.turn != b.turn) return a.turn < b.turn;
    if (a.dot != b.dot) return a.dot < b.dot;
    return a.y != b.y ? a.y < b.y : a.x < b.x;
  });
  std::array<std::uint16_t, kClusteredCells> ranks{};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    ranks[static_cast<std::size_t>(cells[i].y * kClusteredSide + cells[i].x)] =
        static_cast<std::uint16_t>(i);
  }
  return ranks;
}

// The top level of the recursion is the lowest digit: bits of x and y from the most significant on.
std::uint16_t bayer_rank(int x, int y, int size) {
  constexpr int kD2[2][2] = {{0, 2}, {3, 1}};
  int rank = 0;
  int weight = 1;
  for (int half = size / 2; half >= 1; half /= 2) {
    rank += weight * kD2[(y / half) % 2][(x / half) % 2];
    weight *= 4;
  }
  return static_cast<std::uint16_t>(rank);
}

template <typename Rank>
ThresholdMatrix square(int size, Rank&& rank) {
  ThresholdMatrix matrix{{}, {}, size, size, size * size, {}};
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) matrix.rank.push_back(rank(x, y));
  }
  return matrix;
}

}  // namespace

ThresholdMatrix bayer_matrix(const MatrixParameters& parameters) {
  const int size = parameters.size;
  return square(size, [size](int x, int y) { return bayer_rank(x, y, size); });
}

ThresholdMatrix d3_matrix(const MatrixParameters& /*parameters*/) {
  constexpr std::uint16_t kD3[3][3] = {{6, 8, 4}, {1, 0, 3}, {5, 2, 7}};
  return square(3, [&kD3](int x, int y) { return kD3[y][x]; });
}

ThresholdMatrix clustered_matrix(const MatrixParameters& /*parameters*/) {
  const auto ranks = clustered_ranks();
  return square(kClusteredSide, [&ranks](int x, int y) {
    return ranks[static_cast<std::size_t>(y * kClusteredSide + x)];
  });
}

ThresholdMatrix make_matrix(const MatrixRecipe& recipe, MatrixParameters parameters) {
  if (parameters.size == 0) parameters.size = recipe.size;
  ThresholdMatrix matrix = recipe.make(parameters);
  matrix.name = recipe.name;
  matrix.source = recipe.source;
  return matrix;
}

}  // namespace tristim
