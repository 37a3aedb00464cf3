#include "tristim/dither/levels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tristim {
namespace {

// The points above which the upper of two levels is nearer in light.
std::vector<float> half_way(const std::vector<float>& light) {
  std::vector<float> points;
  for (std::size_t i = 1; i < light.size(); ++i) {
    const auto middle = static_cast<float>((double{light[i - 1]} + double{light[i]}) / 2);
    points.push_back(std::nextafter(middle, std::numeric_limits<float>::infinity()));
  }
  return points;
}

}  // namespace

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

LevelDiffusion::LevelDiffusion(const MixLevels& levels, int width, const DiffusionOptions& options)
    : levels_(levels),
      search_(half_way(levels.light)),
      options_(options),
      width_(width),
      errors_(*options.kernel, width, 1) {}

void LevelDiffusion::row(ChannelRow<const float> in, ChannelRow<std::uint16_t> out,
                         std::span<const float> strength) {
  const bool reversed = options_.serpentine && y_ % 2 == 1;
  const int direction = reversed ? -1 : 1;
  const float low = levels_.light.front();
  const float high = levels_.light.back();
  for (int i = 0; i < width_; ++i) {
    const int x = reversed ? width_ - 1 - i : i;
    const float wanted = std::clamp(in[x], low, high) + errors_.received(x, 0);
    const auto level = static_cast<std::size_t>(search_.count_not_above(wanted));
    out[x] = levels_.code[level];
    float error = wanted - levels_.light[level];
    if (!strength.empty()) error *= strength[static_cast<std::size_t>(x)];
    errors_.spread(x, 0, error, direction);
  }
  errors_.next_row();
  ++y_;
}

}  // namespace tristim
