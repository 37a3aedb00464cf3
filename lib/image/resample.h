#pragma once

#include <memory>

#include "tristim/image/fit.h"

namespace tristim::detail {

/// What becomes of one axis: `length` pixels from `start` on, inside the picture, become `count`
/// pixels.
struct Span {
  double start = 0;
  double length = 0;
  int count = 0;

  double step() const noexcept { return length / count; }
  bool copies() const noexcept {  // whole pixels, kept as they are
    return length == count && start == static_cast<int>(start);
  }
};

/// The part `columns` x `rows` of the source, resampled. Throws Error (kContent) where the filter
/// cannot be applied or needs more than 4 GiB at once.
std::unique_ptr<RowSource> resample(std::unique_ptr<RowSource> source, Span columns, Span rows,
                                    const ResampleFilter& filter);

}  // namespace tristim::detail
