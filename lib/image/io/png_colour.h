#pragma once

#include <png.h>

#include <string>

#include "lib/image/io/sample_decoder.h"
#include "tristim/color/primaries.h"

namespace tristim::detail {

/// What the chunks of a PNG file say of its colours [PNG3 4.3]: cICP before sRGB before gAMA and
/// cHRM.
struct PngColour {
  Curve curve = {Curve::Kind::kSrgb};
  Primaries primaries = {};
  std::string words;
  std::string refusal;  // why the colours are not known; empty where they are
};

/// Call it after png_read_info, inside the caller's setjmp.
void read_png_colour(png_structp png, png_infop info, PngColour& colour);

/// EXIF orientation, 1..8, from the bytes of an eXIf chunk; 1 where it says none.
int exif_orientation(const unsigned char* exif, std::size_t size) noexcept;

}  // namespace tristim::detail
