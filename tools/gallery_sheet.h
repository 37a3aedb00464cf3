#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tristim/image/view.h"

namespace tristim::tools {

/// A picture with words below it.
struct GalleryCell {
  std::string title;
  std::vector<std::string> lines;
  Image picture;  // light in sRGB's primaries
  Image ramp;     // of the same width
};

/// All cells, of one size, on white: codes of sRGB, 8 bits. Without a number of columns the sheet
/// is about as wide as a screen of 16:10.
Raster<std::uint16_t> gallery_sheet(const std::vector<GalleryCell>& cells, int columns = 0);

}  // namespace tristim::tools
