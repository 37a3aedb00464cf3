#pragma once

#include "lib/core/double_double.h"
#include "tristim/light/fresnel.h"

namespace tristim::detail {

/// The functions of tristim/light/fresnel.h, for a cosine that is not rounded.
DoubleDouble fresnel_dielectric(DoubleDouble cos_i, double eta_i, double eta_t) noexcept;
DoubleDouble fresnel_conductor(DoubleDouble cos_i, double eta, double k) noexcept;
DoubleDouble fresnel(const Reflector& reflector, DoubleDouble cos_i) noexcept;
DoubleDouble f0_from_eta(double eta) noexcept;
DoubleDouble eta_from_f0(DoubleDouble f0) noexcept;

}  // namespace tristim::detail
