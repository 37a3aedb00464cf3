#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tristim/color/plane.h"

namespace tristim::detail {

/// The linear function a x + b y + c.
struct LinearFunction {
  double a = 0, b = 0, c = 0;
  double at(double x, double y) const noexcept { return a * x + b * y + c; }
};

/// The greatest of thousands of linear functions over a convex domain within the unit square, in a
/// few steps: a quadtree whose leaves hold the functions that are the greatest somewhere in them.
class Envelope {
 public:
  Envelope(std::span<const LinearFunction> functions, Polygon domain);

  /// The greatest at a point of the domain, or 0 if that is more; infinity outside of the domain.
  double at(double x, double y) const noexcept;

  const Polygon& domain() const noexcept { return domain_; }

 private:
  enum class Side : std::uint8_t { kOutside, kCut, kInside };  // where a leaf lies in the domain
  struct Node {
    std::uint32_t first = 0;  // of four children in nodes_, or of the functions in functions_
    std::uint16_t count = 0;  // of a leaf's functions
    bool branch = false;
    Side side = Side::kOutside;
  };

  void divide(std::size_t node, PlanePoint corner, double size,
              std::span<const LinearFunction> functions);
  const Node& leaf(double x, double y) const noexcept;

  Polygon domain_;
  std::vector<Node> nodes_;
  std::vector<LinearFunction> functions_;
};

}  // namespace tristim::detail
