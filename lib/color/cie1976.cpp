#include "lib/color/cie1976.h"

#include <cmath>

#include "lib/core/math.h"

namespace tristim::detail {
namespace {

constexpr DoubleDouble kKappa = divide({24389, 0}, {27, 0});

}  // namespace

RelativeXyz relative_xyz(Xyz xyz, Xyz white) noexcept {
  return {0,
          {DoubleDouble{xyz.x}, DoubleDouble{xyz.y}, DoubleDouble{xyz.z}},
          {DoubleDouble{white.x}, DoubleDouble{white.y}, DoubleDouble{white.z}}};
}

RelativeXyz relative_xyz(Rgb rgb, const Eigen::Matrix3d& m) noexcept {
  const DoubleDouble red = two_sum(rgb.r, -rgb.g);
  const DoubleDouble blue = two_sum(rgb.b, -rgb.g);
  const auto rest = [&](int row) {
    return add(multiply(red, m(row, 0)), multiply(blue, m(row, 2)));
  };
  const auto white = [&](int row) { return add(two_sum(m(row, 0), m(row, 1)), {m(row, 2), 0}); };
  return {rgb.g, {rest(0), rest(1), rest(2)}, {white(0), white(1), white(2)}};
}

Rgb off_grey(double y, double x, double z, const Eigen::Matrix3d& m) noexcept {
  return {y + (m(0, 0) * x + m(0, 2) * z), y + (m(1, 0) * x + m(1, 2) * z),
          y + (m(2, 0) * x + m(2, 2) * z)};
}

bool is_moderate(double a, double b, double c) noexcept {
  return std::fabs(a) < 1e100 && std::fabs(b) < 1e100 && std::fabs(c) < 1e100;
}

DoubleDouble cie_f(DoubleDouble t) noexcept {
  if (t.hi > kCieEpsilon) return cube_root(t);
  return divide(add(multiply(kKappa, t), {16, 0}), {116, 0});
}

DoubleDouble cie_lightness(DoubleDouble y) noexcept {
  if (!(y.hi > kCieEpsilon)) return multiply(kKappa, y);
  return subtract(multiply(cube_root(y), 116), {16, 0});
}

}  // namespace tristim::detail
