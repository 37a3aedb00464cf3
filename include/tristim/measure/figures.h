#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tristim/measure/texture.h"
#include "tristim/measure/tone.h"

namespace tristim {

/// A figure that judges a result.
struct Figure {
  std::string name;
  double value = 0;
  bool more_is_better = false;  // else values near 0 are
};

struct FigureOptions {
  std::vector<double> samples_per_degree = {40, 20};  // of the viewers, each above 0
  bool texture = false;                               // the result is one tone: judge its texture
  int patches = 0;                                    // columns of one tone side by side; 0: none
};

/// All that is known of a result.
struct Figures {
  std::vector<Figure> list;
  ToneFigures tone;
  std::optional<TextureFigures> texture;  // where it was asked for and there is one
  std::vector<TonePoint> patches;
};

/// Judges a result against its reference by everything in this module. Light outside of [0, 1]
/// counts as the nearer end, but in max_abs and rms.
///
/// Names are mean_lin_ref, mean_lin_out, tone_rel, tone_max, tone_mean, de00_mean, de00_p95,
/// de00_max, psnr, max_abs, rms; for each viewer scielab_mean@40, scielab_p95@40, hvs_snr@40,
/// hvs_snr_campbell@40; of a texture level, fg, lf_frac, lf_white, aniso_db, peak_frac,
/// checker_frac, worm, nn_ratio, nn_cv, edge_bias, or flat; of patches patch_dL_max and
/// patch_dL_mean. Throws std::invalid_argument as the functions of the figures do.
Figures all_figures(const PicturePair& pictures, const FigureOptions& options = {});

}  // namespace tristim
