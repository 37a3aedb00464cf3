#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tristim/dither/screen.h"

namespace tristim {

/// The coarsest pattern that two screens make together: the smallest difference between the
/// frequencies of one and of the other, along their dots and along the diagonals [Amidror00].
struct Beat {
  std::size_t first = 0, second = 0;  // of the screens
  double lpi = 0;                     // of the pattern, its period 1/lpi inch; 0: they are the same
  double period_cells = 0;            // in cells of the coarser screen; infinite where lpi is 0
  bool visible = false;               // the pattern is coarse enough to be seen
};

/// Beats slower than this part of the ruling are seen as patterns: 30 degrees between screens make
/// 0.52, the 15 degrees between yellow and its neighbours 0.26.
inline constexpr double kLeastBeat = 0.25;

/// The beat of each pair of screens; visible where it is slower than `least` of the coarser ruling.
std::vector<Beat> beats(std::span<const ReachedScreen> screens, double least = kLeastBeat);

}  // namespace tristim
