#pragma once

#include <memory>
#include <span>
#include <vector>

#include "tristim/color/illuminant.h"
#include "tristim/color/plane.h"
#include "tristim/color/xyz.h"

namespace tristim {

namespace detail {
class Envelope;
}

/// The colours that reflectances of at most 1 can have under one light: the MacAdam limits
/// [MacAdam35].
///
/// They fill a convex body, the sum of one segment from black to full reflectance per band of the
/// spectrum. Its surface are the optimal colours: spectra of 0 and 1 with two transitions, each
/// anywhere within a band. The limits are exact for the bands that are given.
class OptimalColors {
 public:
  /// `bands`: the XYZ that each band adds to the perfect white, in any scale and order. Takes about
  /// 100 ms for 81 bands and n^2 of that for n times as many. Throws std::invalid_argument where
  /// they have no luminance.
  explicit OptimalColors(std::span<const Xyz> bands);
  ~OptimalColors();
  OptimalColors(OptimalColors&&) noexcept;
  OptimalColors& operator=(OptimalColors&&) noexcept;

  /// The largest luminance factor of a chromaticity, [0, 1]; 0 outside of the spectral locus. NaN
  /// gives NaN. Maximum error 1e-11. About 0.2 us.
  double limit(Chromaticity c) const noexcept;

  /// Whether a reflectance of at most 1 can have this colour; black can, whatever its x and y.
  bool contains(Xyy color) const noexcept;

  /// The polygon of the chromaticities that reach `luminance`: the spectral locus with the purple
  /// line for 0, smaller and smaller about the white towards 1, empty outside of [0, 1).
  std::vector<Chromaticity> boundary(double luminance) const;

  /// The perfect white.
  Chromaticity white() const noexcept;

 private:
  std::vector<Xyz> bands_;                         // of a white with Y = 1; dark ones are left out
  std::unique_ptr<const detail::Envelope> faces_;  // over the hull of the bands' chromaticities
};

/// The optimal colours under an illuminant for the CIE 1931 observer, in 81 bands of 5 nm from 380
/// to 780.
OptimalColors optimal_colors(const Illuminant& illuminant);

}  // namespace tristim
