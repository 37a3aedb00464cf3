#pragma once

#include <array>
#include <string_view>
#include <variant>

namespace tristim {

// What part of unpolarised light a smooth surface reflects, 0..1. `cos_i` is that of the angle
// between the light and the (micro)facet's normal; digits do not cancel near the critical angle, at
// grazing incidence or for nearly equal indices; rounded once. [Shoaff 3.8] writes eta for
// eta_i/eta_t in the refraction vector and for eta_t/eta_i here.

namespace detail {
double fresnel_by_angles(double cos_i, double eta_i, double eta_t) noexcept;
double fresnel_by_indices(double cos_i, double eta_i, double eta_t) noexcept;
}  // namespace detail

/// A form of Fresnel's equation for dielectrics. `cos_i` above 1 counts as 1; below 0 the light
/// comes from behind, so that the indices change places. Indices are above 0. 1 at total internal
/// reflection and at cos_i = 0; elsewhere 0 where the indices are equal.
struct FresnelForm {
  std::string_view name;
  std::string_view formula;
  std::string_view source;
  double (*reflectance)(double cos_i, double eta_i, double eta_t) noexcept;
};

/// Both forms; they agree but for the last digit. The notes print a product of the tangents, and -1
/// for +1 in the last denominator.
inline constexpr std::array kFresnelForms{
    FresnelForm{"angles",
                "1/2 (sin^2(i - t)/sin^2(i + t) + tan^2(i - t)/tan^2(i + t)), sin i/sin t = "
                "eta_t/eta_i",
                "[Shoaff 3.8.1]", detail::fresnel_by_angles},
    FresnelForm{"indices",
                "1/2 ((g - c)/(g + c))^2 (1 + ((c(g + c) - 1)/(c(g - c) + 1))^2), g^2 = "
                "(eta_t/eta_i)^2 + c^2 - 1",
                "[Cook82]", detail::fresnel_by_indices},
};

/// Of a dielectric, as FresnelForm says.
double fresnel_dielectric(double cos_i, double eta_i, double eta_t) noexcept;

/// Of a conductor with the index eta + i k, 0 or more, seen from vacuum [Born99 14.2]. `cos_i`
/// outside [0, 1] counts as the nearer end.
double fresnel_conductor(double cos_i, double eta, double k) noexcept;

/// ((eta - 1)/(eta + 1))^2, the reflectance at normal incidence [Shoaff 3.8.1].
double f0_from_eta(double eta) noexcept;

/// (1 + sqrt F0)/(1 - sqrt F0), the index that is at least 1 [Shoaff 3.8.1]; 1/eta has the same F0.
/// `f0` in [0, 1]; infinite at 1.
double eta_from_f0(double f0) noexcept;

/// What light meets.
struct Dielectric {
  double eta_i = 1, eta_t = 1.5;  // before and behind the surface
};
struct Conductor {
  double eta = 1, k = 0;  // seen from vacuum
};

/// A surface whose reflectance a spectrum or an Rgb is made of: one for each sample.
using Reflector = std::variant<Dielectric, Conductor>;

double fresnel(const Reflector& reflector, double cos_i) noexcept;

}  // namespace tristim
