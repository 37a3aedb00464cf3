#pragma once

#include <string_view>

#include "tristim/color/spectral_table.h"
#include "tristim/color/spectrum.h"
#include "tristim/color/xyz.h"

namespace tristim {

/// A standard observer: its matching functions at 1 nm from 360 to 830, columns xbar ybar zbar.
struct Observer {
  std::string_view name;
  std::string_view field_deg;  // also a name of it
  const SpectralTable* table;
};

/// CIE 1931 (2 degrees), the default, and CIE 1964 (10 degrees).
std::span<const Observer> observers() noexcept;

/// The observer of a name or of a field ("cie1964", "10"), or nullptr.
const Observer* find_observer(std::string_view text) noexcept;

/// xbar, ybar, zbar at a whole wavelength in nm; 0 outside 360 to 830.
Xyz matching_functions(const Observer& observer, int lambda_nm) noexcept;

inline constexpr double kLuminousEfficacy = 683;  // K_m in lm/W [CIE15]; [Shoaff 2.2.3] prints 680

/// XYZ of light of the given spectral power, k = 683 lm/W [CIE15 7.1]: of a spectral radiance in
/// W/(m2 sr nm), Y is the luminance in cd/m2. The spectrum has no fault.
Xyz xyz_of_light(const Spectrum& power, const Observer& observer, const SumRule& rule = kSum5nm);

/// XYZ of a reflecting or transmitting object under an illuminant, relative: Y = 1 where it
/// reflects all [CIE15 7.1]. NaN under an illuminant that is dark throughout the rule. The spectra
/// have no fault.
Xyz xyz_of_object(const Spectrum& reflectance, const Spectrum& illuminant, const Observer& observer,
                  const SumRule& rule = kSum5nm);

/// Chromaticity of an illuminant, or of any light, summed by `rule`. NaN for darkness.
Chromaticity chromaticity_of_light(const Spectrum& power, const Observer& observer,
                                   const SumRule& rule = kSum5nm);

}  // namespace tristim
