#pragma once

#include <array>

namespace tristim::detail {

/// Areas of cyan, magenta, yellow and black, or what each of them absorbs.
using InkAreas = std::array<double, 4>;
using InkAbsorption = std::array<std::array<double, 3>, 4>;  // 1 - light of a solid; black may be 0

/// The areas in [0, 1], no more than `limit` together, whose light, the product of 1 - area *
/// absorbed for each channel, is `wanted`.
///
/// Of all that are right those with the black of `first`, or the nearest to it that is in range;
/// its other areas are where the search begins. Right to 1e-6 of light for whatever such areas
/// print, by Newton's method; for other lights the areas that come near to it. An ink that absorbs
/// nothing gets no area.
InkAreas solve_areas(const InkAbsorption& absorbed, const std::array<double, 3>& wanted,
                     const InkAreas& first, double limit) noexcept;

}  // namespace tristim::detail
