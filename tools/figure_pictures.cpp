// Figures that are pictures: the spheres, the quadrics and the error map of [FisherWoo].
#include <cmath>
#include <optional>

#include "tools/figures.h"
#include "tristim/light/fisher_woo.h"
#include "tristim/light/highlight_match.h"
#include "tristim/light/microfacet.h"
#include "tristim/light/phong.h"
#include "tristim/light/vector.h"

namespace tristim::tools {
namespace {

using Eigen::Vector3d;

constexpr int kTile = 96;  // pixels a side
const Vector3d kToEye(0, 0, 1);

// The normal seen at (x, y) of a tile that spans -1..1, y up; nothing beside the object.
using Shape = std::optional<Vector3d> (*)(double x, double y);

std::optional<Vector3d> sphere_of(double radius, double x, double y) {
  const double under = radius * radius - x * x - y * y;
  if (under < 0) return std::nullopt;
  return Vector3d(x, y, std::sqrt(under)) / radius;
}

constexpr double kRadius = 0.9;  // of the objects of figure 3

std::optional<Vector3d> cap(double x, double y) {
  if (x * x + y * y > kRadius * kRadius) return std::nullopt;
  return normalize(Vector3d(x, y, kRadius * kRadius));
}

std::optional<Vector3d> cylinder(double x, double y) {
  if (std::fabs(x) > kRadius || std::fabs(y) > kRadius) return std::nullopt;
  return Vector3d(x, 0, std::sqrt(kRadius * kRadius - x * x)) / kRadius;
}

std::optional<Vector3d> sphere(double x, double y) { return sphere_of(kRadius, x, y); }

// A picture of `columns` x `rows` tiles; `light` gives that of (column, row, x, y).
template <typename Light>
Image tiles(int columns, int rows, const Light& light) {
  Image image(columns * kTile, rows * kTile, 1);
  for (int j = 0; j < rows * kTile; ++j) {
    for (int i = 0; i < columns * kTile; ++i) {
      const double x = (i % kTile + 0.5) / (kTile / 2) - 1;
      const double y = 1 - (j % kTile + 0.5) / (kTile / 2);
      *image.view().pixel(i, j) = static_cast<float>(light(i / kTile, j / kTile, x, y));
    }
  }
  return image;
}

Image quadrics(const SpecularModel& model, double factor) {
  static constexpr Shape kShapes[] = {cap, cylinder, sphere};
  static constexpr double kExponents[] = {4, 8, 16, 32};
  const Vector3d to_light = normalize(Vector3d(-1, 1, 1));
  return tiles(4, 3, [&](int column, int row, double x, double y) {
    const auto normal = kShapes[row](x, y);
    if (!normal) return 0.0;
    const double lobe = model.lobe(*normal, to_light, kToEye, factor * kExponents[column]);
    return 0.25 * lambert(*normal, to_light) + 0.75 * lobe;
  });
}

double between(double a, double b, double t) { return a + (b - a) * t; }

}  // namespace

Image fisher_woo_figure2() {
  static constexpr double kLe[] = {0, 45, 90, 135, 160};
  static constexpr double kFactors[] = {0, 1, 2, 4, 6};  // row 0 is R.E
  constexpr double kExponent = 8;
  return tiles(5, 5, [&](int column, int row, double x, double y) {
    const auto normal = sphere_of(0.95, x, y);
    if (!normal) return 0.0;
    const Vector3d to_light = highlight_frame(0, 0, kLe[column]).to_light;
    if (row == 0) return phong_lobe(*normal, to_light, kToEye, kExponent);
    return blinn_phong_lobe(*normal, to_light, kToEye, kFactors[row] * kExponent);
  });
}

Image fisher_woo_figure3_r_dot_e() { return quadrics(kPhong, 1); }

Image fisher_woo_figure3_n_dot_h() { return quadrics(kBlinnPhong, 4); }

Image fisher_woo_figure5() {
  constexpr int kSteps = 91;
  Image image(kSteps, kSteps, 1);
  for (int theta = 0; theta < kSteps; ++theta) {
    for (int phi = 0; phi < kSteps; ++phi) {
      const HighlightFrame frame = highlight_frame(2 * theta, 2 * phi, 90);
      *image.view().pixel(phi, theta) = static_cast<float>(pixel_error(frame, 10, 4));
    }
  }
  return image;
}

Image gloss_spheres() {
  static constexpr double kRoughness[] = {0.1, 0.2, 0.3, 0.45, 0.6, 0.8};
  const Vector3d to_light = normalize(Vector3d(-1, 1, 1));
  constexpr double kPi = 3.14159265358979323846;
  return tiles(6, 1, [&](int column, int, double x, double y) {
    const auto normal = sphere_of(kRadius, x, y);
    if (!normal) return 0.0;
    const double n_dot_l = lambert(*normal, to_light);
    const double rho =
        torrance_sparrow({.m = kRoughness[column]}, Dielectric{1, 1.5}, *normal, to_light, kToEye);
    return n_dot_l * (0.3 + kPi * rho);
  });
}

Rgb grey_tone(double value) noexcept { return {value, value, value}; }

Rgb error_tone(double value) noexcept {
  constexpr double kFull = 64;
  const double t = std::fmin(std::fabs(value) / kFull, 1);
  const Rgb full = value > 0 ? Rgb{0.45, 0.01, 0.02} : Rgb{0.01, 0.09, 0.4};
  return {between(1, full.r, t), between(1, full.g, t), between(1, full.b, t)};
}

}  // namespace tristim::tools
