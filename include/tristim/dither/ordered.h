#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "tristim/dither/levels.h"
#include "tristim/dither/threshold_matrix.h"

namespace tristim {

/// Ordered dither between the levels that bracket a light, at its fraction f of the way, in light:
/// S = floor(f N + 1/2), N the ranks of the matrix; the upper level where S > rank [Shoaff 2.1.2].
///
/// Rows go in any order and on any thread. Light outside the levels takes the end level, NaN the
/// lowest. The codes are the same for every instruction set.
class OrderedDither {
 public:
  OrderedDither(const MixLevels& levels, const ThresholdMatrix& matrix);

  /// Of row `y` of the picture the pixels from `x` on. `strength`, pixel by pixel, 0 .. 1, draws
  /// the thresholds towards half way, where the nearest level changes; empty: 1.
  void row(ChannelRow<const float> in, int y, ChannelRow<std::uint16_t> out,
           std::span<const float> strength = {}, int x = 0) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace tristim
