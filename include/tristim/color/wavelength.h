#pragma once

#include "tristim/color/xyz.h"

namespace tristim {

/// A colour seen from a white: the wavelength whose light, mixed with the white, makes it
/// [Shoaff 2.2.3].
struct DominantWavelength {
  /// In nm; of a purple minus the complementary wavelength; NaN for the white.
  double dominant_nm = 0;
  /// Where the opposite ray meets the spectral locus; NaN where it meets the purple line, and for a
  /// purple, whose dominant_nm says it.
  double complementary_nm = 0;
  /// p_e = CF/CG: the distance of the colour F from the white C over that of the locus or the
  /// purple line, G; above 1 outside of them, 0 for the white.
  double excitation_purity = 0;
  /// p_c = p_e y_G/y_F: the spectral light's share of the luminance; NaN for a purple, 0 for the
  /// white.
  double colorimetric_purity = 0;
};

/// The spectral locus is that of the CIE 1931 observer at 1 nm, joined by straight segments from
/// 380 to 700 nm, with the purple line between its ends. Maximum error of the purities: 1e-14. All
/// NaN for NaN, and where `white` lies outside the locus and no ray meets it.
DominantWavelength dominant_wavelength(Chromaticity color, Chromaticity white) noexcept;

/// The colour of a dominant wavelength (minus the complementary wavelength for a purple) and an
/// excitation purity: the inverse of dominant_wavelength. NaN outside 380 to 700 nm and for purples
/// that are none; purity 0 is the white, whatever the wavelength.
Chromaticity chromaticity_of_wavelength(double dominant_nm, double excitation_purity,
                                        Chromaticity white) noexcept;

/// A point of the spectral locus, linear between whole nanometres; NaN outside 380 to 700 nm.
Chromaticity spectral_locus(double lambda_nm) noexcept;

inline constexpr int kLocusFirstNm = 380;
inline constexpr int kLocusLastNm = 700;

}  // namespace tristim
