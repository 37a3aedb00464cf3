#include "lib/dither/skewed_rows.h"

#include <algorithm>
#include <cassert>

namespace tristim::detail {
namespace {

constexpr int kMostSteps = 32;  // that rows side by side go on beyond their end

// The least skew with which every error is there when it is asked for.
int least_skew(const ErrorRows& errors, bool closed) {
  int skew = 1;
  for (const ErrorRows::Tap& tap : errors.taps()) {
    if (tap.row == 1) skew = std::max(skew, 1 - tap.dx);
    if (closed) skew = std::max(skew, 1 + tap.dx);
  }
  // A row that is `skew` behind the one above is twice that behind the next.
  for (const ErrorRows::Tap& tap : errors.taps()) {
    while (tap.row * skew + tap.dx < 1) ++skew;
  }
  for (int dx = 1; closed && dx <= ErrorRows::kMargin; ++dx) {
    if (errors.weight_before()[static_cast<std::size_t>(dx) - 1] != 0) {
      skew = std::max(skew, 1 + dx);
    }
  }
  return skew;
}

}  // namespace

SkewedRows::SkewedRows(const ErrorRows& errors, bool closed_kernel)
    : closed(closed_kernel), skew(least_skew(errors, closed_kernel)) {
  for (const ErrorRows::Tap& tap : errors.taps()) {
    above.push_back({tap.row, tap.row * skew + tap.dx, tap.weight});
    reach = std::max(reach, tap.row);
    assert(above.back().back <= kMostBack);
  }
  for (int dx = ErrorRows::kMargin; dx > 0; --dx) {
    const float weight = errors.weight_before()[static_cast<std::size_t>(dx) - 1];
    if (weight != 0 || !before.empty()) before.push_back({0, dx, weight});
  }
}

MeetingRows::MeetingRows(int width, const SkewedRows& rows, int most_side_by_side)
    : size_(static_cast<std::size_t>(width)), row_(static_cast<std::size_t>(rows.reach)) {
  const int behind = rows.skew * (most_side_by_side + ErrorRows::kReach);
  const int most = width + ErrorRows::kMargin + behind + kMostSteps;
  for (std::vector<float>& row : row_) row.resize(static_cast<std::size_t>(kFront + most), 0);
}

void MeetingRows::load(ErrorRows& errors, int channel) {
  for (int distance = 1; distance <= static_cast<int>(row_.size()); ++distance) {
    std::ranges::copy(errors.row(distance, channel).subspan(ErrorRows::kMargin, size_),
                      at(0, distance));
  }
  overflow = errors.overflow(channel);
  publish(kAll);
}

void MeetingRows::store(ErrorRows& errors, int channel) const {
  for (int distance = 1; distance <= static_cast<int>(row_.size()); ++distance) {
    std::copy_n(at(0, distance), size_,
                errors.row(distance, channel).subspan(ErrorRows::kMargin).begin());
  }
  errors.overflow(channel) = overflow;
}

void MeetingRows::publish(int columns) noexcept {
  columns_.store(columns, std::memory_order_release);
  columns_.notify_all();
}

void MeetingRows::wait_for(int columns) const noexcept {
  int there = columns_.load(std::memory_order_acquire);
  while (there < columns) {
    columns_.wait(there, std::memory_order_acquire);
    there = columns_.load(std::memory_order_acquire);
  }
}

}  // namespace tristim::detail
