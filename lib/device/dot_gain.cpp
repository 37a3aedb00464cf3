#include "tristim/device/dot_gain.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "lib/core/math.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

double covered(const NoGain&, double asked) noexcept { return asked; }
double asked(const NoGain&, double covered) noexcept { return covered; }

double covered(const MurrayDaviesGain& gain, double asked) noexcept {
  return asked + 4 * gain.at_half * asked * (1 - asked);
}
// The parabola solved for its area, in the form that does not cancel as the gain vanishes.
double asked(const MurrayDaviesGain& gain, double covered) noexcept {
  const double b = 1 + 4 * gain.at_half;
  return 2 * covered / (b + std::sqrt(b * b - 16 * gain.at_half * covered));
}

double covered(const YuleNielsenGain& gain, double asked) noexcept {
  const double solid = detail::pow(gain.solid, 1 / gain.n);
  const double light = detail::pow(1 - asked * (1 - solid), gain.n);
  return (1 - light) / (1 - gain.solid);
}
double asked(const YuleNielsenGain& gain, double covered) noexcept {
  const double solid = detail::pow(gain.solid, 1 / gain.n);
  const double light = 1 - covered * (1 - gain.solid);
  return (1 - detail::pow(light, 1 / gain.n)) / (1 - solid);
}

double interpolate(const std::vector<double>& x, const std::vector<double>& y, double at) noexcept {
  const auto above = std::upper_bound(x.begin(), x.end() - 1, at);
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - x.begin(), 1));
  return y[i - 1] + (y[i] - y[i - 1]) * ((at - x[i - 1]) / (x[i] - x[i - 1]));
}
double covered(const MeasuredGain& gain, double asked) noexcept {
  return interpolate(gain.asked, gain.covered, asked);
}
double asked(const MeasuredGain& gain, double covered) noexcept {
  return interpolate(gain.covered, gain.asked, covered);
}

std::string words(const NoGain&) { return {}; }
std::string words(const MurrayDaviesGain& gain) {
  return "a + 4 g a (1 - a), g = " + shortest(gain.at_half);
}
std::string words(const YuleNielsenGain& gain) {
  return "R = (a Rs^(1/n) + 1 - a)^n, n = " + shortest(gain.n) + ", Rs = " + shortest(gain.solid);
}
std::string words(const MeasuredGain& gain) {
  return "measured table of " + std::to_string(gain.asked.size()) +
         " areas, straight lines between";
}

}  // namespace

double covered_area(const DotGain& gain, double a) noexcept {
  const double inside = std::clamp(a, 0.0, 1.0);
  return std::clamp(std::visit([&](const auto& g) { return covered(g, inside); }, gain), 0.0, 1.0);
}

double asked_area(const DotGain& gain, double c) noexcept {
  const double inside = std::clamp(c, 0.0, 1.0);
  return std::clamp(std::visit([&](const auto& g) { return asked(g, inside); }, gain), 0.0, 1.0);
}

std::string describe(const DotGain& gain) {
  return std::visit([](const auto& g) { return words(g); }, gain);
}

}  // namespace tristim
