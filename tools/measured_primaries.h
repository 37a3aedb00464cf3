#pragma once

#include <string>

#include "tristim/device/characterize.h"

namespace tristim::tools {

/// The CSV of `device fit --primaries`: rows of a name (red, green, blue, white, black) and X,Y,Z;
/// under the heading name,x,y,Y of chromaticity and luminance. Throws Error that names the line.
MeasuredPrimaries read_measured_primaries(const std::string& file);

}  // namespace tristim::tools
