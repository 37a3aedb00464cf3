#include <algorithm>
#include <cmath>
#include <cstddef>

#include "lib/dither/entry_equals.h"
#include "lib/dither/entry_grid.h"
#include "lib/dither/position_noise.h"
#include "lib/dither/settle.h"
#include "tristim/dither/palette.h"

namespace tristim {
namespace {

using Color = MixPalette::Color;

constexpr int kChannels = 3;

float share_of(std::span<const float> strength, int x) noexcept {
  return strength.empty() ? 1 : strength[static_cast<std::size_t>(x)];
}

bool reversed(const DiffusionOptions& options, int y) noexcept {
  return options.serpentine && (y & 1) != 0;
}

const float* pixel(std::span<const float> rgb, int x) noexcept {
  return rgb.data() + 3 * static_cast<std::ptrdiff_t>(x);
}

// The share of a step between entries by which a colour differs from its nearest: the density of
// the dots that make it.
float tone_of(const MixPalette& palette, const Color& color) noexcept {
  const Color& entry = palette.entry(palette.nearest(color));
  float tone = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    if (palette.step()[c] > 0) {
      tone = std::max(tone, std::abs(color[c] - entry[c]) / palette.step()[c]);
    }
  }
  return std::min(tone, 1.0F);
}

}  // namespace

PaletteDiffusion::PaletteDiffusion(const MixPalette& palette, int width,
                                   const DiffusionOptions& options)
    : palette_(&palette),
      grid_(std::make_unique<const detail::EntryGrid>(palette)),
      equal_entry_(std::make_unique<const detail::EntryEquals>(palette)),
      options_(options),
      seed_(detail::noise_seed(options.seed)),
      width_(width),
      errors_(*options.kernel, width, kChannels) {
  if (options.kernel->tones != nullptr) tones_ = options.kernel->tones();
}

PaletteDiffusion::PaletteDiffusion(PaletteDiffusion&&) noexcept = default;
PaletteDiffusion::~PaletteDiffusion() = default;

// By how much chance raises the threshold.
Color PaletteDiffusion::threshold(int x, int y, const float* rgb, float jitter) const noexcept {
  const float noise = detail::position_noise(x, y, seed_);
  Color raise{};
  for (std::size_t c = 0; c < 3; ++c) {
    raise[c] = palette_->step()[c] * jitter * (noise - 0.5F);
    if (!tones_.empty()) raise[c] += palette_->step()[c] * tones_[tone_index(rgb[c])].raise * noise;
  }
  return raise;
}

// Takes an entry for each pixel of a row and leaves the errors.
void PaletteDiffusion::diffuse_row(const Row& row) {
  const bool back = reversed(options_, row.y);
  errors_.begin_row(back ? -1 : 1);
  const std::array<float, 3> weight = errors_.weight_before();
  std::array<ErrorsBefore, kChannels> before{};
  for (int i = 0; i < width_; ++i) {
    const int x = back ? width_ - 1 - i : i;
    const auto at = static_cast<std::size_t>(x);
    const float* rgb = pixel(row.rgb, x);
    Color color = palette_->from_light(rgb);
    int index = (*equal_entry_)(color);
    const bool taking_part = row.taking_part.empty() || row.taking_part[at] != 0;
    Color error{};
    if (index < 0 && taking_part) {
      const float share = share_of(row.strength, x);
      for (int c = 0; c < kChannels; ++c) {
        const auto channel = static_cast<std::size_t>(c);
        color[channel] += before[channel].received(errors_.above(c)[at], weight) * share;
      }
      color = palette_->bounded(color);
      Color compared = color;
      if (row.jitter > 0 || !tones_.empty()) {
        const Color raise = threshold(x, row.y, rgb, row.jitter);
        for (std::size_t c = 0; c < 3; ++c) compared[c] -= raise[c];
      }
      index = grid_->nearest(compared);
      const float passed = share * palette_->passed_on();
      for (std::size_t c = 0; c < 3; ++c)
        error[c] = (color[c] - palette_->entry(index)[c]) * passed;
    }
    if (row.indices != nullptr) row.indices[at] = static_cast<std::uint16_t>(index);
    for (int c = 0; c < kChannels; ++c) {
      const auto channel = static_cast<std::size_t>(c);
      if (tones_.empty()) {
        errors_.errors(c)[at] = error[channel];
        before[channel].push(error[channel]);
      } else {
        const ToneWeights& tone = tones_[tone_index(rgb[channel])];
        errors_.give_below(x, c, error[channel], tone);
        before[channel].push(error[channel] * tone.next);
      }
    }
  }
  errors_.end_row();
}

// Leaves errors as if the first row went on above, as LevelDiffusion does.
void PaletteDiffusion::settle(std::span<const float> first, std::span<const float> strength) {
  std::vector<std::uint8_t> taking_part(static_cast<std::size_t>(width_), 1);
  if (!options_.kernel->closed) {
    taking_part = detail::flat_pixels(width_, [&](int x) {
      return std::equal(pixel(first, x), pixel(first, x) + 3, pixel(first, x - 1));
    });
  }
  float least = 1;
  for (int x = 0; x < width_; ++x) {
    std::uint8_t& takes_part = taking_part[static_cast<std::size_t>(x)];
    if (takes_part == 0) continue;
    const Color color = palette_->from_light(pixel(first, x));
    if (palette_->equal_entry(color) >= 0) {
      takes_part = 0;
    } else {
      least = std::min(least, tone_of(*palette_, color));
    }
  }
  if (std::ranges::count(taking_part, 1) == 0) return;
  const int rows = detail::settling_rows(least);
  for (int y = -rows; y < 0; ++y) {
    const float jitter = std::max(options_.jitter, detail::settling_jitter(y, rows));
    diffuse_row({first, y, jitter, strength, taking_part, nullptr});
  }
  errors_.keep(taking_part);
}

void PaletteDiffusion::row(std::span<const float> rgb, std::span<std::uint16_t> indices,
                           std::span<const float> strength) {
  if (y_ == 0 && options_.settled) settle(rgb, strength);
  diffuse_row({rgb, y_, options_.jitter, strength, {}, indices.data()});
  ++y_;
}

}  // namespace tristim
