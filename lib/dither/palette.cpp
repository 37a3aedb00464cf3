#include "tristim/dither/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "lib/color/curve_table.h"
#include "lib/dither/planes.h"

namespace tristim {
namespace {

using Color = MixPalette::Color;

// How far errors may push a colour beyond the palette, in its ranges. Errors of mixable colours
// reach 1.5 (a palette chosen in Oklab takes white at an eighth of its light); at .5 a grey of
// seven inks came out yellow.
constexpr float kSlack = 2;

// Of an error where the palette was chosen for the picture. Undamped, what it cannot mix adds up
// until whole areas are wrong: a mean S-CIELAB of 3.1 in place of 2.4 at 16 colours.
constexpr float kDamped = 0.95F;

float luminance(const Rgb& c) {
  return static_cast<float>(0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b);
}

Color clipped(const float* rgb) noexcept {
  return {std::clamp(rgb[0], 0.0F, 1.0F), std::clamp(rgb[1], 0.0F, 1.0F),
          std::clamp(rgb[2], 0.0F, 1.0F)};
}

Color encoded(const Color& c) noexcept {
  const detail::CurveTable& encode = detail::srgb_encode_table();
  return {encode(c[0]), encode(c[1]), encode(c[2])};
}

// Whether a palette mixes every colour of the screen.
bool holds_cube(const MixPalette& palette) noexcept {
  for (int corner = 0; corner < 8; ++corner) {
    const auto bit = [corner](int channel) { return static_cast<float>(corner >> channel & 1); };
    if (palette.equal_entry({bit(0), bit(1), bit(2)}) < 0) return false;
  }
  return true;
}

}  // namespace

MixPalette::MixPalette(std::span<const Rgb> palette, const Metric& metric, Mix mix, Beyond beyond)
    : nearest_(palette, metric), metric_(metric), mix_(mix), hull_({}), rank_(palette.size()) {
  for (const Rgb& c : palette) {
    Color entry{static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
    if (mix == Mix::kEncoded) entry = encoded(entry);
    entries_.push_back(entry);
  }
  low_ = high_ = entries_.front();
  for (const Color& entry : entries_) {
    for (std::size_t c = 0; c < 3; ++c) {
      low_[c] = std::min(low_[c], entry[c]);
      high_[c] = std::max(high_[c], entry[c]);
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    step_[c] =
        (high_[c] - low_[c]) / static_cast<float>(std::max<std::size_t>(entries_.size(), 2) - 1);
    const float slack = (high_[c] - low_[c]) * kSlack;
    low_[c] -= slack;
    high_[c] += slack;
  }
  if (beyond == Beyond::kMoved) {
    hull_ = PaletteHull(entries_);
  } else if (!holds_cube(*this)) {
    passed_on_ = kDamped;
  }
  std::vector<std::size_t> order(palette.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return luminance(palette[a]) < luminance(palette[b]);
  });
  for (std::size_t i = 0; i < order.size(); ++i) rank_[order[i]] = static_cast<int>(i);
}

Color MixPalette::from_light(const float* rgb) const noexcept {
  const Color light = clipped(rgb);
  return hull_.inside(mix_ == Mix::kEncoded ? encoded(light) : light);
}

void MixPalette::from_light_row(std::span<const float> rgb,
                                const std::array<float*, 3>& planes) const noexcept {
  const std::size_t count = rgb.size() / 3;
  detail::split_row(rgb, planes);
  for (float* plane : planes) {
    for (std::size_t i = 0; i < count; ++i) plane[i] = std::clamp(plane[i], 0.0F, 1.0F);
    if (mix_ == Mix::kLight) continue;
    for (std::size_t i = 0; i < count; ++i) plane[i] = detail::srgb_encode_table()(plane[i]);
  }
  hull_.inside_row(planes, count);
}

int MixPalette::nearest(const Color& color) const noexcept {
  if (mix_ == Mix::kLight) return nearest_.find({color[0], color[1], color[2]});
  const detail::CurveTable& decode = detail::srgb_decode_table();
  return nearest_.find({decode(color[0]), decode(color[1]), decode(color[2])});
}

std::array<float, 3> MixPalette::place(const Color& color) const noexcept {
  if (mix_ == Mix::kLight) return metric_.place({color[0], color[1], color[2]});
  const detail::CurveTable& decode = detail::srgb_decode_table();
  return metric_.place({decode(color[0]), decode(color[1]), decode(color[2])});
}

bool MixPalette::equals(int index, const Color& color) const noexcept {
  const Color& same = entry(index);
  return std::abs(same[0] - color[0]) < kEqual && std::abs(same[1] - color[1]) < kEqual &&
         std::abs(same[2] - color[2]) < kEqual;
}

int MixPalette::equal_entry(const Color& color) const noexcept {
  for (int i = 0; i < size(); ++i) {
    if (equals(i, color)) return i;
  }
  return -1;
}

Color MixPalette::bounded(const Color& color) const noexcept {
  Color held{};
  for (std::size_t c = 0; c < 3; ++c) held[c] = std::clamp(color[c], low_[c], high_[c]);
  return held;
}

void palette_nearest_row(const MixPalette& palette, std::span<const float> rgb,
                         std::span<std::uint16_t> indices) {
  // Not moved into the hull first: nothing is mixed, and the nearest entry is nearest as it is.
  std::vector<float> light(rgb.size());
  for (std::size_t i = 0; i < rgb.size(); ++i) light[i] = std::clamp(rgb[i], 0.0F, 1.0F);
  palette.nearest_row(light, indices);
}

}  // namespace tristim
