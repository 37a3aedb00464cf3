#pragma once

#include <optional>
#include <vector>

#include "tristim/measure/pictures.h"

namespace tristim {

/// Power of a picture's noise by radial frequency [Ulichney87].
struct RadialSpectrum {
  struct Ring {
    double frequency = 0;   // cycles per sample, multiples of 1 / (side of the segments)
    double power = 0;       // mean over the ring, relative to the variance: white noise is 1
    double anisotropy = 0;  // variance of the ring's powers over the square of their mean
  };
  std::vector<Ring> rings;
  int segments = 0;  // periodograms averaged
};

/// How the pixels of the rarer of two values lie; known for densities of 1e-4 to .12.
struct MinorityFigures {
  double worm = 0;  // pairs in the most frequent of 8 directions over the mean; 1: isotropic
  double nearest_ratio = 0;  // mean distance to the next one over the principal wavelength
  double nearest_cv = 0;     // its standard deviation over its mean
};

/// The texture that a constant tone became.
struct TextureFigures {
  double level = 0;          // mean between the darkest and the lightest value
  double principal = 0;      // frequency of the evenest pattern of that level, cycles per sample
  double low_share = 0;      // noise power at half of that and below; blue noise 0
  double low_white = 0;      // what white noise has there
  double anisotropy_db = 0;  // mean over the rings; -10 log10(segments) if isotropic
  double peak_share = 0;     // of the strongest frequency; periodic patterns go to 1
  double checker_share = 0;  // at (.5, .5), (0, .5) and (.5, 0) and beside them
  double edge_bias = 0;      // |mean of the first 8 rows / mean of the centre - 1|
  std::optional<MinorityFigures> minority;
  RadialSpectrum spectrum;
};

/// Judges one tone [Ulichney87] over segments of 128 x 128 pixels that overlap by half, under a
/// Bartlett window. Nothing where the picture is flat or a side is below 8.
std::optional<TextureFigures> texture_figures(const LuminanceMap& picture);

}  // namespace tristim
