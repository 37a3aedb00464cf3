#include "tristim/color/hsv.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tristim/color/hue.h"

namespace tristim {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

bool has_nan(EncodedRgb c) noexcept {
  return std::isnan(c.r) || std::isnan(c.g) || std::isnan(c.b);
}

// Where on the hexagon a colour lies, and between which values.
struct Hexagon {
  double hue_deg = kNone, max = kNone, min = kNone;
};

Hexagon hexagon(EncodedRgb c) noexcept {
  if (has_nan(c)) return {};
  const double max = std::max({c.r, c.g, c.b});
  const double min = std::min({c.r, c.g, c.b});
  if (max == min) return {kNone, max, min};
  const double range = max - min;
  // 60 degrees of the hexagon at a time, from red, green or blue on.
  const double hue = c.r == max   ? 60 * ((c.g - c.b) / range)
                     : c.g == max ? 120 + 60 * ((c.b - c.r) / range)
                                  : 240 + 60 * ((c.r - c.g) / range);
  return {wrap_hue(hue), max, min};
}

EncodedRgb from_hexagon(Hexagon hexagon) noexcept {
  const double max = hexagon.max;
  const double min = hexagon.min;
  if (max == min) return {max, max, max};
  const double hue = wrap_hue(hexagon.hue_deg);
  if (std::isnan(hue)) return {kNone, kNone, kNone};
  const int sextant = static_cast<int>(hue / 60);
  const double along = (hue - 60 * sextant) / 60;  // the difference is exact
  const double rising = min + (max - min) * along;
  const double falling = min + (max - min) * (1 - along);
  switch (sextant) {
    case 0:
      return {max, rising, min};
    case 1:
      return {falling, max, min};
    case 2:
      return {min, max, rising};
    case 3:
      return {min, falling, max};
    case 4:
      return {rising, min, max};
    default:
      return {max, min, falling};
  }
}

// A saturation; none where its denominator vanishes.
double ratio(double range, double denominator) noexcept {
  if (range == 0) return 0;
  return denominator == 0 ? kNone : range / denominator;
}

bool same_color(double hue1, double s1, double l1, double hue2, double s2, double l2) noexcept {
  const bool grey = s1 == 0 && s2 == 0;
  return same_component(s1, s2) && same_component(l1, l2) && (grey || same_hue(hue1, hue2));
}

}  // namespace

Hsv rgb_to_hsv(EncodedRgb rgb) noexcept {
  const Hexagon place = hexagon(rgb);
  return {place.hue_deg, ratio(place.max - place.min, place.max), place.max};
}

EncodedRgb hsv_to_rgb(Hsv hsv) noexcept {
  return from_hexagon({hsv.h, hsv.v, hsv.v * (1 - hsv.s)});
}

Hls rgb_to_hls(EncodedRgb rgb) noexcept {
  const Hexagon place = hexagon(rgb);
  const double sum = place.max + place.min;
  const double denominator = sum <= 1 ? sum : (1 - place.max) + (1 - place.min);
  return {place.hue_deg, sum / 2, ratio(place.max - place.min, denominator)};
}

EncodedRgb hls_to_rgb(Hls hls) noexcept {
  const double half = hls.s * (hls.l <= 0.5 ? hls.l : 1 - hls.l);
  return from_hexagon({hls.h, hls.l + half, hls.l - half});
}

Hsl rgb_to_hsl(EncodedRgb rgb) noexcept {
  const Hls hls = rgb_to_hls(rgb);
  return {hls.h, hls.s, hls.l};
}

EncodedRgb hsl_to_rgb(Hsl hsl) noexcept { return hls_to_rgb({hsl.h, hsl.l, hsl.s}); }

bool same(const Hsv& first, const Hsv& second) noexcept {
  return same_color(first.h, first.s, first.v, second.h, second.s, second.v);
}
bool same(const Hls& first, const Hls& second) noexcept {
  return same_color(first.h, first.s, first.l, second.h, second.s, second.l);
}
bool same(const Hsl& first, const Hsl& second) noexcept {
  return same_color(first.h, first.s, first.l, second.h, second.s, second.l);
}

}  // namespace tristim
