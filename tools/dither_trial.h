#pragma once

#include <string>

#include "tristim/device/display.h"
#include "tristim/dither/method.h"
#include "tristim/frame/code.h"
#include "tristim/image/view.h"

namespace tristim::tools {

/// Codes of a picture, and what they look like: light in sRGB's primaries.
struct Dithered {
  Raster<std::uint16_t> codes;
  Image light;
};

/// `light` (three channels in the display's primaries, kept) dithered for a display.
Dithered dither_picture(ImageView<const float> light, const Display& display,
                        const NamedDither& dither);

/// Light of a display's primaries as that of sRGB's, within [0, 1]; grey where the display is.
Image shown_light(ImageView<const float> light, const Display& display);

/// How good a method is.
struct DitherFigures {
  double tone_max = 0;      // largest |dL*| over 17 patches of sRGB k/16
  double hvs_snr = 0;       // dB of the picture at 40 samples per degree
  double scielab_mean = 0;  // of the picture at 40 samples per degree
};

/// Judges a method by a picture, which is light in the display's primaries, and what became of it.
DitherFigures judge_dither(ImageView<const float> light, const Dithered& result,
                           const Display& display, const NamedDither& dither);

/// A ramp of sRGB greys from black at the left to white.
Image grey_ramp(int width, int height);

/// A display of one bit, black or white, in light.
Display one_bit_display();

}  // namespace tristim::tools
