#pragma once

#include <Eigen/Core>
#include <span>

#include "tristim/color/rgb.h"
#include "tristim/light/samples.h"

namespace tristim {

// The quantities of light [Shoaff 3.8]: flux in W; solid angle in sr; radiant intensity in W/sr;
// irradiance in W/m^2; radiance in W/(sr m^2); reflectivity, radiance by irradiance, in 1/sr.

/// The solid angle of a cone about its axis, 2 pi (1 - cos); `half_angle_deg` 0..180. 90, the
/// hemisphere, has 2 pi sr.
double cone_solid_angle_sr(double half_angle_deg) noexcept;

/// W/sr of a flux that leaves evenly into a solid angle.
double radiant_intensity(double flux_w, double solid_angle_sr) noexcept;

/// The area that is seen from a direction theta off the normal: A cos theta; 0 from behind.
double foreshortened_area(double area_m2, const Eigen::Vector3d& normal,
                          const Eigen::Vector3d& direction) noexcept;

/// W/(sr m^2) of a surface seen from `direction`; infinite at grazing angles.
double radiance(double intensity_w_sr, double area_m2, const Eigen::Vector3d& normal,
                const Eigen::Vector3d& direction) noexcept;

/// E_i = I_i (N.L) dw, what a source of radiance I_i that covers dw steradians brings to a surface
/// [Shoaff 3.8]; 0 from behind.
double irradiance(double incident_radiance, const Eigen::Vector3d& normal,
                  const Eigen::Vector3d& to_light, double domega_sr) noexcept;

/// rho_d of a surface that reflects `albedo` (0..1) of the light evenly [Lambert1760]: albedo/pi.
double lambert_reflectivity(double albedo) noexcept;

/// How a surface splits light into diffuse and specular.
struct ReflectivitySplit {
  double kd = 1, ks = 0;  // 0..1, together 1
};

/// Throws std::invalid_argument where the parts are not 0..1 or do not add up to 1 within 1e-6.
void check_split(const ReflectivitySplit& split);

/// rho = kd rho_d + ks rho_s [Shoaff 3.8].
double reflectivity(const ReflectivitySplit& split, double rho_d, double rho_s) noexcept;

/// One of n sources.
template <typename Color>
struct RadiantSourceOf {
  Eigen::Vector3d to_light{0, 0, 1};  // L
  Color radiance = {};                // I_i
  double domega_sr = 0;               // dw, the solid angle that it covers
  Color rho_s = {};                   // what the surface reflects specularly of it to the eye
};
using RadiantSource = RadiantSourceOf<double>;

/// I_r = rho_d I_a + sum E_i (kd rho_d + ks rho_s) [Shoaff 3.8]. The ambient term has no ka, as
/// printed: `ambient` is what is left of it where something is in the way.
double reflected_radiance(const ReflectivitySplit& split, double rho_d, double ambient,
                          const Eigen::Vector3d& normal,
                          std::span<const RadiantSource> sources) noexcept;
Rgb reflected_radiance(const ReflectivitySplit& split, const Rgb& rho_d, const Rgb& ambient,
                       const Eigen::Vector3d& normal,
                       std::span<const RadiantSourceOf<Rgb>> sources) noexcept;
SpectralColor reflected_radiance(const ReflectivitySplit& split, const SpectralColor& rho_d,
                                 const SpectralColor& ambient, const Eigen::Vector3d& normal,
                                 std::span<const RadiantSourceOf<SpectralColor>> sources) noexcept;

}  // namespace tristim
