#include <stdexcept>
#include <string>

#include "lib/dither/cells.h"
#include "tristim/dither/matrices.h"

namespace tristim {
namespace {

// De la Loubere's rule as a formula, from 0.
int odd_magic(int x, int y, int n) { return n * ((x + y + 1 + n / 2) % n) + (2 * x + y + 1) % n; }

// Numbers in reading order; those on the diagonals of each 4 x 4 block count from the end.
int doubly_even_magic(int x, int y, int n) {
  const bool on_diagonal = x % 4 == y % 4 || x % 4 + y % 4 == 3;
  const int number = y * n + x;
  return on_diagonal ? n * n - 1 - number : number;
}

// Conway's LUX: each number of a square of half the side becomes a 2 x 2 block, whose four numbers
// go in the order that the letters draw: k + 1 rows of L, one of U, the rest of X; the middle U and
// the L above it change places.
int singly_even_magic(int x, int y, int n) {
  constexpr int kL[2][2] = {{3, 0}, {1, 2}};
  constexpr int kU[2][2] = {{0, 3}, {1, 2}};
  constexpr int kX[2][2] = {{0, 3}, {2, 1}};
  const int half = n / 2;
  const int k = half / 2;
  const int column = x / 2;
  const int row = y / 2;
  const bool middle = column == k;
  const bool is_l = middle ? row < k || row == k + 1 : row <= k;
  const bool is_u = middle ? row == k : row == k + 1;
  const auto& letter = is_l ? kL : is_u ? kU : kX;
  return 4 * odd_magic(column, row, half) + letter[y % 2][x % 2];
}

}  // namespace

ThresholdMatrix magic_square_matrix(const MatrixParameters& parameters) {
  const int n = detail::cell_size("magic square", parameters);
  if (n == 2) {
    throw std::invalid_argument("size of a magic square: 2; expected 1 or 3 to " +
                                std::to_string(detail::kMostCellSize) +
                                ", there is none of 2 a side");
  }
  const auto number = n % 2 == 1 ? odd_magic : n % 4 == 0 ? doubly_even_magic : singly_even_magic;
  ThresholdMatrix matrix = detail::square_matrix(n);
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      matrix.rank[static_cast<std::size_t>(y * n + x)] =
          static_cast<std::uint16_t>(number(x, y, n));
    }
  }
  return matrix;
}

}  // namespace tristim
