#include <algorithm>
#include <cmath>

#include "lib/core/math.h"
#include "lib/core/trigonometry.h"
#include "lib/light/angle.h"
#include "lib/light/quadrature.h"
#include "tristim/light/microfacet.h"

namespace tristim {

namespace detail {
namespace {

using Dd = DoubleDouble;

constexpr double kNothing = 800;  // e^-800 is below every double

double usable_slope(double m) noexcept { return std::clamp(m, 1e-70, 1e70); }

Dd at_most_one(Dd cosine) noexcept { return (cosine - 1).hi > 0 ? Dd(1) : cosine; }

// exp(-(x/m)^2)
Dd bell(Dd x, double m) noexcept {
  const double rough = x.hi / m;
  if (!(rough * rough < kNothing)) return 0;
  const Dd ratio = x / m;
  return exp_precise(-(ratio * ratio));
}

}  // namespace

DoubleDouble gauss_density(DoubleDouble cos_beta, double m) noexcept {
  if (!(cos_beta.hi >= 0)) return 0;
  const Dd c = at_most_one(cos_beta);
  return bell(arctangent(square_root((1 - c) * (1 + c)), c), usable_slope(m));
}

DoubleDouble beckmann_density(DoubleDouble cos_beta, double m) noexcept {
  if (!(cos_beta.hi > 0)) return 0;
  m = usable_slope(m);
  const Dd c = at_most_one(cos_beta);
  const Dd lobe = bell(square_root((1 - c) * (1 + c)) / c, m);
  if (lobe.hi == 0) return 0;
  const Dd divisor = m * c * c;
  return lobe / (divisor * divisor);
}

DoubleDouble blinn_density(DoubleDouble cos_beta, double m) noexcept {
  if (!(cos_beta.hi > 0)) return 0;
  m = usable_slope(m);
  const Dd exponent = Dd(2) / (Dd(m) * m) - 2;
  const Dd n = exponent.hi > 0 ? exponent : 0;
  const Dd c = at_most_one(cos_beta);
  const Dd lobe = c.hi == 1 && c.lo == 0 ? Dd(1) : pow_precise(c, n);
  if (lobe.hi == 0) return 0;
  return (n + 2) / (2 * kPi) * lobe;
}

// c1 = 1/(2 pi int e^-(b/m)^2 cos b sin b db) over [0, pi/2].
double gauss_normaliser(double m) noexcept {
  m = usable_slope(m);
  const double end = std::min(kPi.hi / 2, 7 * m);  // e^-49 is below the rounding
  double mean = 0;
  for (const Node& node : gauss_legendre()) {
    const double b = node.at * end;
    const SineCosine turned = sine_cosine_deg(b * kDegreesPerRadian.hi);
    mean += node.weight * exp(-(b / m) * (b / m)) * turned.cosine * turned.sine;
  }
  return 1 / (2 * kPi.hi * mean * end);
}

double beckmann_normaliser(double) noexcept { return (Dd(1) / kPi).hi; }

double blinn_normaliser(double) noexcept { return 1; }

}  // namespace detail

double microfacet_density(const MicrofacetDistribution& distribution, double cos_beta,
                          double m) noexcept {
  return distribution.density(detail::DoubleDouble(cos_beta), m).hi;
}

double microfacet_normaliser(const MicrofacetDistribution& distribution, double m) noexcept {
  return distribution.normaliser(m);
}

}  // namespace tristim
