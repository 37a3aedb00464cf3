#pragma once

#include "tristim/measure/pictures.h"

namespace tristim {

/// How far apart two pictures are pixel by pixel. High by design where the result is dithered.
struct PixelFigures {
  double ciede2000_mean = 0;
  double ciede2000_p95 = 0;  // 95 of 100 pixels are nearer
  double ciede2000_max = 0;
  double psnr_db = 0;  // of sRGB-encoded values, peak 1; +inf for equal pictures
  double max_abs = 0;  // of linear light, any channel
  double rms = 0;      // of linear light, all channels
};

/// CIEDE2000 [Sharma05] under the white of sRGB. Light outside of [0, 1] counts as the nearer end,
/// but in max_abs and rms.
PixelFigures pixel_figures(const PicturePair& pictures);

}  // namespace tristim
