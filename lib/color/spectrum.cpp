#include "tristim/color/spectrum.h"

#include <algorithm>
#include <cmath>

#include "tristim/core/text.h"

namespace tristim {

std::string spectrum_fault(const Spectrum& spectrum) {
  const std::vector<double>& lambda = spectrum.lambda_nm;
  if (lambda.size() != spectrum.value.size()) return "has not as many values as wavelengths";
  if (lambda.size() < 2) {
    return "has " + std::string(lambda.empty() ? "no sample" : "one sample") + " of at least two";
  }
  for (std::size_t i = 0; i < lambda.size(); ++i) {
    const std::string here = shortest(lambda[i]) + " nm";
    if (!std::isfinite(lambda[i])) return "has a wavelength that is " + shortest(lambda[i]);
    if (!(lambda[i] > 0)) return "has the wavelength " + here + ", which is not above 0";
    if (i == 0 || lambda[i] > lambda[i - 1]) continue;
    if (lambda[i] == lambda[i - 1]) return "has " + here + " twice";
    return "has " + here + " behind " + shortest(lambda[i - 1]) + " nm: wavelengths must rise";
  }
  return {};
}

double value_at(const Spectrum& spectrum, double lambda_nm) noexcept {
  const std::vector<double>& lambda = spectrum.lambda_nm;
  const auto above = std::lower_bound(lambda.begin(), lambda.end(), lambda_nm);
  if (above == lambda.end()) return 0;
  const auto i = static_cast<std::size_t>(above - lambda.begin());
  if (*above == lambda_nm) return spectrum.value[i];
  if (i == 0) return 0;
  const double t = (lambda_nm - lambda[i - 1]) / (lambda[i] - lambda[i - 1]);
  return (1 - t) * spectrum.value[i - 1] + t * spectrum.value[i];
}

std::vector<double> sampled(const Spectrum& spectrum, const SumRule& rule) {
  std::vector<double> values(rule.count());
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = value_at(spectrum, rule.lambda_nm(i));
  }
  return values;
}

}  // namespace tristim
