#include <cmath>
#include <limits>

#include "lib/core/math.h"
#include "tristim/color/transfer.h"

namespace tristim {
namespace {

using detail::decimal;
using Dd = detail::DoubleDouble;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Dd kOffset = decimal(9.72);
constexpr Dd kStops = decimal(17.52);

double code_of_log2(Dd log2) noexcept { return ((log2 + kOffset) / kStops).hi; }

// 2^(17.52 E - 9.72) of a code that is not NaN.
Dd light_of_code(double encoded) noexcept {
  if (std::fabs(encoded) > 100) return encoded > 0 ? kInfinity : 0.0;
  return detail::exp2_precise(encoded * kStops - kOffset);
}

// ACEScct's line [AcesCct 4.4], and its joint in code.
constexpr double kLineSlope = 10.5402377416545;
constexpr double kLineOffset = 0.0729055341958355;
constexpr double kLineLight = 0.0078125;
constexpr double kLineCode = 0.155251141552511;

}  // namespace

double acescc_encode(double linear) noexcept {
  if (std::isnan(linear) || linear == kInfinity) return linear;
  if (linear <= 0) return code_of_log2(-16);
  if (linear < 0x1p-15) return code_of_log2(detail::log2_precise(0x1p-16 + 0.5 * Dd(linear)));
  return code_of_log2(detail::log2_precise(linear));
}

double acescc_decode(double encoded) noexcept {
  if (std::isnan(encoded)) return encoded;
  const Dd light = light_of_code(encoded);
  return encoded < (9.72 - 15) / 17.52 ? (2 * (light - 0x1p-16)).hi : light.hi;
}

double acescct_encode(double linear) noexcept {
  if (std::isnan(linear) || linear == kInfinity) return linear;
  if (linear <= kLineLight) return kLineSlope * linear + kLineOffset;
  return code_of_log2(detail::log2_precise(linear));
}

double acescct_decode(double encoded) noexcept {
  if (std::isnan(encoded)) return encoded;
  if (encoded <= kLineCode) return (encoded - kLineOffset) / kLineSlope;
  return light_of_code(encoded).hi;
}

}  // namespace tristim
