#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tristim {

/// A spectral quantity as samples at rising wavelengths: power, radiance, reflectance,
/// transmittance.
struct Spectrum {
  std::vector<double> lambda_nm;
  std::vector<double> value;  // as many
  friend bool operator==(const Spectrum&, const Spectrum&) = default;
};

/// What is wrong with a spectrum, in words that follow its name: fewer than two samples, or
/// wavelengths that are not finite, above 0 and rising. Empty where nothing is.
std::string spectrum_fault(const Spectrum& spectrum);

/// The value at a wavelength: linear between samples, 0 outside them. Takes a spectrum without a
/// fault.
double value_at(const Spectrum& spectrum, double lambda_nm) noexcept;

/// At which wavelengths spectra are sampled to be summed.
struct SumRule {
  std::string_view name;
  int first_nm, last_nm, step_nm;

  constexpr std::size_t count() const {
    return static_cast<std::size_t>((last_nm - first_nm) / step_nm) + 1;
  }
  constexpr int lambda_nm(std::size_t i) const { return first_nm + static_cast<int>(i) * step_nm; }
};

/// Plain sums, which are what the published chromaticities of the illuminants were made by [CIE15].
inline constexpr SumRule kSum5nm{"5nm", 380, 780, 5};
inline constexpr SumRule kSum1nm{"1nm", 360, 830, 1};

/// Every rule. The command line reads this list.
inline constexpr std::array kSumRules{kSum5nm, kSum1nm};

/// The values of a spectrum without a fault at the wavelengths of `rule`.
std::vector<double> sampled(const Spectrum& spectrum, const SumRule& rule);

}  // namespace tristim
