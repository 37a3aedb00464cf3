#pragma once

#include "tristim/color/rgb.h"
#include "tristim/light/samples.h"

namespace tristim::detail {

/// a b, where nothing times infinity is nothing: an unlit or black surface stays black at a light's
/// own place, where the attenuation is infinite.
inline double product(double a, double b) noexcept { return a == 0 || b == 0 ? 0 : a * b; }

inline double sum(double a, double b) noexcept { return a + b; }

inline Rgb product(double a, const Rgb& b) noexcept {
  return {product(a, b.r), product(a, b.g), product(a, b.b)};
}

inline Rgb product(const Rgb& a, const Rgb& b) noexcept {
  return {product(a.r, b.r), product(a.g, b.g), product(a.b, b.b)};
}

inline Rgb sum(const Rgb& a, const Rgb& b) noexcept { return {a.r + b.r, a.g + b.g, a.b + b.b}; }

inline SpectralColor product(double a, SpectralColor b) noexcept {
  for (double& sample : b.at) sample = product(a, sample);
  return b;
}

inline SpectralColor product(const SpectralColor& a, SpectralColor b) noexcept {
  for (std::size_t i = 0; i < kSpectralSamples; ++i) b.at[i] = product(a.at[i], b.at[i]);
  return b;
}

inline SpectralColor sum(const SpectralColor& a, SpectralColor b) noexcept {
  for (std::size_t i = 0; i < kSpectralSamples; ++i) b.at[i] += a.at[i];
  return b;
}

}  // namespace tristim::detail
