#include "tristim/light/microfacet.h"

#include <algorithm>
#include <cmath>

#include "lib/core/trigonometry.h"
#include "lib/light/angle.h"
#include "lib/light/fresnel_precise.h"
#include "lib/light/precise.h"
#include "lib/light/quadrature.h"
#include "tristim/light/phong.h"
#include "tristim/light/vector.h"

namespace tristim {
namespace {

using detail::DoubleDouble;
using detail::precise;
using Eigen::Vector3d;

// The cosines that all terms are made of.
struct Cosines {
  DoubleDouble n_l, n_v, n_h, v_h;
  bool reflects = false;
};

Cosines cosines_of(const Vector3d& normal, const Vector3d& to_light,
                   const Vector3d& to_eye) noexcept {
  const detail::PreciseVector n = precise(normal);
  const detail::PreciseVector l = precise(to_light);
  const detail::PreciseVector v = precise(to_eye);
  const detail::PreciseVector between = l + v;
  // V.H = L.H = |L + V|/2 of unit vectors, whichever of the two is named the eye.
  Cosines c{dot(n, l), dot(n, v), dot(n, normalize(between)), length(between) / 2};
  c.reflects = c.n_l.hi > 0 && c.n_v.hi > 0 && c.n_h.hi > 0 && c.v_h.hi > 0;
  return c;
}

DoubleDouble smaller(DoubleDouble a, DoubleDouble b) noexcept { return (a - b).hi < 0 ? a : b; }

// G/(N.V N.L), without a product that could vanish: where G is G_b or G_s one cosine cancels.
DoubleDouble attenuation_by_cosines(const Cosines& c) noexcept {
  const DoubleDouble least = smaller(c.n_l, c.n_v);
  if ((2 * c.n_h * least - c.v_h).hi >= 0) return DoubleDouble(1) / (c.n_l * c.n_v);
  const DoubleDouble most = least.hi == c.n_l.hi && least.lo == c.n_l.lo ? c.n_v : c.n_l;
  return 2 * c.n_h / (c.v_h * most);
}

// D G/(divisor N.V N.L)
DoubleDouble lobe(const Microfacets& surface, const Cosines& c) noexcept {
  const DoubleDouble density = surface.distribution.density(c.n_h, surface.m);
  if (density.hi == 0) return 0;
  const MicrofacetNormalization& normalization = surface.normalization;
  const double factor = normalization.normalised ? surface.distribution.normaliser(surface.m) : 1;
  return density * factor * attenuation_by_cosines(c) / normalization.divisor;
}

}  // namespace

GeometricAttenuation geometric_attenuation(const Vector3d& normal, const Vector3d& to_light,
                                           const Vector3d& to_eye) noexcept {
  const Cosines c = cosines_of(normal, to_light, to_eye);
  if (!c.reflects) return {};
  const double blocked = (2 * c.n_h * c.n_v / c.v_h).hi;
  const double shadowed = (2 * c.n_h * c.n_l / c.v_h).hi;
  return {blocked, shadowed, std::min({1.0, blocked, shadowed})};
}

double torrance_sparrow(const Microfacets& surface, const Reflector& reflector,
                        const Vector3d& normal, const Vector3d& to_light,
                        const Vector3d& to_eye) noexcept {
  const Cosines c = cosines_of(normal, to_light, to_eye);
  if (!c.reflects) return 0;
  return (detail::fresnel(reflector, c.v_h) * lobe(surface, c)).hi;
}

Rgb torrance_sparrow(const Microfacets& surface, std::span<const Reflector, 3> reflectors,
                     const Vector3d& normal, const Vector3d& to_light,
                     const Vector3d& to_eye) noexcept {
  const Cosines c = cosines_of(normal, to_light, to_eye);
  if (!c.reflects) return {};
  const DoubleDouble rough = lobe(surface, c);
  const auto sample = [&](std::size_t i) {
    return (detail::fresnel(reflectors[i], c.v_h) * rough).hi;
  };
  return {sample(0), sample(1), sample(2)};
}

SpectralColor torrance_sparrow(const Microfacets& surface,
                               std::span<const Reflector, kSpectralSamples> reflectors,
                               const Vector3d& normal, const Vector3d& to_light,
                               const Vector3d& to_eye) noexcept {
  const Cosines c = cosines_of(normal, to_light, to_eye);
  if (!c.reflects) return {};
  const DoubleDouble rough = lobe(surface, c);
  SpectralColor color;
  for (std::size_t i = 0; i < kSpectralSamples; ++i) {
    color.at[i] = (detail::fresnel(reflectors[i], c.v_h) * rough).hi;
  }
  return color;
}

double directional_albedo(const Microfacets& surface, const Reflector& reflector, double theta_deg,
                          int steps) noexcept {
  const detail::SineCosine theta = detail::sine_cosine_deg(theta_deg);
  const Vector3d normal(0, 0, 1);
  const Vector3d to_light(theta.sine, 0, theta.cosine);
  const double widest_deg = std::min(90.0, 8 * surface.m * detail::kDegreesPerRadian.hi);
  double albedo = 0;
  for (const detail::Node& node : detail::gauss_legendre()) {
    const detail::SineCosine beta = detail::sine_cosine_deg(node.at * widest_deg);
    double ring = 0;
    for (int i = 0; i < steps; ++i) {
      const detail::SineCosine phi = detail::sine_cosine_deg(180 * (i + 0.5) / steps);
      const Vector3d half(beta.sine * phi.cosine, beta.sine * phi.sine, beta.cosine);
      const Vector3d to_eye = reflect(to_light, half);
      const double v_dot_h = dot(to_eye, half);
      if (!(v_dot_h > 0)) continue;
      // The solid angle about V is 4 (V.H) times that about H.
      ring += torrance_sparrow(surface, reflector, normal, to_light, to_eye) *
              lambert(normal, to_eye) * 4 * v_dot_h;
    }
    albedo += node.weight * ring / steps * beta.sine;
  }
  return albedo * 2 * detail::kPi.hi * widest_deg * detail::kRadiansPerDegree.hi;
}

}  // namespace tristim
