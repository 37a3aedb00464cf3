#pragma once

#include <vector>

#include "tristim/measure/pictures.h"

namespace tristim {

/// A tone of the reference and what became of it.
struct TonePoint {
  double reference = 0;  // mean luminance
  double result = 0;
  double share = 0;  // of the picture's pixels
};

/// Whether a result is as light as its reference.
struct ToneFigures {
  double mean_reference = 0;  // luminance of the whole picture
  double mean_result = 0;
  double relative = 0;           // mean_result / mean_reference - 1; 0 where the reference is black
  double lstar_max = 0;          // largest |difference in L*| of the curve's points
  double lstar_mean = 0;         // mean of them
  std::vector<TonePoint> curve;  // up to 32, from dark to light
};

/// Both pictures are averaged over squares of 2 r + 1 pixels, r a 64th of the shorter side and at
/// least 4; pixels are then put into 32 equal steps of L* by the reference. Steps with a thousandth
/// of the pixels or less are left out. The reference is within [0, 1].
///
/// Throws std::invalid_argument where the sizes differ or are 0.
ToneFigures tone_figures(const LuminanceMap& reference, const LuminanceMap& result);

/// The tone of each of `patches` equal columns side by side, without a sixteenth of their width at
/// either edge. Throws std::invalid_argument where the sizes differ or a column has no pixel.
std::vector<TonePoint> patch_tones(const LuminanceMap& reference, const LuminanceMap& result,
                                   int patches);

/// L* of the result less L* of the reference.
double lstar_difference(const TonePoint& point) noexcept;

}  // namespace tristim
