#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace tristim::detail {

/// A point of a curve in CIE 1960 u, v.
struct Uv {
  double u = 0, v = 0;
};

/// The Planckian locus of c2 = kC2 by reciprocal temperature, 0 to kLastMired: pieces of fifth
/// degree that meet the exact locus with first and second derivatives at their ends. Maximum error
/// in u and v: 3e-13.
class PlanckianLocus {
 public:
  static const PlanckianLocus& get();  // made at the first call, in 1 ms

  /// A place on the locus and what a colour sees there.
  struct Place {
    double mired;
    Uv point, tangent;  // the tangent by mired
  };

  Place at(double mired) const noexcept;

  /// The place nearest to a colour. Nothing where that is the cold end.
  std::optional<Place> nearest(Uv color) const noexcept;

  static constexpr double kLastMired = 5005;  // 200 K

 private:
  static constexpr std::size_t kPieces = 260;
  struct Piece {
    std::array<double, 6> u, v;  // by t in [0, 1]
  };

  PlanckianLocus();
  Place at(std::size_t piece, double t) const noexcept;
  double slope(std::size_t node, Uv color) const noexcept;
  Place minimum(std::size_t piece, Uv color) const noexcept;

  std::array<Piece, kPieces> pieces_;
  std::array<Uv, kPieces + 1> points_, tangents_;
};

}  // namespace tristim::detail
