#pragma once

#include <string>

#include "tristim/dither/spot.h"

namespace tristim::tools {

/// A picture, of 1024 pixels a side at most, as the spot of a screen: its luminances. Throws Error.
SpotPicture read_spot_picture(const std::string& path);

}  // namespace tristim::tools
