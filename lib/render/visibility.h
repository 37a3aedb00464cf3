#pragma once

#include <Eigen/Core>

#include "tristim/render/spheres.h"

namespace tristim::detail {

/// The part of a disc of radius `light` that is hidden by one of radius `blocker` whose centre is
/// `apart` from its own, 0..1. A cubic stands for the circular segments; maximum error .04 where
/// the blocker is large.
double hidden_part(double light, double blocker, double apart) noexcept;

/// The part of a light's disc that `point` sees past all spheres but `self`; `to_light` is the unit
/// vector to its centre. Hidden parts of several spheres multiply.
double visible_part(const SphereScene& scene, const SoftLight& light,
                    const Eigen::Vector3d& to_light, const Eigen::Vector3d& point,
                    const Sphere* self) noexcept;

/// The part of the ambient light that all spheres but `self` leave to a surface: one that lies in
/// the surface's hemisphere takes N.D r^2/d^2 of it [Quilez06]. Parts multiply.
double unblocked_part(const SphereScene& scene, const Eigen::Vector3d& point,
                      const Eigen::Vector3d& normal, const Sphere* self) noexcept;

}  // namespace tristim::detail
