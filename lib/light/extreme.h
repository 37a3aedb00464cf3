#pragma once

namespace tristim::detail {

/// A greatest value and where it is.
struct Extreme {
  double place = 0;
  double value = 0;
};

/// The greatest value of a smooth `function` on [0, 1]: the best of 257 places, then golden section
/// [Kiefer53] between its neighbours. Peaks narrower than 1/256 may be missed.
template <typename Function>
Extreme greatest_on_unit_interval(const Function& function) {
  constexpr int kIntervals = 256;
  Extreme best{0, function(0.0)};
  for (int i = 1; i <= kIntervals; ++i) {
    const double place = double(i) / kIntervals;
    const double value = function(place);
    if (value > best.value) best = {place, value};
  }
  constexpr double kGolden = 0.6180339887498949;
  double low = best.place > 0 ? best.place - 1.0 / kIntervals : 0;
  double high = best.place < 1 ? best.place + 1.0 / kIntervals : 1;
  // 64 steps: the place to rounding. A smooth peak needs half as many, a kink all of them.
  for (int step = 0; step < 64; ++step) {
    const double a = high - kGolden * (high - low);
    const double b = low + kGolden * (high - low);
    const Extreme left{a, function(a)};
    const Extreme right{b, function(b)};
    const Extreme& better = left.value >= right.value ? left : right;
    if (better.value > best.value) best = better;
    (left.value >= right.value ? high : low) = left.value >= right.value ? b : a;
  }
  return best;
}

}  // namespace tristim::detail
