#include "lib/color/exact_matrix.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace tristim::detail {
namespace {

constexpr std::size_t next(std::size_t i) { return (i + 1) % 3; }

DoubleDouble dot(const ExactVector& a, const ExactVector& b) noexcept {
  return add(add(multiply(a[0], b[0]), multiply(a[1], b[1])), multiply(a[2], b[2]));
}

ExactVector column(const ExactMatrix& m, std::size_t j) noexcept {
  return {m[0][j], m[1][j], m[2][j]};
}

ExactVector cross(const ExactVector& a, const ExactVector& b) noexcept {
  ExactVector c;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = next(i);
    const std::size_t k = next(j);
    c[i] = subtract(multiply(a[j], b[k]), multiply(a[k], b[j]));
  }
  return c;
}

// How far the product of a row and `in` is from `out`, in the two orders in which loops and Eigen
// add.
double miss(const Eigen::RowVector3d& row, const Eigen::Vector3d& in, double out) noexcept {
  const Eigen::Vector3d term = row.transpose().cwiseProduct(in);
  return std::fabs((term[0] + term[1]) + term[2] - out) +
         std::fabs(term[0] + (term[1] + term[2]) - out);
}

// Of `row` and the rows within two small steps of each entry that is not 0 the one that comes
// nearest to `out`, and of those the one that moved least.
Eigen::RowVector3d nearest_row(const Eigen::RowVector3d& row, const Eigen::Vector3d& in,
                               double out) noexcept {
  constexpr double kSteps[] = {0, 1, -1, 2, -2};
  const double fine = row.cwiseAbs().maxCoeff() * 0x1p-54;  // a quarter or half of its last bit
  Eigen::RowVector3d best = row;
  double least_miss = miss(row, in, out);
  double least_move = 0;
  for (std::size_t k = 1; k < 125; ++k) {
    const Eigen::RowVector3d steps(kSteps[k % 5], kSteps[k / 5 % 5], kSteps[k / 25]);
    Eigen::RowVector3d moved = row;
    for (Eigen::Index j = 0; j < 3; ++j) {
      const double last_bit = std::fabs(row[j]) * 0x1p-52;
      if (row[j] != 0) moved[j] += steps[j] * std::max(fine, last_bit);
    }
    const double missed = miss(moved, in, out);
    const double move = (moved - row).cwiseAbs().sum();
    if (std::tie(missed, move) >= std::tie(least_miss, least_move)) continue;
    best = moved;
    least_miss = missed;
    least_move = move;
  }
  return best;
}

}  // namespace

ExactMatrix operator*(const ExactMatrix& a, const ExactMatrix& b) noexcept {
  ExactMatrix m;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) m[i][j] = dot(a[i], column(b, j));
  }
  return m;
}

ExactVector operator*(const ExactMatrix& m, const ExactVector& v) noexcept {
  return {dot(m[0], v), dot(m[1], v), dot(m[2], v)};
}

ExactMatrix scale_columns(const ExactMatrix& m, const ExactVector& scale) noexcept {
  ExactMatrix scaled = m;
  for (ExactVector& row : scaled) {
    for (std::size_t j = 0; j < 3; ++j) row[j] = multiply(row[j], scale[j]);
  }
  return scaled;
}

ExactMatrix inverse(const ExactMatrix& m) noexcept {
  const DoubleDouble determinant = dot(m[0], cross(m[1], m[2]));
  ExactMatrix result;
  for (std::size_t j = 0; j < 3; ++j) {
    const ExactVector cofactors = cross(m[next(j)], m[next(next(j))]);
    for (std::size_t i = 0; i < 3; ++i) result[i][j] = divide(cofactors[i], determinant);
  }
  return result;
}

DoubleDouble published(double x) noexcept {
  if (x == 1.0 / 3) return divide({1, 0}, {3, 0});
  constexpr double kPlaces = 1e12;
  const double n = std::nearbyint(x * kPlaces);
  if (std::fabs(n) < 0x1p53 && n / kPlaces == x) return divide({n, 0}, {kPlaces, 0});
  return {x, 0};
}

ExactVector exact_chromaticity(Chromaticity c) noexcept {
  const DoubleDouble x = published(c.x);
  const DoubleDouble y = published(c.y);
  const DoubleDouble z = subtract(subtract({1, 0}, x), y);
  constexpr double kRounding = 1e-30;  // of decimals in 106 bits: .73467 + .26533 is 1
  return {x, y, std::fabs(z.hi) < kRounding ? DoubleDouble{} : z};
}

ExactVector exact_white(Chromaticity white) noexcept {
  const ExactVector c = exact_chromaticity(white);
  return {divide(c[0], c[1]), {1, 0}, divide(c[2], c[1])};
}

Eigen::Vector3d rounded(const ExactVector& v) noexcept { return {v[0].hi, v[1].hi, v[2].hi}; }

Eigen::Matrix3d rounded(const ExactMatrix& m, const Eigen::Vector3d& in,
                        const Eigen::Vector3d& out) noexcept {
  Eigen::Matrix3d result;
  for (Eigen::Index i = 0; i < 3; ++i) {
    result.row(i) = nearest_row(rounded(m[static_cast<std::size_t>(i)]), in, out[i]);
  }
  return result;
}

}  // namespace tristim::detail
