#include "tristim/dither/error_rows.h"

#include <algorithm>
#include <utility>

namespace tristim {

ErrorRows::ErrorRows(const DiffusionKernel& kernel, int width, int channels) : channels_(channels) {
  for (std::size_t row = 0; row < kernel.weight.size(); ++row) {
    for (int column = 0; column < 5; ++column) {
      const int weight = kernel.weight[row][static_cast<std::size_t>(column)];
      if (weight == 0) continue;
      taps_.push_back(
          {row, column - 2, static_cast<float>(weight) / static_cast<float>(kernel.divisor)});
    }
  }
  for (auto& row : rows_) row.assign(static_cast<std::size_t>((width + 2 * kMargin) * channels), 0);
}

void ErrorRows::next_row() {
  std::swap(rows_[0], rows_[1]);
  std::swap(rows_[1], rows_[2]);
  std::fill(rows_[2].begin(), rows_[2].end(), 0.0F);
}

}  // namespace tristim
