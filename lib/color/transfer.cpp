#include "tristim/color/transfer.h"

#include <cmath>

#include "lib/core/math.h"

namespace tristim {
namespace {

constexpr double kBt1886Gamma = 2.4;

struct Bt1886 {
  double gain, lift;  // a and b of annex 1
};

Bt1886 bt1886_parameters(double black) noexcept {
  const double root = detail::pow(black, 1 / kBt1886Gamma);
  return {detail::pow(1 - root, kBt1886Gamma), root / (1 - root)};
}

}  // namespace

double srgb_encode(double linear) noexcept {
  const double x = std::fabs(linear);
  const double e = x <= 0.0031308 ? 12.92 * x : 1.055 * detail::pow(x, 1 / 2.4) - 0.055;
  return std::copysign(e, linear);
}

double srgb_decode(double encoded) noexcept {
  const double e = std::fabs(encoded);
  const double x = e <= 0.04045 ? e / 12.92 : detail::pow((e + 0.055) / 1.055, 2.4);
  return std::copysign(x, encoded);
}

double gamma_encode(double linear, double gamma) noexcept {
  return std::copysign(detail::pow(std::fabs(linear), 1 / gamma), linear);
}

double gamma_decode(double encoded, double gamma) noexcept {
  return std::copysign(detail::pow(std::fabs(encoded), gamma), encoded);
}

double bt1886_decode(double encoded, double black) noexcept {
  const Bt1886 p = bt1886_parameters(black);
  const double v = encoded + p.lift;
  return v <= 0 ? 0 : p.gain * detail::pow(v, kBt1886Gamma);
}

double bt1886_encode(double linear, double black) noexcept {
  if (linear <= black) return 0;
  const Bt1886 p = bt1886_parameters(black);
  return detail::pow(linear / p.gain, 1 / kBt1886Gamma) - p.lift;
}

}  // namespace tristim
