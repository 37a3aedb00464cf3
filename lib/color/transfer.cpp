#include "tristim/color/transfer.h"

#include <cmath>
#include <limits>

#include "lib/color/odd.h"
#include "lib/color/precise_curves.h"
#include "lib/core/math.h"

namespace tristim {
namespace {

using detail::decimal;
using Dd = detail::DoubleDouble;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// E = slope L below a joint, else alpha L^exponent - (alpha - 1): the shape of most of video.
struct OffsetPower {
  double slope;
  Dd alpha;
  Dd exponent;
  double linear_joint, encoded_joint;
  bool joint_is_straight;  // the line holds at the joint as well
};

bool straight(double x, double joint, const OffsetPower& curve) noexcept {
  return curve.joint_is_straight ? x <= joint : x < joint;
}

Dd encode_power(Dd linear, const OffsetPower& curve) noexcept {
  return curve.alpha * detail::pow_precise(linear, curve.exponent) - (curve.alpha - 1);
}

Dd decode_power(Dd encoded, const OffsetPower& curve) noexcept {
  return detail::pow_precise((encoded + (curve.alpha - 1)) / curve.alpha, 1 / curve.exponent);
}

double encode(double linear, const OffsetPower& curve) noexcept {
  return detail::odd(linear, [&](double x) {
    return straight(x, curve.linear_joint, curve) ? curve.slope * x : encode_power(x, curve).hi;
  });
}

double decode(double encoded, const OffsetPower& curve) noexcept {
  return detail::odd(encoded, [&](double e) {
    if (straight(e, curve.encoded_joint, curve)) return e / curve.slope;
    if (e > 0x1p500) return kInfinity;  // all exponents are above 2
    return decode_power(e, curve).hi;
  });
}

constexpr OffsetPower kSrgb{12.92, decimal(1.055), Dd(5) / 12, 0.0031308, 0.04045, true};
constexpr OffsetPower kBt709{4.5, decimal(1.099), decimal(0.45), 0.018, 0.081, false};
constexpr OffsetPower kSmpte240m{4, decimal(1.1115), decimal(0.45), 0.0228, 0.0913, false};

// beta of [BT2020]: 5.5 beta - 10 beta^.55 + 1 = 0, by Newton's method.
OffsetPower solve_bt2020() noexcept {
  Dd beta = 0.018;
  for (int i = 0; i < 6; ++i) {
    const Dd power = detail::pow_precise(beta, decimal(0.55));
    beta = beta - (5.5 * beta - 10 * power + 1) / (5.5 - 5.5 * power / beta);
  }
  return {4.5, 1 + 5.5 * beta, decimal(0.45), beta.hi, (4.5 * beta).hi, false};
}

const OffsetPower& bt2020() noexcept {
  static const OffsetPower curve = solve_bt2020();
  return curve;
}

double power(double x, Dd exponent) noexcept {
  return detail::odd(x, [&](double v) { return v == 0 ? 0 : detail::pow_precise(v, exponent).hi; });
}

constexpr double kRommJoint = 1.0 / 512;  // 16^(1.8/(1 - 1.8)) = 2^-9
constexpr Dd kRommExponent = decimal(1.8);

// The 2.4th root of a luminance.
Dd monitor_root(double luminance) noexcept {
  return luminance > 0 ? detail::pow_precise(luminance, Dd(5) / 12) : Dd(0);
}

}  // namespace

Dd detail::srgb_encode_precise(Dd linear) noexcept {
  if (straight(linear.hi, kSrgb.linear_joint, kSrgb)) return decimal(kSrgb.slope) * linear;
  return encode_power(linear, kSrgb);
}

Dd detail::srgb_decode_precise(Dd encoded) noexcept {
  if (straight(encoded.hi, kSrgb.encoded_joint, kSrgb)) return encoded / decimal(kSrgb.slope);
  return decode_power(encoded, kSrgb);
}

double srgb_encode(double linear) noexcept { return encode(linear, kSrgb); }
double srgb_decode(double encoded) noexcept { return decode(encoded, kSrgb); }
double bt709_encode(double linear) noexcept { return encode(linear, kBt709); }
double bt709_decode(double encoded) noexcept { return decode(encoded, kBt709); }
double bt2020_encode(double linear) noexcept { return encode(linear, bt2020()); }
double bt2020_decode(double encoded) noexcept { return decode(encoded, bt2020()); }
double smpte240m_encode(double linear) noexcept { return encode(linear, kSmpte240m); }
double smpte240m_decode(double encoded) noexcept { return decode(encoded, kSmpte240m); }

double romm_encode(double linear) noexcept {
  return std::fabs(linear) < kRommJoint ? 16 * linear : power(linear, 1 / kRommExponent);
}

double romm_decode(double encoded) noexcept {
  return std::fabs(encoded) < 16 * kRommJoint ? encoded / 16 : power(encoded, kRommExponent);
}

double gamma_encode(double linear, double gamma) noexcept {
  return power(linear, 1 / decimal(gamma));
}
double gamma_decode(double encoded, double gamma) noexcept {
  return power(encoded, decimal(gamma));
}

double adobe_encode(double linear) noexcept { return gamma_encode(linear, kAdobeGamma); }
double adobe_decode(double encoded) noexcept { return gamma_decode(encoded, kAdobeGamma); }

double lstar_encode(double linear) noexcept {
  if (!(linear > 216.0 / 24389)) return 24389.0 / 2700 * linear;
  if (linear == kInfinity) return linear;
  return (decimal(1.16) * detail::pow_precise(linear, Dd(1) / 3) - decimal(0.16)).hi;
}

double lstar_decode(double encoded) noexcept {
  if (!(encoded > 0.08)) return 2700.0 / 24389 * encoded;
  if (encoded > 0x1p500) return kInfinity;
  const Dd root = (encoded + decimal(0.16)) / decimal(1.16);
  return (root * root * root).hi;
}

double bt1886_decode(double encoded, double white, double black) noexcept {
  if (!(std::fabs(encoded) < 0x1p500)) return encoded < 0 ? 0 : encoded * kInfinity;
  const Dd dark = monitor_root(black);
  const Dd root = (monitor_root(white) - dark) * encoded + dark;
  return root.hi <= 0 ? 0 : detail::pow_precise(root, Dd(12) / 5).hi;
}

double bt1886_encode(double linear, double white, double black) noexcept {
  if (std::isnan(linear) || linear == kInfinity) return linear;
  const Dd dark = monitor_root(black);
  return ((monitor_root(linear) - dark) / (monitor_root(white) - dark)).hi;
}

double bt1886_decode(double encoded, double black) noexcept {
  return bt1886_decode(encoded, 1, black);
}
double bt1886_encode(double linear, double black) noexcept {
  return bt1886_encode(linear, 1, black);
}

double bt1886_decode(double encoded) noexcept { return bt1886_decode(encoded, 1, 0); }
double bt1886_encode(double linear) noexcept { return bt1886_encode(linear, 1, 0); }

double linear_curve(double light) noexcept { return light; }

}  // namespace tristim
