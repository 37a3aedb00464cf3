#pragma once

#include <cstdint>

#include "lib/pipeline/stage_rows.h"
#include "tristim/image/view.h"

namespace tristim::detail {

/// Rows of interleaved pixels of three channels, in place, to rows of one channel after the other,
/// with the lead before.
StageCounts split_rows(ImageView<float> rgb, const RowLead& lead);

/// The way back.
void join_rows(ImageView<std::uint16_t> rgb);

/// One channel of rows so split.
template <typename T>
ImageView<T> plane(ImageView<T> split, int channel) noexcept {
  return {split.data + std::ptrdiff_t{channel} * split.width, split.width, split.height, 1,
          split.stride};
}

}  // namespace tristim::detail
