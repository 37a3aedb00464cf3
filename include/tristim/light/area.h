#pragma once

#include <Eigen/Core>
#include <span>

#include "tristim/color/rgb.h"
#include "tristim/light/phong.h"
#include "tristim/light/samples.h"

namespace tristim {

/// A flat polygon that shines evenly on the side where its vertices run counter-clockwise.
template <typename Color>
struct AreaLightOf {
  std::span<const Eigen::Vector3d> polygon;
  Color radiance = {};  // Le, the same in every direction
};
using AreaLight = AreaLightOf<Rgb>;
using SpectralAreaLight = AreaLightOf<SpectralColor>;

/// The part of the light of a whole hemisphere that a polygon sends to `point`: its irradiance is
/// pi Le times that. 0..1, in closed form [Lambert1760]: 1/(2 pi) of the sum over the edges of the
/// angle that an edge is seen under times N on the normal of its plane through the point. What lies
/// below the horizon of the unit `normal` is cut off; 0 from behind the polygon, in its plane, and
/// for fewer than three vertices. Nothing casts a shadow. Digits do not cancel for small and
/// distant polygons; rounded once.
double polygon_form_factor(std::span<const Eigen::Vector3d> polygon, const Eigen::Vector3d& point,
                           const Eigen::Vector3d& normal);

/// pi Le times the form factor, in W/m^2 where Le is in W/(sr m^2).
double polygon_irradiance(std::span<const Eigen::Vector3d> polygon, const Eigen::Vector3d& point,
                          const Eigen::Vector3d& normal, double radiance);

/// kd Od E/pi, what a matte surface of albedo kd Od makes of it.
Rgb area_reflection(const Material& material, const AreaLight& light, const Eigen::Vector3d& point,
                    const Eigen::Vector3d& normal);
SpectralColor area_reflection(const SpectralMaterial& material, const SpectralAreaLight& light,
                              const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

}  // namespace tristim
