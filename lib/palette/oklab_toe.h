#pragma once

#include "lib/core/math.h"

namespace tristim::detail {

/// Light at which the cube root gives way. Diffused to seven inks or to the 16 colours of VGA, none
/// leaves streaks in the shadows, 0.02 a relief in the middle tones, 0.3 neither, at the same
/// S-CIELAB difference from the original (18.6).
inline constexpr double kToe = 0.3;

/// Beside colour, which the eye blurs more: errors of lightness are those that it sees. 3-3-2
/// diffused: a mean S-CIELAB of 1.34 without, 1.19 so, 1.13 at 1.5, where errors of colour grow
/// until greys of a few inks lose their tone.
inline constexpr double kLightness = 1.3;

inline float root_of_toe() noexcept { return static_cast<float>(cbrt(kToe)); }

}  // namespace tristim::detail
