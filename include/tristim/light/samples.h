#pragma once

#include <array>
#include <cstddef>

#include "tristim/color/rgb.h"

namespace tristim {

/// How many samples a spectral colour has: 380 to 780 nm in steps of 5.
inline constexpr std::size_t kSpectralSamples = 81;

/// The wavelength of a sample, 0..80.
constexpr double sample_nm(std::size_t i) noexcept { return 380 + 5 * static_cast<double>(i); }

/// Light or a reflectance at 81 wavelengths, which every illumination model takes in the place of
/// Rgb [Shoaff 3.7]. Unitless, as Rgb is.
struct SpectralColor {
  std::array<double, kSpectralSamples> at{};
  friend constexpr bool operator==(const SpectralColor&, const SpectralColor&) = default;
};

/// The same value at every wavelength.
constexpr SpectralColor flat_spectrum(double value) noexcept {
  SpectralColor color;
  for (double& sample : color.at) sample = value;
  return color;
}

/// What a surface reflects that reflects all.
template <typename Color>
inline constexpr Color kWhiteOf = Color{};
template <>
inline constexpr Rgb kWhiteOf<Rgb>{1, 1, 1};
template <>
inline constexpr SpectralColor kWhiteOf<SpectralColor> = flat_spectrum(1);

}  // namespace tristim
