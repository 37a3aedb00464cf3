#include "tristim/color/hue.h"

#include <cmath>

namespace tristim {

double wrap_hue(double deg) noexcept {
  const double turned = std::fmod(deg, 360);  // exact
  const double hue = turned < 0 ? turned + 360 : turned + 0.0;
  return hue >= 360 ? 0 : hue;  // just below 0 rounds up to 360
}

bool same_hue(double first_deg, double second_deg) noexcept {
  return same_component(wrap_hue(first_deg), wrap_hue(second_deg));
}

bool same_component(double first, double second) noexcept {
  return first == second || (std::isnan(first) && std::isnan(second));
}

}  // namespace tristim
