#pragma once

#include <vector>

#include "tristim/color/conversion.h"

namespace tristim::detail {

/// XYZ under the white of `from` to XYZ that look alike under `to`.
ConversionStep adaptation_step(const ModelContext& from, Chromaticity to, Adaptation method);

/// Puts a direct edge in the place of the steps through XYZ that it stands for: between linear RGB,
/// Lab and Luv, where white goes to white, so that greys stay exactly neutral.
void use_direct_edges(std::vector<ConversionStep>& steps, Adaptation adaptation);

}  // namespace tristim::detail
