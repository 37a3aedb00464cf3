#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tristim/frame/code.h"

namespace tristim::detail {

/// Rows of codes as samples of one depth, for files whose samples are all equally deep.
class RowWidening {
 public:
  /// `depth`: bits of the file's samples, no fewer than those of any code.
  RowWidening(const FrameInfo& frame, int depth);

  /// The row itself where all codes have that depth; else valid until the next call.
  std::span<const std::uint16_t> operator()(std::span<const std::uint16_t> codes);

 private:
  std::array<std::vector<std::uint16_t>, 3> wide_;  // the sample of each code
  std::size_t samples_ = 0;                         // of a pixel; 0: codes are samples
  std::vector<std::uint16_t> row_;
};

}  // namespace tristim::detail
