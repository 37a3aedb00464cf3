#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <string_view>

#include "tristim/color/rgb.h"
#include "tristim/light/fresnel.h"
#include "tristim/light/samples.h"

namespace tristim {

// A rough surface as small mirrors of which those along H send light to the eye
// [Shoaff 3.8.1, Cook82]. Where N.L or N.V is not above 0, nothing is reflected.

namespace detail {
struct DoubleDouble;
DoubleDouble gauss_density(DoubleDouble cos_beta, double m) noexcept;
DoubleDouble beckmann_density(DoubleDouble cos_beta, double m) noexcept;
DoubleDouble blinn_density(DoubleDouble cos_beta, double m) noexcept;
double gauss_normaliser(double m) noexcept;
double beckmann_normaliser(double m) noexcept;
double blinn_normaliser(double m) noexcept;
}  // namespace detail

/// How the directions of the microfacets are spread about the normal. m is the root mean square
/// slope: small for a nearly smooth surface that reflects in one direction, large for one that
/// spreads the light; taken into [1e-70, 1e70].
struct MicrofacetDistribution {
  std::string_view name;
  std::string_view formula;
  std::string_view source;
  detail::DoubleDouble (*density)(detail::DoubleDouble cos_beta, double m) noexcept;
  double (*normaliser)(double m) noexcept;  // times the density: its projected area is 1
};

inline constexpr MicrofacetDistribution kGauss{"gauss", "exp(-(beta/m)^2)", "[Torrance67]",
                                               detail::gauss_density, detail::gauss_normaliser};
inline constexpr MicrofacetDistribution kBeckmann{
    "beckmann", "exp(-(tan beta/m)^2)/(m^2 cos^4 beta)", "[Beckmann63]", detail::beckmann_density,
    detail::beckmann_normaliser};
inline constexpr MicrofacetDistribution kBlinn{
    "blinn", "(n + 2)/(2 pi) cos^n beta, n = max(2/m^2 - 2, 0)", "[Blinn77, Walter07]",
    detail::blinn_density, detail::blinn_normaliser};

/// Every distribution. The command line, the docs and the tests read this list.
inline constexpr std::array kMicrofacetDistributions{kGauss, kBeckmann, kBlinn};

/// D as the formula stands, at cos_beta = 0 its limit; 0 below 0, and above 1 it counts as 1.
double microfacet_density(const MicrofacetDistribution& distribution, double cos_beta,
                          double m) noexcept;

/// The factor that makes the integral of D cos beta over the hemisphere 1: c1 of Gauss (32.04 at
/// m = .1, 3.754 at .3, .581 at 1), 1/pi of Beckmann. Maximum error 1e-14.
double microfacet_normaliser(const MicrofacetDistribution& distribution, double m) noexcept;

/// What stands beside F D G.
struct MicrofacetNormalization {
  std::string_view name;
  std::string_view formula;
  std::string_view source;
  bool normalised;  // D times its normaliser
  double divisor;   // of F D G / (N.V N.L)
};

/// As the documents print it: reflects up to four times the light that arrives.
inline constexpr MicrofacetNormalization kSeedNormalization{
    "seed", "F D G/(pi N.V N.L)", "[Shoaff 3.8.1, Cook82]", false, 3.14159265358979323846};
/// Reflects never more than arrives.
inline constexpr MicrofacetNormalization kEnergyNormalization{
    "energy", "F (c D) G/(4 N.V N.L), c of the integral of c D cos beta = 1", "[Walter07]", true,
    4};
inline constexpr std::array kMicrofacetNormalizations{kSeedNormalization, kEnergyNormalization};

/// A rough surface without its Fresnel term, which alone depends on the wavelength.
struct Microfacets {
  MicrofacetDistribution distribution = kBeckmann;
  MicrofacetNormalization normalization = kEnergyNormalization;
  double m = 0.3;
};

/// How microfacets keep light from each other [Blinn77]; 1 - m/l, the part of a facet's area that
/// is seen and lit.
struct GeometricAttenuation {
  double blocked = 0;   // G_b = 2 (N.H)(N.V)/(V.H): light that other facets keep from the eye
  double shadowed = 0;  // G_s = 2 (N.H)(N.L)/(V.H): light that does not arrive
  double factor = 0;    // G = min(1, G_b, G_s)
};

/// All 0 where nothing is reflected. Rounded once.
GeometricAttenuation geometric_attenuation(const Eigen::Vector3d& normal,
                                           const Eigen::Vector3d& to_light,
                                           const Eigen::Vector3d& to_eye) noexcept;

/// rho_s in 1/sr: reflected radiance by irradiance [Shoaff 3.8.1], with F at V.H. Light and eye may
/// change places. Digits do not cancel near L = -V nor at grazing angles.
double torrance_sparrow(const Microfacets& surface, const Reflector& reflector,
                        const Eigen::Vector3d& normal, const Eigen::Vector3d& to_light,
                        const Eigen::Vector3d& to_eye) noexcept;

/// The same in colour, a reflector for each sample: at grazing angles the highlight takes on the
/// colour of the light.
Rgb torrance_sparrow(const Microfacets& surface, std::span<const Reflector, 3> reflectors,
                     const Eigen::Vector3d& normal, const Eigen::Vector3d& to_light,
                     const Eigen::Vector3d& to_eye) noexcept;
SpectralColor torrance_sparrow(const Microfacets& surface,
                               std::span<const Reflector, kSpectralSamples> reflectors,
                               const Eigen::Vector3d& normal, const Eigen::Vector3d& to_light,
                               const Eigen::Vector3d& to_eye) noexcept;

/// The part of the light from a direction `theta_deg` off the normal, [0, 90), that leaves in any
/// direction: the integral of rho_s N.V over the hemisphere, by 40 x `steps` facets' directions, 1
/// or more.
double directional_albedo(const Microfacets& surface, const Reflector& reflector, double theta_deg,
                          int steps = 64) noexcept;

}  // namespace tristim
