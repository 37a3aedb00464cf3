#include <algorithm>
#include <cmath>
#include <cstddef>

#include "lib/dither/nearest_cells.h"
#include "lib/dither/position_noise.h"
#include "lib/dither/settle.h"
#include "tristim/dither/palette.h"

namespace tristim {
namespace {

using Color = MixPalette::Color;

constexpr int kChannels = 4;  // of the errors: three, and one that fills a vector

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
      cells_(std::make_unique<detail::NearestCells>(palette)),
      options_(options),
      seed_(detail::noise_seed(options.seed)),
      width_(width),
      errors_(*options.kernel, width, kChannels) {
  if (options.kernel->tones != nullptr) tones_ = options.kernel->tones();
}

PaletteDiffusion::PaletteDiffusion(PaletteDiffusion&&) noexcept = default;
PaletteDiffusion::~PaletteDiffusion() = default;

// By how much chance raises the threshold.
Color PaletteDiffusion::threshold(Place place, const float* rgb, float jitter) const noexcept {
  const float noise = detail::position_noise(place.x, place.y, seed_);
  Color raise{};
  for (std::size_t c = 0; c < 3; ++c) {
    raise[c] = palette_->step()[c] * jitter * (noise - 0.5F);
    if (!tones_.empty()) raise[c] += palette_->step()[c] * tones_[tone_index(rgb[c])].raise * noise;
  }
  return raise;
}

// Takes an entry for a pixel and shares out the error.
int PaletteDiffusion::choose(Place place, const float* rgb, float jitter, float share) noexcept {
  Color color = palette_->from_light(rgb);
  if (const int entry = cells_->equal_entry(color); entry >= 0) return entry;
  const std::array<float, kChannels> received = errors_.received(place.x);
  for (std::size_t c = 0; c < 3; ++c) color[c] += received[c] * share;
  color = palette_->bounded(color);
  Color compared = color;
  if (jitter > 0 || !tones_.empty()) {
    const Color raise = threshold(place, rgb, jitter);
    for (std::size_t c = 0; c < 3; ++c) compared[c] -= raise[c];
  }
  const int index = cells_->nearest(compared);
  const Color& got = palette_->entry(index);
  const float passed = share * palette_->passed_on();
  std::array<float, kChannels> error{};
  for (std::size_t c = 0; c < 3; ++c) error[c] = (color[c] - got[c]) * passed;
  if (tones_.empty()) {
    errors_.spread(place.x, error, place.direction);
    return index;
  }
  for (int c = 0; c < 3; ++c) {
    const auto channel = static_cast<std::size_t>(c);
    errors_.spread(place.x, c, error[channel], place.direction, tones_[tone_index(rgb[channel])]);
  }
  return index;
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
    const bool back = reversed(options_, y);
    const float jitter = std::max(options_.jitter, detail::settling_jitter(y, rows));
    for (int i = 0; i < width_; ++i) {
      const int x = back ? width_ - 1 - i : i;
      if (taking_part[static_cast<std::size_t>(x)] == 0) continue;
      choose({x, y, back ? -1 : 1}, pixel(first, x), jitter, share_of(strength, x));
    }
    errors_.next_row();
  }
  for (int x = 0; x < width_; ++x) {
    if (taking_part[static_cast<std::size_t>(x)] == 0) errors_.clear(x);
  }
}

void PaletteDiffusion::row(std::span<const float> rgb, std::span<std::uint16_t> indices,
                           std::span<const float> strength) noexcept {
  if (y_ == 0 && options_.settled) settle(rgb, strength);
  const bool back = reversed(options_, y_);
  for (int i = 0; i < width_; ++i) {
    const int x = back ? width_ - 1 - i : i;
    indices[static_cast<std::size_t>(x)] = static_cast<std::uint16_t>(
        choose({x, y_, back ? -1 : 1}, pixel(rgb, x), options_.jitter, share_of(strength, x)));
  }
  errors_.next_row();
  ++y_;
}

}  // namespace tristim
