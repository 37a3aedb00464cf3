#include "tristim/palette/metric.h"

#include <algorithm>
#include <cmath>

#include "lib/color/curve_table.h"
#include "lib/palette/oklab_toe.h"
#include "tristim/color/lab.h"
#include "tristim/color/models.h"
#include "tristim/color/oklab.h"
#include "tristim/color/primaries.h"
#include "tristim/color/rows.h"

namespace tristim {
namespace {

// The balanced metric: share of the codes, weights of Oklab's axes, how fast its chroma gives way,
// and light without which the darkest colours would take entries that nobody sees. What lessens
// CIEDE2000, S-CIELAB and squares of codes most evenly beside libimagequant, over eight
// photographs of 256 colours.
constexpr float kCodes = 0.5F;
constexpr float kBalancedL = 0.64F;
constexpr float kBalancedA = 1.1F;
constexpr float kBalancedB = 1.27F;
constexpr float kBalancedChroma = 3.0F;
constexpr double kBalancedToe = 0.0037;

std::array<float, 3> floats(double a, double b, double c) noexcept {
  return {static_cast<float>(a), static_cast<float>(b), static_cast<float>(c)};
}

Xyz srgb_xyz(Rgb rgb) noexcept {
  static const Eigen::Matrix3d matrix = xyz_from_rgb(Primaries{});
  const Eigen::Vector3d xyz = matrix * Eigen::Vector3d(rgb.r, rgb.g, rgb.b);
  return {xyz.x(), xyz.y(), xyz.z()};
}

std::array<float, 3> balanced(const std::array<float, 3>& oklab,
                              const std::array<float, 3>& rgb) noexcept {
  const auto [r, g, b] = rgb;
  const float chroma2 = oklab[1] * oklab[1] + oklab[2] * oklab[2];
  const float fades = 1 / (1 + kBalancedChroma * std::sqrt(chroma2));
  return {kBalancedL * oklab[0] + kCodes * (0.5183F * r + 0.7457F * g + 0.4186F * b),
          kBalancedA * fades * oklab[1] + kCodes * (0.8214F * r - 0.5703F * g),
          kBalancedB * fades * oklab[2] + kCodes * (0.2379F * r + 0.3444F * g - 0.9082F * b)};
}

const RowConversion& oklab_row() {
  static const RowConversion conversion(parse_model("linear:srgb", "metric"),
                                        parse_model("oklab", "metric"), Adaptation::kBradford);
  return conversion;
}

}  // namespace

std::array<float, 3> oklab_place(Rgb linear_srgb) noexcept {
  const Oklab c = linear_srgb_to_oklab(linear_srgb);
  return floats(c.l, c.a, c.b);
}

std::array<float, 3> oklab_toe_place(Rgb linear_srgb) noexcept {
  const Oklab c = linear_srgb_to_oklab_with_toe(linear_srgb, detail::kToe);
  return floats(detail::kLightness * c.l, c.a, c.b);
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

// Oklab and codes turned so that their axes run along Oklab's.
std::array<float, 3> balanced_place(Rgb linear_srgb) noexcept {
  const Oklab ok = linear_srgb_to_oklab({std::clamp(linear_srgb.r, 0.0, 1.0) + kBalancedToe,
                                         std::clamp(linear_srgb.g, 0.0, 1.0) + kBalancedToe,
                                         std::clamp(linear_srgb.b, 0.0, 1.0) + kBalancedToe});
  return balanced(floats(ok.l, ok.a, ok.b), encoded_place(linear_srgb));
}

void oklab_place_row(std::span<float> pixels) { oklab_row()(pixels, 3, pixels, 3); }

void balanced_place_row(std::span<float> pixels) {
  constexpr std::size_t kPixels = 128;
  const detail::CurveTable& encode = detail::srgb_encode_table();
  std::array<float, 3 * kPixels> codes{};
  while (!pixels.empty()) {
    const std::span<float> block = pixels.first(std::min(pixels.size(), codes.size()));
    for (std::size_t i = 0; i < block.size(); ++i) {
      codes[i] = encode(block[i]);
      block[i] = std::clamp(block[i], 0.0F, 1.0F) + static_cast<float>(kBalancedToe);
    }
    oklab_place_row(block);
    for (std::size_t i = 0; i < block.size(); i += 3) {
      const auto place =
          balanced({block[i], block[i + 1], block[i + 2]}, {codes[i], codes[i + 1], codes[i + 2]});
      std::copy(place.begin(), place.end(), &block[i]);
    }
    pixels = pixels.subspan(block.size());
  }
}

void place_row(const Metric& metric, std::span<float> pixels) {
  if (metric.place_row != nullptr) return metric.place_row(pixels);
  for (std::size_t i = 0; i < pixels.size(); i += 3) {
    const auto place = metric.place({pixels[i], pixels[i + 1], pixels[i + 2]});
    std::copy(place.begin(), place.end(), &pixels[i]);
  }
}

}  // namespace tristim
