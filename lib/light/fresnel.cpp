#include "tristim/light/fresnel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lib/light/fresnel_precise.h"

namespace tristim {

namespace detail {
namespace {

constexpr DoubleDouble square(DoubleDouble x) noexcept { return x * x; }

bool any_nan(double a, double b, double c) noexcept {
  return std::isnan(a) || std::isnan(b) || std::isnan(c);
}

// The light as it comes from the front.
struct Meeting {
  DoubleDouble c;    // cos_i in [0, 1]
  DoubleDouble eta;  // eta_t / eta_i
};

// Beyond this, one index is nothing beside the other, and squares would overflow.
constexpr double kLargestRatio = 1e100;

Meeting meeting_of(DoubleDouble cos_i, double eta_i, double eta_t) noexcept {
  if (cos_i.hi < 0) {
    cos_i = -cos_i;
    std::swap(eta_i, eta_t);
  }
  const DoubleDouble c = (cos_i - 1).hi > 0 ? DoubleDouble(1) : cos_i;
  const double ratio = eta_t / eta_i;
  if (ratio >= 1 / kLargestRatio && ratio <= kLargestRatio) return {c, DoubleDouble(eta_t) / eta_i};
  return {c, std::clamp(ratio, 1 / kLargestRatio, kLargestRatio)};
}

// Without a second medium nothing is reflected, but for the grazing ray.
bool one_medium(const Meeting& m) noexcept { return m.eta.hi == 1 && m.eta.lo == 0 && m.c.hi > 0; }

// g^2 = eta^2 - 1 + c^2, whose first difference cancels for nearly equal indices.
DoubleDouble g_squared(const Meeting& m) noexcept {
  return (m.eta - 1) * (m.eta + 1) + square(m.c);
}

}  // namespace

DoubleDouble fresnel_dielectric(DoubleDouble cos_i, double eta_i, double eta_t) noexcept {
  if (any_nan(cos_i.hi, eta_i, eta_t)) return std::numeric_limits<double>::quiet_NaN();
  const Meeting m = meeting_of(cos_i, eta_i, eta_t);
  if (one_medium(m)) return 0;
  const DoubleDouble g2 = g_squared(m);
  if (!(g2.hi > 0) || !(m.c.hi > 0)) return 1;  // total internal reflection; grazing
  const DoubleDouble g = square_root(g2);
  // (g - c)(g + c) is eta^2 - 1, so this is g - c without a difference.
  const DoubleDouble difference = (m.eta - 1) * (m.eta + 1) / (g + m.c);
  const DoubleDouble across = square(difference / (g + m.c));
  const DoubleDouble along = square((m.c * (g + m.c) - 1) / (m.c * difference + 1));
  return across * (1 + along) / 2;
}

double fresnel_by_indices(double cos_i, double eta_i, double eta_t) noexcept {
  return fresnel_dielectric(DoubleDouble(cos_i), eta_i, eta_t).hi;
}

double fresnel_by_angles(double cos_i, double eta_i, double eta_t) noexcept {
  if (any_nan(cos_i, eta_i, eta_t)) return std::numeric_limits<double>::quiet_NaN();
  const Meeting m = meeting_of(cos_i, eta_i, eta_t);
  if (one_medium(m)) return 0;
  const DoubleDouble sin2_i = 1 - square(m.c);
  const DoubleDouble cos2_t = 1 - sin2_i / square(m.eta);
  if (!(cos2_t.hi > 0) || !(m.c.hi > 0)) return 1;
  if (!(sin2_i.hi > 0)) return square((m.eta - 1) / (m.eta + 1)).hi;  // 0/0, the limit
  const DoubleDouble sin_i = square_root(sin2_i);
  const DoubleDouble sin_t = sin_i / m.eta;
  const DoubleDouble cos_t = square_root(cos2_t);
  const DoubleDouble sine_ratio = (sin_i * cos_t - m.c * sin_t) / (sin_i * cos_t + m.c * sin_t);
  const DoubleDouble cosine_ratio = (m.c * cos_t - sin_i * sin_t) / (m.c * cos_t + sin_i * sin_t);
  // tan(i - t)/tan(i + t) is the ratio of the sines times the inverse one of the cosines.
  return (square(sine_ratio) * (1 + square(cosine_ratio)) / 2).hi;
}

DoubleDouble fresnel_conductor(DoubleDouble cos_i, double eta, double k) noexcept {
  const DoubleDouble c = cos_i.hi < 0 ? 0 : (cos_i - 1).hi > 0 ? 1 : cos_i;
  eta = std::min(std::fabs(eta), kLargestRatio);
  k = std::min(std::fabs(k), kLargestRatio);
  const DoubleDouble c2 = square(c);
  const DoubleDouble s2 = 1 - c2;
  const DoubleDouble eta2 = square(eta);
  const DoubleDouble k2 = square(k);
  // a^2 + b^2 = |eta^2 - k^2 - s^2 + 2 i eta k|, a = Re sqrt of it.
  const DoubleDouble real = eta2 - k2 - s2;
  const DoubleDouble modulus = square_root(square(real) + 4 * eta2 * k2);
  // (modulus + real) / 2 without a difference where real is below 0
  const DoubleDouble a2 = real.hi >= 0     ? (modulus + real) / 2
                          : modulus.hi > 0 ? 2 * eta2 * k2 / (modulus - real)
                                           : DoubleDouble(0);
  const DoubleDouble twice = 2 * square_root(a2) * c;
  const DoubleDouble across_over = modulus + c2 + twice;
  if (!(across_over.hi > 0)) return 1;
  const DoubleDouble across = (modulus + c2 - twice) / across_over;
  const DoubleDouble plane = c2 * modulus + square(s2);
  const DoubleDouble along_over = plane + twice * s2;
  if (!(along_over.hi > 0)) return across;
  return across * (1 + (plane - twice * s2) / along_over) / 2;
}

DoubleDouble fresnel(const Reflector& reflector, DoubleDouble cos_i) noexcept {
  if (const auto* conductor = std::get_if<Conductor>(&reflector)) {
    return fresnel_conductor(cos_i, conductor->eta, conductor->k);
  }
  const auto* dielectric = std::get_if<Dielectric>(&reflector);
  return fresnel_dielectric(cos_i, dielectric->eta_i, dielectric->eta_t);
}

DoubleDouble f0_from_eta(double eta) noexcept {
  if (std::fabs(eta) > kLargestRatio) return 1;
  return square((DoubleDouble(eta) - 1) / (DoubleDouble(eta) + 1));
}

DoubleDouble eta_from_f0(DoubleDouble f0) noexcept {
  const DoubleDouble root = square_root(f0);
  const DoubleDouble rest = 1 - root;
  if (!(rest.hi > 0)) return std::numeric_limits<double>::infinity();
  return (1 + root) / rest;
}

}  // namespace detail

double fresnel_dielectric(double cos_i, double eta_i, double eta_t) noexcept {
  return detail::fresnel_by_indices(cos_i, eta_i, eta_t);
}

double fresnel_conductor(double cos_i, double eta, double k) noexcept {
  return detail::fresnel_conductor(detail::DoubleDouble(cos_i), eta, k).hi;
}

double f0_from_eta(double eta) noexcept { return detail::f0_from_eta(eta).hi; }

double eta_from_f0(double f0) noexcept { return detail::eta_from_f0(f0).hi; }

double fresnel(const Reflector& reflector, double cos_i) noexcept {
  return detail::fresnel(reflector, detail::DoubleDouble(cos_i)).hi;
}

}  // namespace tristim
