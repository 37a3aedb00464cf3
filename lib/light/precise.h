#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "lib/core/double_double.h"

namespace tristim::detail {

/// A vector of 106 bits a component. A cosine near 0 is a sum that cancels, and a high exponent
/// multiplies its error; so what is rounded is the result, not the cosine.
struct PreciseVector {
  DoubleDouble x, y, z;
};

/// `v` as it is. Beyond 1e74, where products of four would overflow, v is shortened to that: it is
/// no direction any more.
inline PreciseVector precise(const Eigen::Vector3d& v) noexcept {
  constexpr double kLongest = 1e74;
  const double largest = std::max({std::fabs(v.x()), std::fabs(v.y()), std::fabs(v.z())});
  if (!(largest > kLongest)) return {v.x(), v.y(), v.z()};
  const auto shortened = [&](double part) { return DoubleDouble(part / largest * kLongest); };
  return {shortened(v.x()), shortened(v.y()), shortened(v.z())};
}

inline Eigen::Vector3d rounded(const PreciseVector& v) noexcept { return {v.x.hi, v.y.hi, v.z.hi}; }

inline PreciseVector operator-(const PreciseVector& v) noexcept { return {-v.x, -v.y, -v.z}; }

inline PreciseVector operator+(const PreciseVector& a, const PreciseVector& b) noexcept {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline PreciseVector operator-(const PreciseVector& a, const PreciseVector& b) noexcept {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline PreciseVector operator*(DoubleDouble a, const PreciseVector& v) noexcept {
  return {a * v.x, a * v.y, a * v.z};
}

inline DoubleDouble dot(const PreciseVector& a, const PreciseVector& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline PreciseVector cross(const PreciseVector& a, const PreciseVector& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline DoubleDouble length(const PreciseVector& v) noexcept { return square_root(dot(v, v)); }

/// v / |v|; the zero vector stays zero.
inline PreciseVector normalize(const PreciseVector& v) noexcept {
  const double largest = std::max({std::fabs(v.x.hi), std::fabs(v.y.hi), std::fabs(v.z.hi)});
  if (!(largest > 0) || std::isinf(largest)) return v;
  int exponent = 0;
  (void)std::frexp(largest, &exponent);
  const auto scaled = [&](DoubleDouble part) {  // exactly; the squares of tiny parts would vanish
    return DoubleDouble(std::ldexp(part.hi, -exponent), std::ldexp(part.lo, -exponent));
  };
  const PreciseVector middle{scaled(v.x), scaled(v.y), scaled(v.z)};
  return DoubleDouble(1) / length(middle) * middle;
}

/// R = 2 (N.L) N - L.
inline PreciseVector reflect(const PreciseVector& to_light, const PreciseVector& normal) noexcept {
  return 2 * dot(normal, to_light) * normal - to_light;
}

/// H = (L + V) / |L + V|; 0 where L = -V.
inline PreciseVector half_vector(const PreciseVector& to_light,
                                 const PreciseVector& to_eye) noexcept {
  return normalize(to_light + to_eye);
}

/// R.V = 2 (N.V)(N.L) - L.V.
inline DoubleDouble r_dot_v(const PreciseVector& normal, const PreciseVector& to_light,
                            const PreciseVector& to_eye) noexcept {
  return 2 * dot(normal, to_eye) * dot(normal, to_light) - dot(to_light, to_eye);
}

}  // namespace tristim::detail
