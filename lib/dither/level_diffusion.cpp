#include <algorithm>
#include <array>

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

float shared(float error, std::span<const float> strength, int x) noexcept {
  return strength.empty() ? error : error * strength[static_cast<std::size_t>(x)];
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

// Where the threshold of a pixel goes, by chance and by the tone's weights (null where they are
// the same for all).
LevelDiffusion::Raise LevelDiffusion::raise(int x, int y, float clipped,
                                            float jitter) const noexcept {
  if (jitter == 0 && tones_.empty()) return {};
  const float noise = detail::position_noise(x, y, seed_);
  const Bracket between = bracket(levels_.light, lower_, clipped);
  Raise raise{between.step * jitter * (noise - 0.5F), nullptr};
  if (!tones_.empty()) {
    raise.tone = &tones_[tone_index(between.fraction(clipped))];
    raise.by += between.step * raise.tone->raise * noise;
  }
  return raise;
}

// Takes a level for each pixel of a row and leaves the errors. A weak pixel takes as little of the
// others' errors as it gives.
template <typename Choose>
void LevelDiffusion::diffuse_row(const Row& row, Choose&& choose) {
  const bool back = reversed(options_, row.y);
  const int direction = back ? -1 : 1;
  errors_.begin_row(direction);
  const float* above = errors_.above(0).data();
  float* errors = errors_.errors(0).data();
  const std::array<float, 3> weight = errors_.weight_before();
  ErrorsBefore before;
  for (int i = 0; i < width_; ++i) {
    const int x = back ? width_ - 1 - i : i;
    if (!row.taking_part.empty() && row.taking_part[static_cast<std::size_t>(x)] == 0) {
      before.push(0);
      continue;
    }
    const float clipped = std::clamp(row.in[x], levels_.light.front(), levels_.light.back());
    const float wanted = clipped + shared(before.received(above[x], weight), row.strength, x);
    const Raise raised = raise(x, row.y, clipped, row.jitter);
    const std::size_t level = choose(x, wanted - raised.by);
    const float error = shared(wanted - levels_.light[level], row.strength, x);
    if (raised.tone != nullptr) {
      errors_.give_below(x, 0, error, *raised.tone);
      before.push(error * raised.tone->next);
    } else {
      errors[x] = error;
      before.push(error);
    }
  }
  errors_.end_row();
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
    const float jitter = std::max(options_.jitter, detail::settling_jitter(y, rows));
    diffuse_row({first, y, jitter, strength, taking_part}, [this](int, float wanted) {
      return static_cast<std::size_t>(search_.count_not_above(wanted));
    });
  }
  errors_.keep(taking_part);
}

void LevelDiffusion::row(ChannelRow<const float> in, ChannelRow<std::uint16_t> out,
                         std::span<const float> strength) {
  if (y_ == 0 && options_.settled) settle(in, strength);
  diffuse_row({in, y_, options_.jitter, strength, {}}, [&](int x, float wanted) {
    const auto level = static_cast<std::size_t>(search_.count_not_above(wanted));
    out[x] = levels_.code[level];
    return level;
  });
  ++y_;
}

}  // namespace tristim
