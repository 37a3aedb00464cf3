#pragma once

#include "tristim/color/xyz.h"

namespace tristim::detail {

/// XYZ of a Planckian radiator up to a factor of its own, with derivatives by reciprocal
/// temperature in mired (1e6/T). The factor is a constant to the derivatives.
struct PlanckSums {
  Xyz value, first, second;
};

/// Sums at 1 nm from 360 to 830 by the CIE 1931 observer. mired >= 0; c2 in m K. Cold radiators
/// become the light of 830 nm, without underflow.
PlanckSums planck_sums(double mired, double c2) noexcept;

/// The value alone.
Xyz planck_sum(double mired, double c2) noexcept;

/// (1 - e^-x)/x for x >= 0, 1 at 0, without cancellation: Planck's law is e^-x/(x decay_ratio(x)).
double decay_ratio(double x) noexcept;

}  // namespace tristim::detail
