#include "tristim/dither/error_rows.h"

#include <algorithm>

namespace tristim {
namespace {

void clear(std::vector<std::vector<float>>& planes) {
  for (auto& plane : planes) std::ranges::fill(plane, 0.0F);
}

}  // namespace

ErrorRows::ErrorRows(const DiffusionKernel& kernel, int width, int channels)
    : size_(static_cast<std::size_t>(width)),
      closed_(kernel.closed),
      overflow_(static_cast<std::size_t>(channels), 0) {
  const auto weight = [&kernel](int row, int dx) {
    const int parts =
        kernel.weight[static_cast<std::size_t>(row)][static_cast<std::size_t>(dx + 3)];
    return static_cast<float>(parts) / static_cast<float>(kernel.divisor);
  };
  for (int row = kReach; row > 0; --row) {
    for (int dx = kMargin; dx >= -kMargin; --dx) {
      if (weight(row, dx) != 0) taps_.push_back({row, dx, weight(row, dx)});
    }
  }
  for (int dx = 1; dx <= kMargin; ++dx) before_[static_cast<std::size_t>(dx) - 1] = weight(0, dx);
  if (kernel.tones != nullptr) before_ = {1, 0, 0};
  const Planes empty(static_cast<std::size_t>(channels),
                     std::vector<float>(size_ + 2 * kMargin, 0.0F));
  rows_.fill(empty);
  below_.fill(empty);
  above_ = empty;
  directions_.fill(1);
}

// What a row leaves by one weight.
void ErrorRows::add(const Planes& from, int direction, const Tap& tap, Planes& to) const {
  const int shift = direction * tap.dx;
  const int first = std::max(shift, 0);
  const int last = static_cast<int>(size_) + 2 * kMargin + std::min(shift, 0);
  for (std::size_t c = 0; c < to.size(); ++c) {
    const float* source = from[c].data() - shift;
    float* target = to[c].data();
    for (int i = first; i < last; ++i) target[i] += source[i] * tap.weight;
  }
}

// Gives what the pixels before the row's first would receive to that, and the overflow of the row
// above to the pixel below its last.
void ErrorRows::turn_in(std::vector<float>& above, float overflow) const noexcept {
  const int last = static_cast<int>(size_) - 1;
  const int first = direction_ > 0 ? 0 : last;
  float before = 0;
  for (int i = kMargin; i >= 1; --i) before += above[index(first - direction_ * i)];
  above[index(first)] += before;
  above[index(directions_[1] > 0 ? last : 0)] += overflow;
}

void ErrorRows::begin_row(int direction) {
  direction_ = direction;
  above_.swap(below_[0]);
  std::rotate(below_.begin(), below_.begin() + 1, below_.end());
  clear(below_.back());
  if (kept_rows_ > 0) --kept_rows_;
  for (const Tap& tap : taps_) {
    const auto row = static_cast<std::size_t>(tap.row);
    add(rows_[row], directions_[row], tap, above_);
  }
  if (closed_) {
    for (std::size_t c = 0; c < above_.size(); ++c) turn_in(above_[c], overflow_[c]);
  }
  clear(rows_[0]);
}

void ErrorRows::end_row() noexcept {
  if (closed_) {
    const int end = direction_ > 0 ? static_cast<int>(size_) : -1;  // the first pixel beyond
    for (std::size_t c = 0; c < above_.size(); ++c) {
      const std::vector<float>& errors = rows_[0][c];
      const auto error = [&](int back) { return errors[index(end - direction_ * back)]; };
      ErrorsBefore before{error(1), error(2), error(3)};
      overflow_[c] = 0;
      for (int i = 0; i < kMargin; ++i) {
        overflow_[c] += before.received(above_[c][index(end + direction_ * i)], before_);
        before.push(0);
      }
    }
  }
  std::rotate(rows_.rbegin(), rows_.rbegin() + 1, rows_.rend());
  std::rotate(directions_.rbegin(), directions_.rbegin() + 1, directions_.rend());
  directions_[1] = direction_;
}

void ErrorRows::keep(std::span<const std::uint8_t> columns) {
  for (int ahead = 0; ahead < kReach; ++ahead) {
    Planes& below = below_[static_cast<std::size_t>(ahead)];
    for (const Tap& tap : taps_) {
      const int row = tap.row - ahead;
      if (row < 1) continue;
      add(rows_[static_cast<std::size_t>(row)], directions_[static_cast<std::size_t>(row)], tap,
          below);
    }
    for (auto& plane : below) {
      for (std::size_t x = 0; x < size_; ++x) {
        if (columns[x] == 0) plane[x + kMargin] = 0;
      }
    }
  }
  for (Planes& row : rows_) clear(row);
  kept_rows_ = kReach;
}

}  // namespace tristim
