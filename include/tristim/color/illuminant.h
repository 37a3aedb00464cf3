#pragma once

#include <span>
#include <string_view>

#include "tristim/color/spectral_table.h"
#include "tristim/color/spectrum.h"
#include "tristim/color/xyz.h"

namespace tristim {

/// A CIE illuminant: relative spectral power, 100 at 560 nm for the standard and daylight ones.
/// A spectrum, not a white point: the white of d65 here is .312721 .329031, not video's kD65.
struct Illuminant {
  std::string_view name;
  std::string_view title;
  const SpectralTable* table;
  std::size_t column;
};

/// A B C D50 D55 D65 D75 E, F1 to F12, LEDs and discharge lamps [CIE15]. The command line reads
/// this list.
std::span<const Illuminant> illuminants() noexcept;

/// The spectrum as published: 5 nm steps; 1 nm for A and D65.
Spectrum illuminant_spectrum(const Illuminant& illuminant);

/// Chromaticity of daylight of a correlated colour temperature in kelvins [CIE15 4.1.2]. NaN
/// outside 4000 to 25000 K, where the formula is not defined.
Chromaticity daylight_chromaticity(double temperature_k) noexcept;

/// Relative spectral power of daylight, 300 to 830 nm at 5 nm, 100 at 560 nm, from the components
/// of [Judd64] with M1 and M2 rounded to three decimals [CIE15 4.1.2]. The D illuminants have
/// nominal temperatures: D50 is that of 5000 K * kNominalDaylight. NaN outside 4000 to 25000 K.
Spectrum daylight_spectrum(double temperature_k);

inline constexpr double kNominalDaylight = 1.4388 / 1.4380;  // c2 today over that of 1931

}  // namespace tristim
