#pragma once

#include <array>
#include <cstddef>

namespace tristim::detail {

/// A place on [0, 1] and what it counts in a mean over it.
struct Node {
  double at = 0, weight = 0;
};

/// Gauss-Legendre quadrature, exact for polynomials up to degree 79; the nodes by Newton's method
/// from the zeros of Chebyshev's polynomial.
const std::array<Node, 40>& gauss_legendre() noexcept;

}  // namespace tristim::detail
