#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tristim/dither/threshold_matrix.h"

namespace tristim::detail {

inline constexpr int kMostRanks = 65536;   // a rank is a 16-bit number
inline constexpr int kMostCellSize = 256;  // of as many cells

/// The side that a cell is asked for. Throws std::invalid_argument outside of 1 to kMostCellSize.
inline int cell_size(std::string_view what, const MatrixParameters& parameters) {
  const int size = parameters.size;
  if (size >= 1 && size <= kMostCellSize) return size;
  throw std::invalid_argument("size of a " + std::string(what) + ": " + std::to_string(size) +
                              "; expected 1 to " + std::to_string(kMostCellSize));
}

/// A matrix of this side, its ranks still 0.
inline ThresholdMatrix square_matrix(int side) {
  const std::size_t cells = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
  return {.width = side,
          .height = side,
          .ranks = static_cast<int>(std::min(cells, std::size_t{kMostRanks})),
          .rank = std::vector<std::uint16_t>(cells)};
}

/// Gives the cells of `order`, every cell of the matrix once, the ranks from 0 on, equally often.
inline void assign_ranks(const std::vector<std::size_t>& order, ThresholdMatrix& matrix) {
  const std::size_t ranks = std::min(order.size(), std::size_t{kMostRanks});
  matrix.ranks = static_cast<int>(ranks);
  for (std::size_t i = 0; i < order.size(); ++i) {
    matrix.rank[order[i]] = static_cast<std::uint16_t>(i * ranks / order.size());
  }
}

}  // namespace tristim::detail
