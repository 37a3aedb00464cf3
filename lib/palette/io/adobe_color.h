#pragma once

#include "tristim/color/cmyk.h"
#include "tristim/color/lab.h"
#include "tristim/color/rgb.h"

namespace tristim::detail {

/// Colours of swatch files as sRGB. Lab is relative to D50, the white of printing; CMYK is that of
/// the screen, without a press: R = (1 - C)(1 - K).
EncodedRgb color_of_lab_d50(Lab lab);
EncodedRgb color_of_cmyk(Cmyk ink) noexcept;

/// A channel of a float, or of 16 bits, as the code of 16 bits that it is, if it is one: so colours
/// of 8 and 16 bits come back as they were.
double nearest_code16(double channel) noexcept;

}  // namespace tristim::detail
