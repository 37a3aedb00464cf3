#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "tristim/palette/hull.h"

namespace tristim::detail {

using HullFace = PaletteHull::HalfSpace;

/// PaletteHull::inside() of a row of colours, in planes, where the palette has a volume: the same
/// operations in vectors. `rounding`: how far beyond a face is still inside.
void hull_inside_row(std::span<const HullFace> faces, const std::array<float, 3>& centre,
                     float rounding, const std::array<float*, 3>& planes, std::size_t count);

}  // namespace tristim::detail
