#include <cmath>
#include <limits>

#include "lib/color/odd.h"
#include "lib/color/precise_curves.h"
#include "lib/core/math.h"
#include "tristim/color/transfer.h"

namespace tristim {
namespace {

using Dd = detail::DoubleDouble;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// [ST2084], all exact in a double.
constexpr double kM1 = 2610.0 / 16384;
constexpr double kM2 = 2523.0 / 32;
constexpr double kC1 = 3424.0 / 4096;
constexpr double kC2 = 2413.0 / 128;
constexpr double kC3 = 2392.0 / 128;

struct Hlg {
  Dd a, b, c;
};

const Hlg& hlg() noexcept {
  static const Hlg constants = [] {
    const Dd a = detail::decimal(0.17883277);
    return Hlg{a, 1 - 4 * a, 0.5 - a * detail::log_precise(4 * a)};
  }();
  return constants;
}

double hlg_gamma(double white) noexcept {
  return 1.2 + 0.42 * (detail::log2_precise(white) - detail::log2_precise(1000)).hi /
                   detail::log2_precise(10).hi;
}

double scene_luminance(Rgb c) noexcept { return 0.2627 * c.r + 0.6780 * c.g + 0.0593 * c.b; }

Rgb scaled(Rgb c, double gain) noexcept { return {gain * c.r, gain * c.g, gain * c.b}; }

// What both directions do where no number comes out: black for a luminance of 0, NaN for NaN.
Rgb black_or_nan(Rgb c) noexcept { return scaled(c, 0); }

}  // namespace

Dd detail::pq_encode_precise(Dd linear) noexcept {
  const Dd p = linear.hi > 0 ? pow_precise(linear, kM1) : Dd(0);
  return pow_precise((kC1 + kC2 * p) / (1 + kC3 * p), kM2);
}

Dd detail::pq_decode_precise(Dd encoded) noexcept {
  if (!(encoded.hi > 0)) return 0;
  const Dd p = pow_precise(encoded, 1 / Dd(kM2));
  const Dd rise = p - kC1;
  const Dd pole = kC2 - kC3 * p;
  if (!(rise.hi > 0)) return 0;
  if (!(pole.hi > 0)) return kInfinity;
  return pow_precise(rise / pole, 1 / Dd(kM1));
}

double pq_encode(double linear) noexcept {
  if (std::isnan(linear)) return linear;
  if (linear == kInfinity) return detail::pow_precise(Dd(kC2) / kC3, kM2).hi;
  return detail::pq_encode_precise(linear).hi;
}

double pq_decode(double encoded) noexcept {
  if (std::isnan(encoded)) return encoded;
  return encoded < 2 ? detail::pq_decode_precise(encoded).hi
                     : kInfinity;  // the pole is at (c2/c3)^m2 = 1.99
}

double hlg_encode(double linear) noexcept {
  return detail::odd(linear, [](double x) {
    if (x <= 1.0 / 12) return std::sqrt(3 * x);
    if (x > 0x1p500)
      return (hlg().a * (detail::log_precise(x) + detail::log_precise(12)) + hlg().c).hi;
    return (hlg().a * detail::log_precise(12 * Dd(x) - hlg().b) + hlg().c).hi;
  });
}

double hlg_decode(double encoded) noexcept {
  return detail::odd(encoded, [](double e) {
    if (e <= 0.5) return e * e / 3;
    if (e > 1000) return kInfinity;
    const Dd power = detail::exp_precise((e - hlg().c) / hlg().a - detail::log_precise(12));
    return power.hi > 0x1p900 ? power.hi : (power + hlg().b / 12).hi;
  });
}

Rgb hlg_ootf(Rgb scene, double white) noexcept {
  const double y = scene_luminance(scene);
  if (!(y != 0)) return black_or_nan(scene);
  return scaled(scene, white * detail::pow(std::fabs(y), hlg_gamma(white) - 1));
}

Rgb hlg_inverse_ootf(Rgb display, double white) noexcept {
  // Of the luminance of the display, white Ys^gamma, the scene's is its gamma-th root.
  const double y = scene_luminance(display) / white;
  if (!(y != 0)) return black_or_nan(display);
  const double gamma = hlg_gamma(white);
  return scaled(display, detail::pow(std::fabs(y), (1 - gamma) / gamma) / white);
}

}  // namespace tristim
