#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tristim/image/fit.h"

namespace tristim::detail {

/// Rows of floats, aligned as zimg wants them.
class Plane {
 public:
  explicit Plane(std::size_t width) : lines_((width + 15) / 16) {}

  /// Keeps what is there; new rows are 0.
  void resize(std::size_t height) { data_.resize(lines_ * height); }

  float* row(std::size_t y) noexcept { return data_[lines_ * y].samples; }
  std::ptrdiff_t stride() const noexcept { return static_cast<std::ptrdiff_t>(lines_) * 16; }

  /// Moves the rows from `first` on to the top.
  void drop(std::size_t first) noexcept {
    if (first == 0) return;
    std::copy(data_.begin() + static_cast<std::ptrdiff_t>(lines_ * first), data_.end(),
              data_.begin());
  }

 private:
  struct alignas(64) Line {
    float samples[16];
  };
  std::size_t lines_;  // of a row
  std::vector<Line> data_;
};

/// One axis of a plane: of `in` samples the `length` from `start` on become `out`.
struct PlaneAxis {
  std::int64_t in = 0;
  double start = 0;
  double length = 0;
  int out = 0;
};

/// Resamples planes along one axis with zimg: the columns of planes of `other` rows, or the rows of
/// planes of `other` columns.
class PlaneResizer {
 public:
  enum class Along { kColumns, kRows };

  /// `name` is for messages. Throws Error (kContent) where zimg cannot do it.
  PlaneResizer(Along along, const PlaneAxis& axis, std::size_t other, const ResampleFilter& filter,
               std::string name);
  ~PlaneResizer();
  PlaneResizer(const PlaneResizer&) = delete;
  PlaneResizer& operator=(const PlaneResizer&) = delete;

  /// Throws Error (kContent) where zimg fails.
  void run(Plane& in, Plane& out);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tristim::detail
