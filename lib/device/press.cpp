#include "tristim/device/press.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "tristim/core/find.h"

namespace tristim {
namespace {

constexpr std::string_view kProcessInks[] = {"cyan", "magenta", "yellow", "black"};
constexpr std::size_t kBlack = 3;

using Three = std::array<double, 3>;
using Areas = std::array<double, 4>;  // cyan, magenta, yellow, black

Three numbers(const Rgb& c) { return {c.r, c.g, c.b}; }

// A system of three linear equations by Cramer's rule; false where it has no single solution.
bool solve(const std::array<Three, 3>& columns, const Three& right, Three& solution) {
  const auto determinant = [](const Three& a, const Three& b, const Three& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  const double whole = determinant(columns[0], columns[1], columns[2]);
  if (!(std::fabs(whole) > 1e-12)) return false;
  solution = {determinant(right, columns[1], columns[2]) / whole,
              determinant(columns[0], right, columns[2]) / whole,
              determinant(columns[0], columns[1], right) / whole};
  return true;
}

// Newton's method for the areas of three of the inks, `free`, that print `wanted`; the fourth
// stays. Areas may leave [0, 1] a little on the way and at the end.
void fit_areas(const std::array<Three, 4>& absorbed, const std::array<std::size_t, 3>& free,
               const Three& wanted, Areas& areas) {
  constexpr int kMostRounds = 12;
  constexpr double kGood = 1e-7;
  for (int round = 0; round < kMostRounds; ++round) {
    std::array<Three, 3> slopes{};
    Three missing{};
    double worst = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      double light = 1;
      for (std::size_t i = 0; i < 4; ++i) light *= 1 - areas[i] * absorbed[i][j];
      missing[j] = wanted[j] - light;
      worst = std::max(worst, std::fabs(missing[j]));
      for (std::size_t k = 0; k < 3; ++k) {
        const double own = 1 - areas[free[k]] * absorbed[free[k]][j];
        slopes[k][j] = -absorbed[free[k]][j] * light / std::max(own, 1e-6);
      }
    }
    if (worst < kGood) return;
    Three step{};
    if (!solve(slopes, missing, step)) return;
    for (std::size_t k = 0; k < 3; ++k) {
      areas[free[k]] = std::clamp(areas[free[k]] + step[k], -0.5, 1.2);
    }
  }
}

Areas areas_of(const Cmyk& ink) { return {ink.c, ink.m, ink.y, ink.k}; }

Cmyk clipped(const Areas& a) {
  const auto in = [](double area) { return std::clamp(area, 0.0, 1.0); };
  return {in(a[0]), in(a[1]), in(a[2]), in(a[3])};
}

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

// As little of the three colours as the replacement asks for: black takes its share of what they
// have in common, and where one of them would then have to take ink away, black gives way.
Cmyk Separation::measured(const Rgb& light) const noexcept {
  const Three asked = numbers(light);
  Three wanted{};
  for (std::size_t j = 0; j < 3; ++j) wanted[j] = black_[j] + (1 - black_[j]) * asked[j];
  BlackGeneration black = press_.black;
  if (place_[kBlack] < 0) black.replacement = 0;
  black.limit = 4;
  Areas areas = areas_of(cmy_to_cmyk_normalised({1 - asked[0], 1 - asked[1], 1 - asked[2]}, black));
  fit_areas(absorbed_, {0, 1, 2}, wanted, areas);
  const auto least = std::min_element(areas.begin(), areas.begin() + kBlack);
  constexpr double kNoInk = -1e-6;
  if (*least < kNoInk && areas[kBlack] > 0) {
    *least = 0;
    const auto none = static_cast<std::size_t>(least - areas.begin());
    fit_areas(absorbed_, {(none + 1) % kBlack, (none + 2) % kBlack, kBlack}, wanted, areas);
  }
  return clipped(areas);
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
