#pragma once

#include <cstdint>
#include <optional>

#include "tristim/device/display.h"
#include "tristim/dither/method.h"
#include "tristim/image/view.h"
#include "tristim/measure/texture.h"

namespace tristim {

/// A dither to be tried on a display.
struct DitherTrial {
  const Display& display;
  const NamedDither& dither;
  DitherParameters parameters = {};
};

/// Codes of a picture, and what they look like: light in sRGB's primaries, relative to the black
/// and the white of a palette; of dots with their gain.
struct DitheredPicture {
  Raster<std::uint16_t> codes;
  Image light;
};

/// `light` (three channels in the display's primaries) as the trial dithers it.
DitheredPicture dither_picture(ImageView<const float> light, const DitherTrial& trial);

/// Light of a display's primaries as that of sRGB's, not clipped; grey where the display is.
Image shown_light(ImageView<const float> light, const Display& display);

/// How good what became of a picture is, to a viewer of 40 samples per degree.
struct DitherFigures {
  double tone_lstar = 0;    // largest |dL*| over 17 patches, see dither_tone
  double hvs_snr_db = 0;    // see hvs_snr
  double scielab_mean = 0;  // see scielab
};

/// Judges a trial by a picture, which is light in the display's primaries, and what it became.
DitherFigures judge_dither(ImageView<const float> light, const DitheredPicture& result,
                           const DitherTrial& trial);

/// The largest |difference in L*| over 17 patches, sRGB k/16, of 256 x 256 pixels side by side.
double dither_tone(const DitherTrial& trial);

/// The texture that a grey of 1/16 of the light becomes on 512 x 512 pixels; nothing where it
/// stays flat.
std::optional<TextureFigures> dither_texture(const DitherTrial& trial);

/// A ramp of sRGB greys from black at the left to white.
Image grey_ramp(int width, int height);

/// A display of one bit, black or white, in light.
Display one_bit_display();

}  // namespace tristim
