#pragma once

#include <algorithm>
#include <atomic>
#include <limits>
#include <vector>

#include "lib/core/parallel.h"
#include "tristim/dither/error_rows.h"

namespace tristim::detail {

/// How error diffusion takes rows side by side, each `skew` pixels behind the one above it: what a
/// pixel receives is known when it is its turn, and its step tells which pixels of all rows are.
struct SkewedRows {
  SkewedRows(const ErrorRows& errors, bool closed);

  struct Tap {
    int row;   // above that which receives
    int back;  // steps before it
    float weight;
  };
  std::vector<Tap> above;   // in the order in which they are summed up
  std::vector<Tap> before;  // the same of the row itself, which comes after them
  bool closed;              // the kernel
  int skew = 1;
  int reach = 0;  // rows

  static constexpr int kMostBack = 16;
};

/// The errors of one channel where rows side by side meet the next ones: of the last rows that
/// the kernel reaches down from, with zeros beyond their sides. The rows above leave them column by
/// column, those below may follow on another thread.
class MeetingRows {
 public:
  MeetingRows(int width, const SkewedRows& rows, int most_side_by_side);

  /// From and to where the definition keeps them.
  void load(ErrorRows& errors, int channel);
  void store(ErrorRows& errors, int channel) const;

  /// Error of pixel `x` of the row that is `distance` above the next, from 1 on; x may be what a
  /// row side by side with `most_side_by_side` others, or that above them, reaches beyond the
  /// sides.
  float* at(int x, int distance) noexcept {
    return row_[static_cast<std::size_t>(distance) - 1].data() + kFront + x;
  }
  const float* at(int x, int distance) const noexcept {
    return row_[static_cast<std::size_t>(distance) - 1].data() + kFront + x;
  }

  static constexpr int kAll = std::numeric_limits<int>::max();

  /// So many columns are there, or all and the overflow.
  void publish(int columns) noexcept;
  void wait_for(int columns) const noexcept;

  float overflow = 0;  // see ErrorRows

 private:
  static constexpr int kFront = 2 * SkewedRows::kMostBack;
  std::size_t size_;
  std::vector<std::vector<float>> row_;
  alignas(64) std::atomic<int> columns_ = 0;  // in a cache line that nobody else writes to
};

/// Calls worker(group) for groups of rows that follow one another, each after the ones before it
/// have begun: it may wait for them, and must not throw. On up to `threads` threads, for each of
/// which make_worker() gives one.
template <typename MakeWorker>
void in_turn(int groups, int threads, MakeWorker&& make_worker) {
  std::atomic<int> next = 0;
  parallel_for_rows(std::min(threads, groups), threads, [&](int) {
    auto worker = make_worker();
    for (int group = next++; group < groups; group = next++) worker(group);
  });
}

}  // namespace tristim::detail
