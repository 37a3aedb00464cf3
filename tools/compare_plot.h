#pragma once

#include <string>
#include <string_view>

#include "tristim/measure/figures.h"

namespace tristim::tools {

/// A drawing of a result's tone curve, and of its radial spectrum and anisotropy where the figures
/// have a texture, as an SVG file.
std::string compare_plot(const Figures& figures, std::string_view title);

}  // namespace tristim::tools
