#include "tristim/color/interpolate.h"

#include <cmath>

#include "tristim/color/hue.h"

namespace tristim {
namespace {

// What to add to the last hue, both in [0, 360), so that the straight way is the arc.
double turn(double first, double last, HueArc arc) noexcept {
  const double difference = last - first;
  switch (arc) {
    case HueArc::kShorter:
      return difference > 180 ? -360 : difference < -180 ? 360 : 0;
    case HueArc::kLonger:
      return difference > 0 && difference < 180     ? -360
             : difference > -180 && difference <= 0 ? 360
                                                    : 0;
    case HueArc::kIncreasing:
      return difference < 0 ? 360 : 0;
    case HueArc::kDecreasing:
      return difference > 0 ? -360 : 0;
  }
  return 0;
}

double mix(double first, double last, double t) noexcept { return first * (1 - t) + last * t; }

double mix_hues(double first, double last, double t, HueArc arc) noexcept {
  first = wrap_hue(std::isnan(first) ? last : first);
  last = wrap_hue(std::isnan(last) ? first : last);
  return wrap_hue(mix(first, last + turn(first, last, arc), t));
}

}  // namespace

Components interpolate(const ColorModel& model, const Components& first, const Components& last,
                       double t, HueArc arc) noexcept {
  Components mixed{};
  for (std::size_t i = 0; i < component_count(model); ++i) {
    const bool hue = static_cast<int>(i) == model.hue;
    if (!hue) {
      mixed[i] = mix(first[i], last[i], t);
      continue;
    }
    const double degrees = 360 / model.hue_turn;
    mixed[i] = mix_hues(first[i] * degrees, last[i] * degrees, t, arc) / degrees;
  }
  return mixed;
}

}  // namespace tristim
