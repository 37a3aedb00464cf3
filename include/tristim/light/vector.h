#pragma once

#include <Eigen/Core>
#include <cmath>

namespace tristim {

// Directions are unit vectors that point away from the point of the surface: L to the light, V to
// the eye, N the normal. Vectors are used as given; nothing here throws, and no finite input gives
// NaN.

/// a.b, summed in the order x, y, z (Eigen's own order depends on the instruction set).
inline double dot(const Eigen::Vector3d& a, const Eigen::Vector3d& b) noexcept {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

/// The length of v, without overflow or underflow on the way.
inline double length(const Eigen::Vector3d& v) noexcept {
  const double squared = dot(v, v);
  if (squared > 1e-280 && squared < 1e280) return std::sqrt(squared);
  const double largest = std::fmax(std::fabs(v.x()), std::fmax(std::fabs(v.y()), std::fabs(v.z())));
  if (std::isnan(squared) || largest == 0 || std::isinf(largest)) return squared;
  const Eigen::Vector3d scaled = v / largest;
  return largest * std::sqrt(dot(scaled, scaled));
}

/// v / |v|; the zero vector stays zero.
inline Eigen::Vector3d normalize(const Eigen::Vector3d& v) noexcept {
  const double squared = dot(v, v);
  if (squared > 1e-280 && squared < 1e280) return v / std::sqrt(squared);
  const double largest = std::fmax(std::fabs(v.x()), std::fmax(std::fabs(v.y()), std::fabs(v.z())));
  if (largest == 0) return v;
  const Eigen::Vector3d scaled = v / largest;
  return scaled / std::sqrt(dot(scaled, scaled));
}

/// The mirror image of `to_light` about the normal, R = 2 (N.L) N - L [Shoaff 3.6].
inline Eigen::Vector3d reflect(const Eigen::Vector3d& to_light,
                               const Eigen::Vector3d& normal) noexcept {
  return 2 * dot(normal, to_light) * normal - to_light;
}

/// Half way between light and eye, H = (L + V) / |L + V| [Shoaff 3.6]; 0 where L = -V.
inline Eigen::Vector3d half_vector(const Eigen::Vector3d& to_light,
                                   const Eigen::Vector3d& to_eye) noexcept {
  return normalize(to_light + to_eye);
}

}  // namespace tristim
