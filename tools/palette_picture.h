#pragma once

#include <string>

#include "tristim/color/rgb.h"
#include "tristim/palette/guidelines.h"
#include "tristim/palette/histogram.h"

namespace tristim::tools {

/// A colour of 8 bits a channel, named "#rrggbb".
ChartColor chart_color(EncodedRgb color);

/// The colours of a picture, over black where it is transparent: all of them where there are up to
/// 64, else 16 of median cut; with their pixels, and which touch. Throws as open_picture does.
Chart picture_chart(const std::string& path);

/// How often a picture has each colour at 8 bits of sRGB a channel, over black where it is
/// transparent. Throws as open_picture does.
Histogram picture_histogram(const std::string& path);

}  // namespace tristim::tools
