#pragma once

#include <optional>

#include "tristim/measure/texture.h"

namespace tristim::detail {

/// How the rarer pixels of a picture of two values lie, in its first 512 x 512 pixels. `level` is
/// the mean between the two. Nothing for other pictures and densities, and for fewer than 8 pixels.
std::optional<MinorityFigures> minority_figures(const LuminanceMap& picture, double darkest,
                                                double lightest, double level);

}  // namespace tristim::detail
