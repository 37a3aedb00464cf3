#include "tristim/dither/error_rows.h"

#include <algorithm>

namespace tristim {

ErrorRows::ErrorRows(const DiffusionKernel& kernel, int width, int channels)
    : width_(width), channels_(channels), closed_(kernel.closed) {
  for (std::size_t row = 0; row < kernel.weight.size(); ++row) {
    for (int column = 0; column <= 2 * kMargin; ++column) {
      const int weight = kernel.weight[row][static_cast<std::size_t>(column)];
      if (weight == 0) continue;
      taps_.push_back(
          {row, column - kMargin, static_cast<float>(weight) / static_cast<float>(kernel.divisor)});
    }
  }
  for (auto& row : rows_) row.assign(static_cast<std::size_t>((width + 2 * kMargin) * channels), 0);
}

// Gives what lies in the margins of one row to the outermost pixels of another, from the outside
// inwards.
void ErrorRows::turn_in(const std::vector<float>& margins, std::vector<float>& row) const noexcept {
  for (int channel = 0; channel < channels_; ++channel) {
    for (int i = kMargin; i >= 1; --i) {
      row[index(0, channel)] += margins[index(-i, channel)];
      row[index(width_ - 1, channel)] += margins[index(width_ - 1 + i, channel)];
    }
  }
}

void ErrorRows::next_row() {
  if (closed_) turn_in(rows_[0], rows_[1]);
  std::rotate(rows_.begin(), rows_.begin() + 1, rows_.end());
  std::fill(rows_.back().begin(), rows_.back().end(), 0.0F);
  if (!closed_) return;
  turn_in(rows_[0], rows_[0]);
  for (int i = 1; i <= kMargin; ++i) {
    for (int channel = 0; channel < channels_; ++channel) {
      rows_[0][index(-i, channel)] = 0;
      rows_[0][index(width_ - 1 + i, channel)] = 0;
    }
  }
}

void ErrorRows::clear(int x) noexcept {
  for (auto& row : rows_) {
    for (int channel = 0; channel < channels_; ++channel) row[index(x, channel)] = 0;
  }
}

}  // namespace tristim
