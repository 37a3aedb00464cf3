#pragma once

#include <string_view>

#include "tristim/color/spectrum.h"
#include "tristim/color/xyz.h"

namespace tristim {

/// The second radiation constant in m K: temperatures are read on the scale it belongs to.
struct RadiationConstant {
  std::string_view name;
  double c2;
  std::string_view source;
};

inline constexpr RadiationConstant kRadiationConstants[] = {
    {"its90", 1.4388e-2, "ITS-90, IPTS-68; [CIE15]"},
    {"codata2018", 1.438776877503933802e-2, "h c / k of the SI since 2019"},
    {"ipts48", 1.4380e-2, "IPTS-48; the nominal temperatures of D50, D55, D65, D75"},
    {"1931", 1.4350e-2, "NBS 1931; illuminant A is 2848 K on this scale"},
};
inline constexpr double kC2 = kRadiationConstants[0].c2;

/// Spectral radiance of a Planckian radiator in W/(m2 sr nm); wavelength in nm, temperature in
/// kelvins. NaN at or below 0 K.
double planckian_radiance(double lambda_nm, double temperature_k, double c2 = kC2) noexcept;

/// Chromaticity of a Planckian radiator: CIE 1931 observer, sum at 1 nm from 360 to 830 [CIE15].
/// At +inf the limit, power as lambda^-4; NaN at or below 0 K. Maximum error 1e-14.
Chromaticity planckian_chromaticity(double temperature_k, double c2 = kC2) noexcept;

/// XYZ of a Planckian radiator in cd/m2, k = 683 lm/W, same observer and sum. Infinite at +inf, NaN
/// at or below 0 K.
Xyz planckian_xyz(double temperature_k, double c2 = kC2) noexcept;

/// Relative spectral power, 300 to 830 nm at 1 nm, 100 at 560 nm. NaN below 20 K, where the ratio
/// of red to green leaves the numbers.
Spectrum planckian_spectrum(double temperature_k, double c2 = kC2);

}  // namespace tristim
