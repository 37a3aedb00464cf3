#pragma once

#include <Eigen/Core>
#include <cmath>

namespace tristim {

// Directions are unit vectors that point away from the point of the surface: L to the light, V (E
// in [FisherWoo]) to the eye, N the normal, R the reflected light, M the reflected eye, H half way
// between L and V. All axes are right-handed, and lighting is done before the perspective divide,
// which keeps no angles [Shoaff 3.3]. Vectors are used as given; nothing here throws, and no finite
// input gives NaN. What is one rounding away from its exact value says so.

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

/// V, from `point` to `eye` [Owen]; 0 where they are one.
inline Eigen::Vector3d view_vector(const Eigen::Vector3d& point,
                                   const Eigen::Vector3d& eye) noexcept {
  const Eigen::Vector3d way = eye - point;
  // Finite places may be infinitely far apart.
  return normalize(way.allFinite() ? way : Eigen::Vector3d(0.5 * eye - 0.5 * point));
}

/// The mirror image of `to_light` about the normal, R = 2 (N.L) N - L [Shoaff 3.6]: P = N (N.L) is
/// the foot of L on the normal, S = P - L goes from L to it, R = P + S. Of `to_eye` it makes the
/// reflected eye M, which serves every light: R.V = L.M [FisherWoo]. Rounded once.
Eigen::Vector3d reflect(const Eigen::Vector3d& to_light, const Eigen::Vector3d& normal) noexcept;

/// The same for light along +z, R = (2 nz nx, 2 nz ny, 2 nz^2 - 1) [Phong75, Owen], exact for a
/// unit normal.
Eigen::Vector3d reflect_z(const Eigen::Vector3d& normal) noexcept;

/// The same for any unit vector L by Phong's way: turn L to +z, reflect_z, turn back.
Eigen::Vector3d reflect_by_turning(const Eigen::Vector3d& to_light,
                                   const Eigen::Vector3d& normal) noexcept;

/// R.V without R: 2 (N.L)(N.V) - L.V [Shoaff 3.6]. Rounded once.
double r_dot_v(const Eigen::Vector3d& normal, const Eigen::Vector3d& to_light,
               const Eigen::Vector3d& to_eye) noexcept;

/// Half way between light and eye, H = (L + V) / |L + V| [Shoaff 3.6]; 0 where L = -V. Rounded
/// once.
Eigen::Vector3d half_vector(const Eigen::Vector3d& to_light,
                            const Eigen::Vector3d& to_eye) noexcept;

/// N.H without H: (N.L + N.V) / |L + V|, 0 where L = -V. |L + V| is sqrt(2 + 2 L.V) [FisherWoo],
/// whose digits cancel near L = -V. Rounded once.
double n_dot_h(const Eigen::Vector3d& normal, const Eigen::Vector3d& to_light,
               const Eigen::Vector3d& to_eye) noexcept;

/// The cosine of an angle in degrees, rounded once: cos 60 is 1/2, and cos 89.9999 keeps its
/// digits.
double cosine_deg(double angle_deg) noexcept;

/// The angle between two directions of any length in degrees, [0, 180]; 0 where either is 0.
double angle_between_deg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) noexcept;

/// The angles that [FisherWoo] names; their theta and phi place N in the paper's frame.
struct HighlightAngles {
  double alpha_deg = 0;  // [L,N]
  double beta_deg = 0;   // [L,H], half of [L,E]
  double rho_deg = 0;    // [R,E]
  double nu_deg = 0;     // [N,H]
};

HighlightAngles highlight_angles(const Eigen::Vector3d& normal, const Eigen::Vector3d& to_light,
                                 const Eigen::Vector3d& to_eye) noexcept;

}  // namespace tristim
