#pragma once

#include <Eigen/Core>
#include <array>

#include "lib/core/double_double.h"
#include "tristim/color/xyz.h"

namespace tristim::detail {

// Matrices are derived in 106 bits and rounded once at the end: an inverse of double alone loses up
// to three digits where primaries are imaginary.

using ExactVector = std::array<DoubleDouble, 3>;
using ExactMatrix = std::array<ExactVector, 3>;  // rows

ExactMatrix operator*(const ExactMatrix& a, const ExactMatrix& b) noexcept;
ExactVector operator*(const ExactMatrix& m, const ExactVector& v) noexcept;

/// m diag(scale).
ExactMatrix scale_columns(const ExactMatrix& m, const ExactVector& scale) noexcept;

/// Of a matrix with a determinant that is not 0.
ExactMatrix inverse(const ExactMatrix& m) noexcept;

/// The number that `x` stands for: the decimal of up to 12 places or the third that it is nearest
/// to, where it is; else itself.
DoubleDouble published(double x) noexcept;

/// The vector (x, y, 1-x-y) of the published numbers.
ExactVector exact_chromaticity(Chromaticity c) noexcept;

/// The XYZ of a white with Y = 1.
ExactVector exact_white(Chromaticity white) noexcept;

Eigen::Vector3d rounded(const ExactVector& v) noexcept;

/// The nearest doubles, moved by a last bit or two where that makes the product in double of the
/// matrix and `in` exactly `out`, which it is but for rounding: white comes out white.
Eigen::Matrix3d rounded(const ExactMatrix& m, const Eigen::Vector3d& in,
                        const Eigen::Vector3d& out) noexcept;

}  // namespace tristim::detail
