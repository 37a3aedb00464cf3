#pragma once

#include <span>

namespace tristim {

// A curve through measured points that has their shape: pieces of cubics that rise where the points
// rise, are level where they are level, and never overshoot [FritschButland84]. At least one point
// of one x and y each; x strictly ascending, y nowhere falling.

/// The curve at `at`; beyond the ends the end's y.
double monotone_value(std::span<const double> x, std::span<const double> y, double at) noexcept;

/// The lowest x at which the curve reaches `value`; outside of the y the x of that end.
double monotone_inverse(std::span<const double> x, std::span<const double> y,
                        double value) noexcept;

}  // namespace tristim
