#include "tristim/dither/levels.h"

#include <algorithm>
#include <utility>

namespace tristim {
NearestLevel::NearestLevel(std::span<const float> threshold, std::span<const std::uint16_t> code)
    : search_(threshold), code_(code.begin(), code.end()) {}

void NearestLevel::row(ChannelRow<const float> in, ChannelRow<std::uint16_t> out) const noexcept {
  for (int x = 0; x < in.width; ++x) {
    out[x] = code_[static_cast<std::size_t>(search_.count_not_above(in[x]))];
  }
}

OrderedDither::OrderedDither(MixLevels levels, ThresholdMatrix matrix)
    : levels_(std::move(levels)), matrix_(std::move(matrix)), search_(levels_.light) {
  const auto ranks = static_cast<float>(matrix_.ranks);
  for (std::size_t i = 1; i < levels_.light.size(); ++i) {
    steps_per_light_.push_back(ranks / (levels_.light[i] - levels_.light[i - 1]));
  }
  steps_per_light_.push_back(0);  // above the last level there is nothing to mix with
}

void OrderedDither::row(ChannelRow<const float> in, int y, ChannelRow<std::uint16_t> out,
                        std::span<const float> strength) const noexcept {
  const std::uint16_t* rank = matrix_.row(y);
  const float middle = static_cast<float>(matrix_.ranks) / 2;
  const float* light = levels_.light.data();
  const int last = static_cast<int>(levels_.light.size()) - 1;
  int column = matrix_.column(y);
  for (int x = 0; x < in.width; ++x) {
    const float v = in[x];
    const int lower = std::max(search_.count_not_above(v) - 1, 0);
    const float steps = (v - light[lower]) * steps_per_light_[static_cast<std::size_t>(lower)];
    // floor(s + 1/2) > rank without the call that floor is on old processors; NaN takes the lower
    // level.
    float least = static_cast<float>(rank[column] + 1) - 0.5F;
    if (!strength.empty())
      least = middle + (least - middle) * strength[static_cast<std::size_t>(x)];
    const bool upper = lower < last && steps >= least;
    out[x] = levels_.code[static_cast<std::size_t>(lower + (upper ? 1 : 0))];
    column = column + 1 == matrix_.width ? 0 : column + 1;
  }
}

}  // namespace tristim
