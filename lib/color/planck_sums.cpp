#include "lib/color/planck_sums.h"

#include <algorithm>

#include "lib/core/fast_exp.h"
#include "tristim/color/observer.h"

namespace tristim::detail {
namespace {

// x/(e^x - 1) and its derivatives: Planck's law by reciprocal temperature, times lambda^4.
struct Emission {
  double value, first, second;
};

// At x = c2/(lambda T), all times e^(x - rest), x - rest being x at 830 nm: so the power of cold
// radiators does not underflow.
Emission emission(double x, double rest) noexcept {
  if (x == 0) return {1, -0.5, 1.0 / 6};
  const double fall = x * decay_ratio(x);
  const double q = fast_exp(-x) / fall;  // 1/(e^x - 1)
  const double p = 1 / fall;             // 1/(1 - e^-x) = 1 + q
  const double scaled_q = fast_exp(-rest) / fall;
  return {x * scaled_q, scaled_q * (1 - x * p), scaled_q * p * (x * (p + q) - 2)};
}

void add(Xyz& sum, const Xyz& bar, double weight) noexcept {
  sum.x += weight * bar.x;
  sum.y += weight * bar.y;
  sum.z += weight * bar.z;
}

constexpr int kFirst = kSum1nm.first_nm;
constexpr int kLast = kSum1nm.last_nm;

// c2/T in nm, so that x = it / lambda. Below .01 K all but 830 nm has underflowed long before.
double scaled_temperature(double mired, double c2) noexcept {
  return std::min(mired, 1e8) * c2 * 1e3;
}

// x at lambda less x at 830 nm.
double rest_of(double scaled, int lambda_nm) noexcept {
  return scaled * (kLast - lambda_nm) / (double{kLast} * lambda_nm);
}

double inverse_fourth_power(double lambda_nm) noexcept {
  const double ratio = 560 / lambda_nm;
  return (ratio * ratio) * (ratio * ratio);
}

}  // namespace

double decay_ratio(double x) noexcept {
  if (x > 0.5) return (1 - fast_exp(-x)) / x;
  double sum = 0;
  for (std::size_t k = 14; k >= 1; --k) sum = kInverseFactorial[k] - x * sum;
  return sum;
}

PlanckSums planck_sums(double mired, double c2) noexcept {
  const Observer& observer = observers()[0];
  const double scaled = scaled_temperature(mired, c2);
  PlanckSums sums{};
  for (int lambda = kFirst; lambda <= kLast; ++lambda) {
    const Emission e = emission(scaled / lambda, rest_of(scaled, lambda));
    const double weight = inverse_fourth_power(lambda);
    const double slope = c2 * 1e3 / lambda;  // dx by mired
    const Xyz bar = matching_functions(observer, lambda);
    add(sums.value, bar, weight * e.value);
    add(sums.first, bar, weight * slope * e.first);
    add(sums.second, bar, weight * slope * slope * e.second);
  }
  return sums;
}

Xyz planck_sum(double mired, double c2) noexcept {
  const Observer& observer = observers()[0];
  const double scaled = scaled_temperature(mired, c2);
  Xyz sum;
  for (int lambda = kFirst; lambda <= kLast; ++lambda) {
    const double power = fast_exp(-rest_of(scaled, lambda)) / decay_ratio(scaled / lambda);
    add(sum, matching_functions(observer, lambda), inverse_fourth_power(lambda) * power);
  }
  return sum;
}

}  // namespace tristim::detail
