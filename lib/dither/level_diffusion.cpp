#include <algorithm>

#include "lib/dither/half_way.h"
#include "lib/dither/position_noise.h"
#include "lib/dither/settle.h"
#include "tristim/dither/levels.h"

namespace tristim {
namespace {

// Where a light lies between two levels.
struct Bracket {
  float lower = 0, step = 0;
  float fraction(float light) const noexcept { return (light - lower) / step; }
};

Bracket bracket(const std::vector<float>& levels, const LevelSearch& search, float light) noexcept {
  const int last = static_cast<int>(levels.size()) - 1;
  const int lower = std::clamp(search.count_not_above(light) - 1, 0, std::max(last - 1, 0));
  const auto i = static_cast<std::size_t>(lower);
  return {levels[i], levels[static_cast<std::size_t>(std::min(lower + 1, last))] - levels[i]};
}

float share_of(std::span<const float> strength, int x) noexcept {
  return strength.empty() ? 1 : strength[static_cast<std::size_t>(x)];
}

bool reversed(const DiffusionOptions& options, int y) noexcept {
  return options.serpentine && (y & 1) != 0;
}

}  // namespace

LevelDiffusion::LevelDiffusion(const MixLevels& levels, int width, const DiffusionOptions& options)
    : levels_(levels),
      search_(detail::half_way_points(levels.light)),
      lower_(levels.light),
      options_(options),
      seed_(detail::noise_seed(options.seed)),
      width_(width),
      errors_(*options.kernel, width, 1) {
  if (options.kernel->tones != nullptr && levels.light.size() > 1) {
    tones_ = options.kernel->tones();
  }
}

// Takes a level for a pixel and shares out the error. A weak pixel takes as little of the others'
// errors as it gives.
std::size_t LevelDiffusion::choose(Place place, float light, float jitter, float share) noexcept {
  const float clipped = std::clamp(light, levels_.light.front(), levels_.light.back());
  const float wanted = clipped + errors_.received(place.x, 0) * share;
  float raise = 0;  // of the threshold
  const ToneWeights* tone = nullptr;
  if (jitter > 0 || !tones_.empty()) {
    const float noise = detail::position_noise(place.x, place.y, seed_);
    const Bracket between = bracket(levels_.light, lower_, clipped);
    raise = between.step * jitter * (noise - 0.5F);
    if (!tones_.empty()) {
      tone = &tones_[tone_index(between.fraction(clipped))];
      raise += between.step * tone->raise * noise;
    }
  }
  const auto level = static_cast<std::size_t>(search_.count_not_above(wanted - raise));
  const float error = (wanted - levels_.light[level]) * share;
  if (tone != nullptr) {
    errors_.spread(place.x, 0, error, place.direction, *tone);
  } else {
    errors_.spread(place.x, 0, error, place.direction);
  }
  return level;
}

// Leaves errors as if the first row went on above; columns that do not take part keep none.
void LevelDiffusion::settle(ChannelRow<const float> first, std::span<const float> strength) {
  const auto light = [&](int x) {
    return std::clamp(first[x], levels_.light.front(), levels_.light.back());
  };
  std::vector<std::uint8_t> taking_part(static_cast<std::size_t>(width_), 1);
  if (!options_.kernel->closed) {
    taking_part = detail::flat_pixels(width_, [&](int x) { return first[x] == first[x - 1]; });
  }
  float least = 1;  // tone, of those that mix levels at all
  for (int x = 0; x < width_; ++x) {
    const float upper = bracket(levels_.light, lower_, light(x)).fraction(light(x));
    const float tone = std::min(upper, 1 - upper);
    if (!(tone > 0)) taking_part[static_cast<std::size_t>(x)] = 0;
    if (taking_part[static_cast<std::size_t>(x)] != 0) least = std::min(least, tone);
  }
  if (least == 1) return;
  const int rows = detail::settling_rows(least);
  for (int y = -rows; y < 0; ++y) {
    const bool back = reversed(options_, y);
    const float jitter = std::max(options_.jitter, detail::settling_jitter(y, rows));
    for (int i = 0; i < width_; ++i) {
      const int x = back ? width_ - 1 - i : i;
      if (taking_part[static_cast<std::size_t>(x)] == 0) continue;
      choose({x, y, back ? -1 : 1}, first[x], jitter, share_of(strength, x));
    }
    errors_.next_row();
  }
  for (int x = 0; x < width_; ++x) {
    if (taking_part[static_cast<std::size_t>(x)] == 0) errors_.clear(x);
  }
}

void LevelDiffusion::row(ChannelRow<const float> in, ChannelRow<std::uint16_t> out,
                         std::span<const float> strength) {
  if (y_ == 0 && options_.settled) settle(in, strength);
  const bool back = reversed(options_, y_);
  for (int i = 0; i < width_; ++i) {
    const int x = back ? width_ - 1 - i : i;
    const float share = share_of(strength, x);
    out[x] = levels_.code[choose({x, y_, back ? -1 : 1}, in[x], options_.jitter, share)];
  }
  errors_.next_row();
  ++y_;
}

}  // namespace tristim
