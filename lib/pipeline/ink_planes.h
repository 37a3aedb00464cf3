#pragma once

#include <span>
#include <vector>

#include "tristim/device/display.h"

namespace tristim::detail {

/// The tone to ask dots for so that a tone comes out after their gain, both as light from the solid
/// ink (0) to the paper (1).
class ToneBeforeGain {
 public:
  explicit ToneBeforeGain(const DotGain& gain);

  /// Within 3e-5 of asked_area, at the corners of a measured table; else 1e-6. Tones outside of
  /// [0, 1] give at least the nearer end.
  float operator()(float tone) const noexcept;

 private:
  std::vector<float> table_;  // empty: dots gain nothing
};

/// Rows of light to the planes of a press, one for each ink.
class InkPlanes {
 public:
  InkPlanes(const Display& display, BlackPoint black_point);

  int count() const noexcept { return count_; }

  /// `rgb`: light in the device's primaries. `planes`: count() rows, one after the other, of the
  /// tones that the dots of each ink are asked for: 1 leaves the paper bare.
  void row(std::span<const float> rgb, std::span<float> planes) const noexcept;

 private:
  int count_;
  Separation separation_;
  ToneBeforeGain before_gain_;
};

}  // namespace tristim::detail
