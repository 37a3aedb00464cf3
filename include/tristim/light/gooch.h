#pragma once

#include <Eigen/Core>

#include "tristim/color/rgb.h"

namespace tristim {

// Technical illustration: tones from cool to warm, and the lines of a drawing [UBC, Gooch98].

/// kw = (1 + N.L)/2, 0 facing away from the light, 1 facing it. Rounded once.
double gooch_warmth(const Eigen::Vector3d& normal, const Eigen::Vector3d& to_light) noexcept;

/// kw warm + (1 - kw) cool: warm faces the light.
Rgb gooch(const Eigen::Vector3d& normal, const Eigen::Vector3d& to_light, const Rgb& warm,
          const Rgb& cool) noexcept;

/// Whether the edge between two faces is part of the outline: (e.n0)(e.n1) <= 0, with e to the eye,
/// of any length.
bool is_silhouette(const Eigen::Vector3d& to_eye, const Eigen::Vector3d& normal0,
                   const Eigen::Vector3d& normal1) noexcept;

/// Whether it is a sharp edge: n0.n1 <= threshold, the cosine of the least angle of a crease.
bool is_crease(const Eigen::Vector3d& normal0, const Eigen::Vector3d& normal1,
               double threshold) noexcept;

}  // namespace tristim
