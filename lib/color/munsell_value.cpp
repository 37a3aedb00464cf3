#include "tristim/color/munsell_value.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "lib/core/math.h"
#include "lib/core/trigonometry.h"

namespace tristim {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kRounding = 1e-12;  // what matrices may leave on a white

// [ASTMD1535]: the coefficients of V to V^5, for Y in percent.
constexpr std::array kQuintic{1.1914, -0.22533, 0.23352, -0.020484, 0.00081939};

double percent(double value) noexcept {
  double y = 0;
  for (std::size_t i = kQuintic.size(); i-- > 0;) y = (y + kQuintic[i]) * value;
  return y;
}

double percent_slope(double value) noexcept {
  double slope = 0;
  for (std::size_t i = kQuintic.size(); i-- > 0;) {
    slope = slope * value + static_cast<double>(i + 1) * kQuintic[i];
  }
  return slope;
}

double sine(double radians) noexcept {
  return detail::sine_cosine_deg(radians * (180 / std::numbers::pi)).sine;
}

}  // namespace

double luminance_from_munsell_value(double value) noexcept {
  if (!(value >= 0 && value <= 10)) return kNone;
  return std::min(percent(value) / 100, 1.0);  // rounding leaves an ulp above 1 at 10
}

double munsell_value_from_luminance(double luminance) noexcept {
  if (!(luminance >= 0 && luminance <= 1 + kRounding)) return kNone;
  const double y = 100 * luminance;
  // The slope of the quintic is nowhere below 1.1, so Newton steps cannot run away; from these
  // starts, less than .1 off, four leave no more than rounding.
  double value = y < 1 ? y / (1.1914 - 0.1 * y) : ladd1955_value(luminance);
  for (int step = 0; step < 4; ++step) value -= (percent(value) - y) / percent_slope(value);
  return std::clamp(value, 0.0, 10.0);
}

double priest1920_value(double luminance) noexcept { return 10 * std::sqrt(luminance); }

double munsell1933_value(double luminance) noexcept {
  const double y = 100 * luminance;
  return std::sqrt(y * (1.4742 - 0.004743 * y));
}

double moon1943_value(double luminance) noexcept {
  return 1.4 * detail::pow(100 * luminance, 0.426);
}

double saunderson1944_value(double luminance) noexcept {
  return 2.357 * detail::pow(100 * luminance, 0.343) - 1.52;
}

double ladd1955_value(double luminance) noexcept {
  return 2.468 * detail::cbrt(100 * luminance) - 1.636;
}

double mccamy1987_value(double luminance) noexcept {
  const double y = 100 * luminance;
  if (y <= 0.9) return 0.87445 * detail::pow(y, 0.9967);
  const double root = detail::cbrt(y);
  const double dip = 0.1073 * y - 3.084;
  return 2.49268 * root - 1.5614 - 0.985 / (dip * dip + 7.54) + 0.0133 / detail::pow(y, 2.3) +
         0.0084 * sine(4.1 * root + 1) + 0.0221 / y * sine(0.39 * (y - 2)) -
         0.0037 / (0.44 * y) * sine(1.28 * (y - 0.53));
}

}  // namespace tristim
