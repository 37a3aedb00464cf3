#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>
#include <variant>

#include "tristim/color/rgb.h"

namespace tristim {

namespace detail {
double unattenuated(double d, double c1, double c2, double c3) noexcept;
double inverse_square(double d, double c1, double c2, double c3) noexcept;
double clamped_quadratic(double d, double c1, double c2, double c3) noexcept;
double inverse_linear(double d, double c1, double c2, double c3) noexcept;
double inverse_quadratic(double d, double c1, double c2, double c3) noexcept;
double beer_lambert(double d, double c1, double c2, double c3) noexcept;
}  // namespace detail

/// A way in which light fades with the distance d from its source.
struct AttenuationKind {
  std::string_view name;
  std::string_view formula;
  std::string_view source;
  double (*factor)(double d, double c1, double c2,
                   double c3) noexcept;  // inf where it divides by 0
};

/// Every kind. [Shoaff 3.2] prints clamped_quadratic with max for min, which never fades.
inline constexpr std::array kAttenuations{
    AttenuationKind{"none", "1", "[Shoaff 3.2]", detail::unattenuated},
    AttenuationKind{"inverse_square", "1/d^2", "[Shoaff 3.2]", detail::inverse_square},
    AttenuationKind{"clamped_quadratic", "min(1/(c1 + c2 d + c3 d^2), 1)", "[Shoaff 3.2]",
                    detail::clamped_quadratic},
    AttenuationKind{"linear", "1/(c1 + c2 d)", "[Shoaff 3.2]", detail::inverse_linear},
    AttenuationKind{"opengl", "1/(c1 + c2 d + c3 d^2)", "[UBC]", detail::inverse_quadratic},
    AttenuationKind{"beer_lambert", "exp(-c1 d)", "[Lambert1760]", detail::beer_lambert},
};

/// A kind with its coefficients; those that its formula does not name do not count.
struct Attenuation {
  AttenuationKind kind = kAttenuations[0];
  double c1 = 1, c2 = 0, c3 = 0;
};

/// Light from one direction, everywhere the same.
struct DirectionalLight {
  Eigen::Vector3d to_light{0, 0, 1};  // any length
  Rgb intensity = {};                 // Ip
};

/// Light from one place.
struct PointLight {
  Eigen::Vector3d position{0, 0, 0};
  Rgb intensity = {};  // Ip
  Attenuation attenuation = {};
};

using Light = std::variant<DirectionalLight, PointLight>;

/// What arrives at a point from one light.
struct Incident {
  Eigen::Vector3d to_light{0, 0, 0};  // L, unit; 0 at the light's own place
  Rgb intensity = {};                 // f_att Ip; infinite where f_att is
};

/// The light that `light` sends to `point`, nothing being in the way.
Incident incident(const Light& light, const Eigen::Vector3d& point) noexcept;

}  // namespace tristim
