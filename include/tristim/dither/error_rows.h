#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tristim/dither/kernel.h"

namespace tristim {

/// What pixels before it in its row leave for a pixel: the errors of the last three.
struct ErrorsBefore {
  float last = 0, second = 0, third = 0;

  /// With what the rows above leave.
  float received(float above, const std::array<float, 3>& weight) const noexcept {
    return ((above + third * weight[2]) + second * weight[1]) + last * weight[0];
  }
  void push(float error) noexcept {
    third = second;
    second = last;
    last = error;
  }
};

/// The errors of the last rows of a picture, in planes of one channel, and what they leave for the
/// row below: nothing is summed before it is asked for, so that a whole row is summed at once.
///
/// A pixel receives from the rows above, the farthest first, of each what came first; then from
/// the pixels before it, see ErrorsBefore. What falls off the sides is dropped. Of closed kernels
/// it is kept: the first pixel of a row receives what those before it would, and the pixel below
/// the last what those beyond it would.
class ErrorRows {
 public:
  ErrorRows(const DiffusionKernel& kernel, int width, int channels);

  /// Begins a row that goes to the right (1) or to the left (-1): sums up what it receives and
  /// makes its errors 0.
  void begin_row(int direction);

  /// What each pixel of the row receives from the rows above.
  std::span<const float> above(int channel) const noexcept {
    return std::span(above_[static_cast<std::size_t>(channel)]).subspan(kMargin, size_);
  }

  /// The errors of the row's pixels, which whoever decides about them puts here.
  std::span<float> errors(int channel) noexcept { return row(0, channel).subspan(kMargin, size_); }

  /// Weights of the errors of the last three pixels. Of kernels that follow the tone, the last
  /// error is to be weighted already.
  const std::array<float, 3>& weight_before() const noexcept { return before_; }

  /// Of kernels that follow the tone: what pixel `x` gives the row below.
  void give_below(int x, int channel, float error, const ToneWeights& tone) noexcept {
    std::vector<float>& below = below_[0][static_cast<std::size_t>(channel)];
    below[index(x - direction_)] += error * tone.below_last;
    below[index(x)] += error * tone.below;
  }

  /// Ends the row.
  void end_row() noexcept;

  /// Keeps of what rows still to come will receive from those so far only the columns that are not
  /// 0 in `columns`.
  void keep(std::span<const std::uint8_t> columns);

  /// Whether rows still to come receive what keep() left.
  bool keeps() const noexcept { return kept_rows_ > 0; }

  static constexpr int kMargin = 3;  // the reach of a kernel
  static constexpr int kReach = 3;   // rows

  struct Tap {
    int row, dx;  // from the pixel that leaves an error to that which receives it
    float weight;
  };

  /// Those to rows below, in the order in which they are summed up.
  std::span<const Tap> taps() const noexcept { return taps_; }

  /// The errors of the row `distance` above the row to come, 1 to kReach, with margins of 0.
  std::span<float> row(int distance, int channel) noexcept {
    return rows_[static_cast<std::size_t>(distance)][static_cast<std::size_t>(channel)];
  }

  /// What the row to come receives of what fell off at the end of the last one, at that end; of
  /// closed kernels.
  float& overflow(int channel) noexcept { return overflow_[static_cast<std::size_t>(channel)]; }

 private:
  using Planes = std::vector<std::vector<float>>;  // by channel, with margins

  std::size_t index(int x) const noexcept { return static_cast<std::size_t>(x + kMargin); }
  void add(const Planes& from, int direction, const Tap& tap, Planes& to) const;
  void turn_in(std::vector<float>& above, float overflow) const noexcept;

  std::size_t size_;  // pixels of a row
  bool closed_;
  std::vector<Tap> taps_;
  std::array<float, 3> before_{};
  int direction_ = 1;
  std::array<int, kReach + 1> directions_{};
  std::array<Planes, kReach + 1> rows_;  // the row at work and those above
  Planes above_;
  std::array<Planes, kReach> below_;  // given or kept for the next rows
  int kept_rows_ = 0;
  std::vector<float> overflow_;
};

}  // namespace tristim
