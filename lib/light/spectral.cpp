#include "tristim/light/spectral.h"

#include <algorithm>

#include "lib/core/math.h"
#include "tristim/color/observer.h"
#include "tristim/color/spectrum.h"

namespace tristim {

static_assert(kSum5nm.count() == kSpectralSamples && kSum5nm.first_nm == 380 &&
              kSum5nm.step_nm == 5);

namespace detail {
namespace {

double bell(double lambda_nm, double mu, double sd) noexcept {
  const double z = (lambda_nm - mu) / sd;
  return exp(-(z * z) / 2);
}

}  // namespace

double gauss_reflectance(double lambda_nm, double lo, double hi, double mu, double,
                         double sd) noexcept {
  return lo + (hi - lo) * bell(lambda_nm, mu, sd);
}

double sigmoid_reflectance(double lambda_nm, double lo, double hi, double mu, double,
                           double sd) noexcept {
  return lo + (hi - lo) / (1 + exp(-(lambda_nm - mu) / sd));
}

double double_reflectance(double lambda_nm, double lo, double hi, double mu, double mu2,
                          double sd) noexcept {
  return std::min(1.0, lo + (hi - lo) * (bell(lambda_nm, mu, sd) + bell(lambda_nm, mu2, sd)));
}

}  // namespace detail

SpectralColor sampled_illuminant(const Illuminant& illuminant) {
  const std::vector<double> values = sampled(illuminant_spectrum(illuminant), kSum5nm);
  SpectralColor color;
  std::copy(values.begin(), values.end(), color.at.begin());
  return color;
}

Xyz xyz_of_samples(const SpectralColor& light, const SpectralColor& white) noexcept {
  const Observer& cie1931 = observers()[0];
  Xyz sum;
  double white_y = 0;
  for (std::size_t i = 0; i < kSpectralSamples; ++i) {
    const Xyz matching = matching_functions(cie1931, kSum5nm.lambda_nm(i));
    sum.x += light.at[i] * matching.x;
    sum.y += light.at[i] * matching.y;
    sum.z += light.at[i] * matching.z;
    white_y += white.at[i] * matching.y;
  }
  return {sum.x / white_y, sum.y / white_y, sum.z / white_y};
}

}  // namespace tristim
