#pragma once

#include <array>
#include <string_view>

#include "tristim/color/illuminant.h"
#include "tristim/color/xyz.h"
#include "tristim/light/samples.h"

namespace tristim {

/// An illuminant at the samples; 0 where it has no data.
SpectralColor sampled_illuminant(const Illuminant& illuminant);

namespace detail {
double gauss_reflectance(double lambda_nm, double lo, double hi, double mu, double mu2,
                         double sd) noexcept;
double sigmoid_reflectance(double lambda_nm, double lo, double hi, double mu, double mu2,
                           double sd) noexcept;
double double_reflectance(double lambda_nm, double lo, double hi, double mu, double mu2,
                          double sd) noexcept;
}  // namespace detail

/// A family of smooth reflectances from `lo` to `hi`; mu, mu2 and sd (above 0) in nm.
struct ReflectanceShape {
  std::string_view name;
  std::string_view formula;  // g(m) = exp(-((lambda - m)/sd)^2/2)
  double (*at)(double lambda_nm, double lo, double hi, double mu, double mu2, double sd) noexcept;
  bool two_peaks;  // mu2 counts
};

/// Every shape. The command line reads this list.
inline constexpr std::array kReflectanceShapes{
    ReflectanceShape{"gauss", "lo + (hi - lo) g(mu)", detail::gauss_reflectance, false},
    ReflectanceShape{"sigmoid", "lo + (hi - lo)/(1 + exp(-(lambda - mu)/sd))",
                     detail::sigmoid_reflectance, false},
    ReflectanceShape{"double", "min(1, lo + (hi - lo)(g(mu) + g(mu2)))", detail::double_reflectance,
                     true},
};

/// XYZ of light by plain sums with the CIE 1931 observer, relative to `white`: an even reflector
/// under it has Y = 1 [CIE15 7.1]. NaN where the white is dark.
Xyz xyz_of_samples(const SpectralColor& light, const SpectralColor& white) noexcept;

}  // namespace tristim
