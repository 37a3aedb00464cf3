#pragma once

#include <string_view>

#include "tristim/color/models.h"

namespace tristim {

/// Which way round from one hue to another [CSS4 12.4].
enum class HueArc {
  kShorter,     ///< at most 180 degrees; exactly 180 goes up or down as the numbers do
  kLonger,      ///< at least 180 degrees; from a hue to itself a whole turn
  kIncreasing,  ///< up
  kDecreasing,  ///< down
};

struct NamedHueArc {
  std::string_view name;
  HueArc arc;
};

/// Every arc; the first is the default. The command line and the tests read this list.
inline constexpr NamedHueArc kHueArcs[] = {
    {"shorter", HueArc::kShorter},
    {"longer", HueArc::kLonger},
    {"increasing", HueArc::kIncreasing},
    {"decreasing", HueArc::kDecreasing},
};

/// The colour `t` of the way from `first` to `last`, both of `model`, whose components are mixed in
/// proportion; t beyond 0 and 1 goes on in the same direction.
///
/// A hue goes round by `arc` and comes out in [0, 360), [0, 100) of Munsell; where one end has none
/// it takes the other's, before the arc is chosen. At t = 0 and 1 the other components are exactly
/// those of the ends.
Components interpolate(const ColorModel& model, const Components& first, const Components& last,
                       double t, HueArc arc = HueArc::kShorter) noexcept;

}  // namespace tristim
