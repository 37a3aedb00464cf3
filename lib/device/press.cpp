#include "tristim/device/press.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "lib/device/ink_areas.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

constexpr std::string_view kProcessInks[] = {"cyan", "magenta", "yellow", "black"};
constexpr std::size_t kBlack = 3;

using Three = std::array<double, 3>;
using Areas = detail::InkAreas;

Three numbers(const Rgb& c) { return {c.r, c.g, c.b}; }

Areas areas_of(const Cmyk& ink) { return {ink.c, ink.m, ink.y, ink.k}; }

}  // namespace

Rgb printed_light(std::span<const Ink> inks, std::span<const double> areas) noexcept {
  Rgb light{1, 1, 1};
  for (std::size_t i = 0; i < inks.size(); ++i) {
    light.r *= 1 - areas[i] * (1 - inks[i].light.r);
    light.g *= 1 - areas[i] * (1 - inks[i].light.g);
    light.b *= 1 - areas[i] * (1 - inks[i].light.b);
  }
  return light;
}

Rgb darkest_print(const Press& press) noexcept {
  if (const Ink* black = find_by_name(press.inks, kProcessInks[kBlack])) return black->light;
  const std::vector<double> solid(press.inks.size(), 1.0);
  return printed_light(press.inks, solid);
}

Separation::Separation(const Press& press, bool relative_black) : press_(press) {
  place_.fill(-1);
  for (std::size_t i = 0; i < press.inks.size(); ++i) {
    const auto* known =
        std::find_if(std::begin(kProcessInks), std::end(kProcessInks),
                     [&](std::string_view name) { return same_name(name, press.inks[i].name); });
    if (known == std::end(kProcessInks)) continue;
    const auto k = static_cast<std::size_t>(known - kProcessInks);
    place_[k] = static_cast<int>(i);
    const Three light = numbers(press.inks[i].light);
    for (std::size_t j = 0; j < 3; ++j) absorbed_[k][j] = 1 - light[j];
  }
  const auto known = static_cast<std::size_t>(
      std::count_if(place_.begin(), place_.end(), [](int place) { return place >= 0; }));
  const bool process = place_[0] >= 0 && place_[1] >= 0 && place_[2] >= 0;
  if (press.inks.size() != 1 && !(process && known == press.inks.size())) {
    throw std::invalid_argument(
        "press: inks " + list_names(press.inks) +
        "; expected one, or cyan, magenta and yellow with black or without");
  }
  if (relative_black) black_ = numbers(darkest_print(press));
}

// Black takes its share of what the three colours have in common, more or less where the areas
// would not be in range with that.
Cmyk Separation::measured(const Rgb& light) const noexcept {
  const Three asked = numbers(light);
  Three wanted{};
  for (std::size_t j = 0; j < 3; ++j) wanted[j] = black_[j] + (1 - black_[j]) * asked[j];
  BlackGeneration black = press_.black;
  if (place_[kBlack] < 0) black.replacement = 0;
  const Cmyk first = cmy_to_cmyk_normalised({1 - asked[0], 1 - asked[1], 1 - asked[2]},
                                            {black.replacement, BlackGeneration{}.limit});
  const detail::InkAreas areas =
      detail::solve_areas(absorbed_, wanted, areas_of(first), black.limit);
  return {areas[0], areas[1], areas[2], areas[3]};
}

void Separation::areas(const Rgb& light, std::span<double> inks) const noexcept {
  const auto in = [](double c) { return std::clamp(c, 0.0, 1.0); };
  const Rgb inside{in(light.r), in(light.g), in(light.b)};
  if (inks.size() == 1) {
    // One ink has one scale: that of the channel it darkens most.
    const Three ink = numbers(press_.inks[0].light);
    const auto j = static_cast<std::size_t>(std::min_element(ink.begin(), ink.end()) - ink.begin());
    const double wanted = black_[j] + (1 - black_[j]) * numbers(inside)[j];
    inks[0] = in((1 - wanted) / (1 - ink[j]));
    return;
  }
  BlackGeneration black = press_.black;
  if (place_[kBlack] < 0) black.replacement = 0;
  const Cmy cmy{1 - inside.r, 1 - inside.g, 1 - inside.b};
  Cmyk ink;
  if (press_.rule == SeparationRule::kMeasured) ink = limit_ink(measured(inside), black.limit);
  if (press_.rule == SeparationRule::kNormalised) ink = cmy_to_cmyk_normalised(cmy, black);
  if (press_.rule == SeparationRule::kSubtract) ink = cmy_to_cmyk_subtract(cmy, black);
  const Areas areas = areas_of(ink);
  for (std::size_t k = 0; k < areas.size(); ++k) {
    if (place_[k] >= 0) inks[static_cast<std::size_t>(place_[k])] = in(areas[k]);
  }
}

}  // namespace tristim
