#include "tristim/color/cmyk.h"

#include <algorithm>

namespace tristim {
namespace {

double black_of(Cmy cmy, const BlackGeneration& black) noexcept {
  return black.replacement * std::min({cmy.c, cmy.m, cmy.y});
}

}  // namespace

Cmy rgb_to_cmy(EncodedRgb rgb) noexcept { return {1 - rgb.r, 1 - rgb.g, 1 - rgb.b}; }

EncodedRgb cmy_to_rgb(Cmy cmy) noexcept { return {1 - cmy.c, 1 - cmy.m, 1 - cmy.y}; }

Cmyk limit_ink(Cmyk ink, double limit) noexcept {
  const double sum = ink.c + ink.m + ink.y;
  if (!(sum + ink.k > limit)) return ink;
  const double k = std::min(ink.k, limit);
  const double scale = sum > 0 ? (limit - k) / sum : 1;
  return {ink.c * scale, ink.m * scale, ink.y * scale, k};
}

Cmyk cmy_to_cmyk_subtract(Cmy cmy, const BlackGeneration& black) noexcept {
  const double k = black_of(cmy, black);
  return limit_ink({cmy.c - k, cmy.m - k, cmy.y - k, k}, black.limit);
}

Cmy cmyk_subtract_to_cmy(Cmyk cmyk) noexcept {
  return {cmyk.c + cmyk.k, cmyk.m + cmyk.k, cmyk.y + cmyk.k};
}

Cmyk cmy_to_cmyk_normalised(Cmy cmy, const BlackGeneration& black) noexcept {
  const double k = black_of(cmy, black);
  const double rest = 1 - k;
  const auto cover = [&](double ink) { return rest == 0 ? 0 * (ink - k) : (ink - k) / rest; };
  return limit_ink({cover(cmy.c), cover(cmy.m), cover(cmy.y), k}, black.limit);
}

Cmy cmyk_normalised_to_cmy(Cmyk cmyk) noexcept {
  const double rest = 1 - cmyk.k;
  return {cmyk.c * rest + cmyk.k, cmyk.m * rest + cmyk.k, cmyk.y * rest + cmyk.k};
}

}  // namespace tristim
