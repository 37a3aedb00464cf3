#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>
#include <variant>

#include "tristim/color/rgb.h"
#include "tristim/light/samples.h"

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
template <typename Color>
struct DirectionalLightOf {
  Eigen::Vector3d to_light{0, 0, 1};  // any length; what is unit stays as it is
  Color intensity = {};               // Ip
};

/// Light from one place.
template <typename Color>
struct PointLightOf {
  Eigen::Vector3d position{0, 0, 0};
  Color intensity = {};  // Ip
  Attenuation attenuation = {};
};

/// Light from one place into a cone.
template <typename Color>
struct SpotLightOf {
  Eigen::Vector3d position{0, 0, 0};
  Eigen::Vector3d direction{0, 0, -1};  // of the axis, away from the light, any length
  double cutoff_deg = 180;              // 0..180, from the axis; 180 makes a point light
  double exponent = 0;                  // 0 or more, the larger the narrower
  Color intensity = {};                 // Ip, along the axis
  Attenuation attenuation = {};
};

/// The colour of a light is what its samples are: RGB, or a spectrum of 81 wavelengths.
using DirectionalLight = DirectionalLightOf<Rgb>;
using PointLight = PointLightOf<Rgb>;
using SpotLight = SpotLightOf<Rgb>;

template <typename Color>
using LightOf = std::variant<DirectionalLightOf<Color>, PointLightOf<Color>, SpotLightOf<Color>>;
using Light = LightOf<Rgb>;
using SpectralLight = LightOf<SpectralColor>;

/// What arrives at a point from one light.
template <typename Color>
struct IncidentOf {
  Eigen::Vector3d to_light{0, 0, 0};  // L, unit; 0 at the light's own place
  Color intensity = {};               // f_att Ip; infinite where f_att is
};
using Incident = IncidentOf<Rgb>;
using SpectralIncident = IncidentOf<SpectralColor>;

/// The light that `light` sends to `point`, nothing being in the way.
Incident incident(const Light& light, const Eigen::Vector3d& point) noexcept;
SpectralIncident incident(const SpectralLight& light, const Eigen::Vector3d& point) noexcept;

/// The part of a spot's light that leaves in a direction, by OpenGL's rule [OpenGL 2.13.1]: with c
/// the cosine between `from_light` and `axis`, both of any length, c^exponent where c is above 0
/// and not below cos(cutoff), else 0. A cutoff of 180 is a point light, 1. A vector 0 has c = 0.
double spot_factor(const Eigen::Vector3d& from_light, const Eigen::Vector3d& axis,
                   double cutoff_deg, double exponent) noexcept;

/// Where the camera stands, for lights that move with it.
struct CameraPose {
  Eigen::Matrix3d world_from_camera = Eigen::Matrix3d::Identity();  // a rotation
  Eigen::Vector3d eye{0, 0, 0};                                     // in the world
};

/// A light that is fixed to the camera, in the world's coordinates [UBC]; lights that are fixed to
/// the world are used as they are.
Light placed_with_camera(const Light& in_camera, const CameraPose& camera) noexcept;

}  // namespace tristim
