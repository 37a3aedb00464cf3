#pragma once

#include "lib/color/exact_matrix.h"
#include "tristim/color/adaptation.h"

namespace tristim::detail {

/// adaptation_matrix before it is rounded. The whites have y > 0 or below it.
ExactMatrix exact_adaptation(Chromaticity from, Chromaticity to, Adaptation method) noexcept;

/// Throws std::invalid_argument where a white has no XYZ.
void check_white(Chromaticity white);

}  // namespace tristim::detail
