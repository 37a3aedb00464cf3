#pragma once

#include <array>
#include <string_view>

#include "tristim/color/lab.h"
#include "tristim/color/oklab.h"

namespace tristim {

/// What a formula's differences of lightness, chroma and hue are divided by besides its own
/// weights; above 0. 2 for the lightness halves what a difference of lightness counts.
struct DifferenceFactors {
  double lightness = 1, chroma = 1, hue = 1;
  friend constexpr bool operator==(const DifferenceFactors&, const DifferenceFactors&) = default;
};

// Colour differences. Any finite colours; NaN gives NaN. Errors are below 1e-13 for differences up
// to 200; tiny differences are good to 1e-8 of themselves.

/// The distance in L*a*b* [CIE15 8.2.1].
double cie76(Lab first, Lab second) noexcept;

/// How CIE94 weighs chroma C1 of the reference: SC = 1 + chroma C1, SH = 1 + hue C1.
struct Cie94Weights {
  double chroma = 0.045, hue = 0.015;  // graphic arts, with all factors 1
};
inline constexpr Cie94Weights kTextileWeights{0.048, 0.014};  // with lightness factor 2

/// CIE94 [CIE116]. Not symmetric: `reference` decides the weights.
double cie94(Lab reference, Lab sample, Cie94Weights weights = {},
             DifferenceFactors factors = {}) noexcept;

/// CMC(l:c) [Clarke84], l and c the factors; CMC(2:1) judges acceptability, CMC(1:1)
/// perceptibility. Not symmetric: `reference` decides the weights.
double cmc(Lab reference, Lab sample, DifferenceFactors factors = {2, 1, 1}) noexcept;

/// CIEDE2000 [Sharma05 eqs 2-22]; 1 is about a just noticeable difference. Symmetric to the bit.
/// Hues that are exactly opposite take the first branch of equations 10 and 14.
double ciede2000(Lab first, Lab second, DifferenceFactors factors = {}) noexcept;

/// The distance in Oklab [CSS4 delta E OK]; 0.02 is about a just noticeable difference.
double delta_e_ok(Oklab first, Oklab second) noexcept;

/// A formula by its name.
struct DifferenceFormula {
  std::string_view name;
  std::string_view model;  // whose components it takes
  double (*difference)(const std::array<double, 3>& reference, const std::array<double, 3>& sample,
                       DifferenceFactors factors) noexcept;
  DifferenceFactors factors;  // unless others are asked for
  int factor_count;           // how many of them the formula has: lightness, chroma, hue
  bool symmetric;             // else the first colour is the reference
  std::string_view formula;
  std::string_view source;
};

/// Every formula; the first is the default. The command line, the help and the tests read it.
extern const std::array<DifferenceFormula, 7> kDifferenceFormulas;

/// A formula with its factors, as text names it: "ciede2000", "cmc:1.5:1", "ciede2000:2:1:1".
struct DifferenceReference {
  const DifferenceFormula* formula = nullptr;
  DifferenceFactors factors;

  double operator()(const std::array<double, 3>& reference,
                    const std::array<double, 3>& sample) const noexcept {
    return formula->difference(reference, sample, factors);
  }
};

/// Throws Error (kMisuse) "<thing>: ..." for unknown formulas, with the nearest name, and for
/// factors that are not above 0 or of which there are more than the formula has.
DifferenceReference parse_difference(std::string_view text, std::string_view thing);

}  // namespace tristim
