#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "tristim/dither/kernel.h"

namespace tristim {

/// The errors that rows still to come have received: the pixel's own row and the three below it,
/// with margins for what falls off the sides: dropped, or of closed kernels given to the next row's
/// pixel at that side.
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

  /// All of four channels.
  std::array<float, 4> received(int x) const noexcept {
    const float* from = &rows_[0][index(x, 0)];
    return {from[0], from[1], from[2], from[3]};
  }
  void spread(int x, const std::array<float, 4>& error, int direction) noexcept {
    for (const Tap& tap : taps_) {
      float* to = &rows_[tap.row][index(x + direction * tap.dx, 0)];
      for (std::size_t c = 0; c < 4; ++c) to[c] += error[c] * tap.weight;
    }
  }

  /// The same by the weights of a tone.
  void spread(int x, int channel, float error, int direction, const ToneWeights& tone) noexcept {
    rows_[0][index(x + direction, channel)] += error * tone.next;
    rows_[1][index(x - direction, channel)] += error * tone.below_last;
    rows_[1][index(x, channel)] += error * tone.below;
  }

  /// What the pixels of the current row have received, of one channel.
  std::span<float> received_row() noexcept {
    return std::span(rows_[0]).subspan(kMargin, rows_[0].size() - 2 * kMargin);
  }

  /// Goes on to the next row.
  void next_row();

  /// Takes away what column x has received in this row and those below.
  void clear(int x) noexcept;

 private:
  struct Tap {
    std::size_t row;
    int dx;
    float weight;
  };
  static constexpr int kMargin = 3;  // the reach of a kernel
  std::size_t index(int x, int channel) const noexcept {
    return static_cast<std::size_t>((x + kMargin) * channels_ + channel);
  }
  void turn_in(const std::vector<float>& margins, std::vector<float>& row) const noexcept;
  int width_, channels_;
  bool closed_;
  std::vector<Tap> taps_;
  std::array<std::vector<float>, 4> rows_;
};

}  // namespace tristim
