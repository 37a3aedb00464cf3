#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>

namespace tristim {

/// Light that passes through a surface.
struct Refraction {
  Eigen::Vector3d transmitted{0, 0, 0};  // T, unit, away from the light; 0 where nothing passes
  double cos_t = 0;                      // of the angle of T to the normal's far side
  bool total_internal = false;           // nothing passes: sin theta_t is 1 or more
};

namespace detail {
Refraction refract_in_plane(const Eigen::Vector3d& to_light, const Eigen::Vector3d& normal,
                            double eta_i, double eta_t) noexcept;
Refraction refract_by_sines(const Eigen::Vector3d& to_light, const Eigen::Vector3d& normal,
                            double eta_i, double eta_t) noexcept;
Refraction refract_by_dots(const Eigen::Vector3d& to_light, const Eigen::Vector3d& normal,
                           double eta_i, double eta_t) noexcept;
}  // namespace detail

/// A way to write the refraction vector down. `to_light` (L) points back along the ray; where N.L
/// is below 0 the ray comes from inside, so that N turns round and the indices change places.
/// `eta_i` is the index of refraction on the side of the normal, `eta_t` behind it, both above 0.
/// Digits do not cancel near the critical angle nor at grazing incidence; rounded once.
struct RefractionForm {
  std::string_view name;
  std::string_view formula;
  std::string_view source;
  Refraction (*refract)(const Eigen::Vector3d& to_light, const Eigen::Vector3d& normal,
                        double eta_i, double eta_t) noexcept;
};

/// Every form; they agree but for the last digit.
inline constexpr std::array kRefractionForms{
    RefractionForm{"plane", "T = sin_t M - cos_t N, M = (N cos_i - L)/sin_i", "[Shoaff 4.4]",
                   detail::refract_in_plane},
    RefractionForm{"sines", "T = (eta cos_i - cos_t) N - eta L, cos_t = sqrt(1 - sin_t^2)",
                   "[Shoaff 4.4]", detail::refract_by_sines},
    RefractionForm{"dots", "T = (eta N.L - sqrt(1 - eta^2 (1 - (N.L)^2))) N - eta L",
                   "[Shoaff 4.4]", detail::refract_by_dots},
};

/// The refraction vector, eta = eta_i/eta_t, in its third form [Shoaff 4.4]. The notes leave out
/// that a radicand of 0 or less means total internal reflection.
Refraction refract(const Eigen::Vector3d& to_light, const Eigen::Vector3d& normal, double eta_i,
                   double eta_t) noexcept;

/// sin theta_t of eta_i sin theta_i = eta_t sin theta_t, Snell's law [Shoaff 4.4]; 1 or more is
/// total internal reflection.
double snell_sine(double sin_i, double eta_i, double eta_t) noexcept;

}  // namespace tristim
