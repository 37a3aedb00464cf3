#include "tristim/color/planckian.h"

#include <cmath>
#include <limits>

#include "lib/color/planck_sums.h"
#include "lib/core/fast_exp.h"
#include "tristim/color/observer.h"

namespace tristim {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kFirstRadiation = 2 * 6.62607015e-34 * 299792458.0 * 299792458.0;  // 2 h c^2, SI

// 1/(e^x - 1).
double occupation(double x) noexcept { return detail::fast_exp(-x) / (x * detail::decay_ratio(x)); }

double fourth_power(double x) noexcept { return (x * x) * (x * x); }

}  // namespace

double planckian_radiance(double lambda_nm, double temperature_k, double c2) noexcept {
  if (!(temperature_k > 0)) return kNaN;
  const double lambda_m = lambda_nm * 1e-9;
  const double per_nm = kFirstRadiation * 1e-9 / (fourth_power(lambda_m) * lambda_m);
  return per_nm * occupation(c2 / (lambda_m * temperature_k));
}

Chromaticity planckian_chromaticity(double temperature_k, double c2) noexcept {
  if (!(temperature_k > 0)) return {kNaN, kNaN};
  const Xyz sum = detail::planck_sum(1e6 / temperature_k, c2);
  const double total = sum.x + sum.y + sum.z;
  return {sum.x / total, sum.y / total};
}

Xyz planckian_xyz(double temperature_k, double c2) noexcept {
  Xyz xyz;
  for (std::size_t i = 0; i < kSum1nm.count(); ++i) {
    const int lambda = kSum1nm.lambda_nm(i);
    const double power = kLuminousEfficacy * planckian_radiance(lambda, temperature_k, c2);
    const Xyz bar = matching_functions(observers()[0], lambda);
    xyz = {xyz.x + power * bar.x, xyz.y + power * bar.y, xyz.z + power * bar.z};
  }
  return xyz;
}

Spectrum planckian_spectrum(double temperature_k, double c2) {
  Spectrum spectrum;
  const double scaled = 1e9 * c2 / temperature_k;  // x = it / lambda
  for (int lambda = 300; lambda <= 830; ++lambda) {
    // The ratio of two radiances: neither may underflow alone.
    const double rest = scaled * (560 - lambda) / (560.0 * lambda);
    const double ratio = detail::fast_exp(-rest) * detail::decay_ratio(scaled / 560) /
                         detail::decay_ratio(scaled / lambda);
    const double relative = fourth_power(560.0 / lambda) * ratio;
    spectrum.lambda_nm.push_back(lambda);
    spectrum.value.push_back(temperature_k >= 20 ? 100 * relative : kNaN);
  }
  return spectrum;
}

}  // namespace tristim
