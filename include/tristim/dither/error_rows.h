#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "tristim/dither/kernel.h"

namespace tristim {

/// The errors that rows still to come have received: the pixel's own row and the two below it, with
/// margins that swallow what falls off the sides.
class ErrorRows {
 public:
  ErrorRows(const DiffusionKernel& kernel, int width, int channels);

  /// What pixel x of the current row has received in `channel`.
  float received(int x, int channel) const noexcept { return rows_[0][index(x, channel)]; }

  /// Shares out the error of pixel x of the current row; `direction` is 1, or -1 for the mirrored
  /// kernel.
  void spread(int x, int channel, float error, int direction) noexcept {
    for (const Tap& tap : taps_) {
      rows_[tap.row][index(x + direction * tap.dx, channel)] += error * tap.weight;
    }
  }

  /// Goes on to the next row.
  void next_row();

 private:
  struct Tap {
    std::size_t row;
    int dx;
    float weight;
  };
  static constexpr int kMargin = 2;  // the reach of a kernel
  std::size_t index(int x, int channel) const noexcept {
    return static_cast<std::size_t>((x + kMargin) * channels_ + channel);
  }
  int channels_;
  std::vector<Tap> taps_;
  std::array<std::vector<float>, 3> rows_;
};

}  // namespace tristim
