#include "lib/core/arctangent.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace tristim::detail {
namespace {

constexpr int kNodes = 64;

// arctan x = x - x^3/3 + x^5/5 ... for |x| <= 1/64.
constexpr DoubleDouble series(DoubleDouble x) noexcept {
  const DoubleDouble x2 = x * x;
  DoubleDouble sum = 0;
  for (int n = 17; n >= 3; n -= 2) sum = (DoubleDouble(1) / n - sum) * x2;
  return x - x * sum;
}

// arctan(k/64), each from the one before: arctan a = arctan b + arctan((a - b)/(1 + ab)).
constexpr std::array<DoubleDouble, kNodes + 1> arctangents() noexcept {
  std::array<DoubleDouble, kNodes + 1> nodes{};
  for (std::size_t k = 1; k <= kNodes; ++k) {
    const double a = double(k) / kNodes;
    const double b = double(k - 1) / kNodes;
    nodes[k] = nodes[k - 1] + series(DoubleDouble(a - b) / (1 + a * b));
  }
  return nodes;
}
constexpr auto kArctangent = arctangents();

// For 0 <= y <= x, x > 0.
DoubleDouble octant(DoubleDouble y, DoubleDouble x) noexcept {
  const double k = std::nearbyint(y.hi / x.hi * kNodes);
  const double c = k / kNodes;
  // arctan(y/x) = arctan c + arctan((y - cx)/(x + cy))
  return kArctangent[static_cast<std::size_t>(k)] + series((y - x * c) / (x + y * c));
}

}  // namespace

DoubleDouble arctangent(DoubleDouble y, DoubleDouble x) noexcept {
  if (!(y.hi > 0) && !(x.hi < 0)) return 0;
  const DoubleDouble across = x.hi < 0 ? -x : x;
  const DoubleDouble angle = y.hi <= across.hi ? octant(y, across) : kPi / 2 - octant(across, y);
  return x.hi < 0 ? kPi - angle : angle;
}

}  // namespace tristim::detail
