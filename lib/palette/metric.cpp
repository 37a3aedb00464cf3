#include "tristim/palette/metric.h"

#include <algorithm>

#include "lib/color/curve_table.h"
#include "tristim/color/lab.h"
#include "tristim/color/oklab.h"
#include "tristim/color/primaries.h"

namespace tristim {
namespace {

// Light at which the cube root gives way. Diffused to seven inks or to the 16 colours of VGA, none
// leaves streaks in the shadows, 0.02 a relief in the middle tones, 0.3 neither, at the same
// S-CIELAB difference from the original (18.6).
constexpr double kToe = 0.3;

constexpr double kSmallToe = 0.0005;

std::array<float, 3> floats(double a, double b, double c) noexcept {
  return {static_cast<float>(a), static_cast<float>(b), static_cast<float>(c)};
}

Xyz srgb_xyz(Rgb rgb) noexcept {
  static const Eigen::Matrix3d matrix = xyz_from_rgb(Primaries{});
  const Eigen::Vector3d xyz = matrix * Eigen::Vector3d(rgb.r, rgb.g, rgb.b);
  return {xyz.x(), xyz.y(), xyz.z()};
}

}  // namespace

std::array<float, 3> oklab_place(Rgb linear_srgb) noexcept {
  const Oklab c = linear_srgb_to_oklab(linear_srgb);
  return floats(c.l, c.a, c.b);
}

std::array<float, 3> oklab_toe_place(Rgb linear_srgb) noexcept {
  const Oklab c = linear_srgb_to_oklab_with_toe(linear_srgb, kToe);
  return floats(c.l, c.a, c.b);
}

std::array<float, 3> lab_place(Rgb linear_srgb) noexcept {
  const Lab c = xyz_to_lab(srgb_xyz(linear_srgb), white_xyz(kD65));
  return floats(c.l, c.a, c.b);
}

std::array<float, 3> luv_place(Rgb linear_srgb) noexcept {
  // Chromaticities have no meaning below black, where diffused errors go.
  linear_srgb = {std::max(linear_srgb.r, 0.0), std::max(linear_srgb.g, 0.0),
                 std::max(linear_srgb.b, 0.0)};
  const Luv c = xyz_to_luv(srgb_xyz(linear_srgb), white_xyz(kD65));
  return floats(c.l, c.u, c.v);
}

std::array<float, 3> linear_place(Rgb linear_srgb) noexcept {
  return floats(linear_srgb.r, linear_srgb.g, linear_srgb.b);
}

std::array<float, 3> encoded_place(Rgb linear_srgb) noexcept {
  const detail::CurveTable& encode = detail::srgb_encode_table();
  return {encode(static_cast<float>(linear_srgb.r)), encode(static_cast<float>(linear_srgb.g)),
          encode(static_cast<float>(linear_srgb.b))};
}

std::array<float, 3> balanced_place(Rgb linear_srgb) noexcept {
  const auto [r, g, b] = encoded_place(linear_srgb);
  const Oklab ok = linear_srgb_to_oklab_with_toe(linear_srgb, kSmallToe);
  return floats(1.2 * ok.l + 0.4 * (0.5183 * r + 0.7457 * g + 0.4186 * b),
                2 * ok.a + 0.4 * (0.8214 * r - 0.5703 * g),
                2 * ok.b + 0.4 * (0.2379 * r + 0.3444 * g - 0.9082 * b));
}

}  // namespace tristim
