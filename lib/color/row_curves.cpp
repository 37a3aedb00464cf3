#include "lib/color/row_curves.h"

#include <cmath>
#include <limits>

#include "lib/core/math.h"

namespace tristim::detail {
namespace {

using K = RowKernels;

// The least double for which the line no longer holds where it holds at the joint as well.
double above(double joint) { return std::nextafter(joint, 1.0); }

PowerCurve exponent(double gamma) {
  const DoubleDouble g = decimal(gamma);
  return {.exponent = (1 / g).hi, .inverse_exponent = g.hi};
}

PowerCurve offset_power(double slope, double joint, double joint_encoded, double alpha,
                        double gamma) {
  return {slope, joint, joint_encoded, alpha, alpha - 1, gamma, 1 / gamma, 0};
}

// Its beta and alpha [BT2020], solved; rounded to double they are far finer than a float.
PowerCurve bt2020() {
  constexpr double kBeta = 0.018053968510807807;
  return offset_power(4.5, kBeta, 4.5 * kBeta, 1 + 5.5 * kBeta, 0.45);
}

PowerCurve srgb() {
  PowerCurve curve{12.92, above(0.0031308), above(0.04045), 1.055, 0.055, 1 / 2.4, 2.4, 0};
  return curve;
}

PowerCurve lstar() {
  return {24389.0 / 2700, above(216.0 / 24389), above(0.08), 1.16, 0.16, 1.0 / 3, 3, 1};
}

RowParameters hlg() {
  const DoubleDouble a = decimal(0.17883277);
  return {a.hi, (1 - 4 * a).hi, (0.5 - a * log_precise(4 * a)).hi};
}

// [BT1886 annex 1], relative to the white.
RowParameters monitor(double black) {
  const double dark = pow(black, 1 / 2.4);
  return {1 - dark, dark};
}

CurveKernels power(const K& kernels, const PowerCurve& curve) {
  return {kernels.power_encode, kernels.power_decode, curve.parameters()};
}

// The kernels of a member of kTransferFunctions.
struct NamedKernels {
  std::string_view name;
  CurveKernels (*kernels)(const K& k);
};

constexpr NamedKernels kNamed[] = {
    {"srgb", [](const K& k) { return power(k, srgb()); }},
    {"bt709", [](const K& k) { return power(k, offset_power(4.5, 0.018, 0.081, 1.099, 0.45)); }},
    {"bt2020", [](const K& k) { return power(k, bt2020()); }},
    {"smpte240m",
     [](const K& k) { return power(k, offset_power(4, 0.0228, 0.0913, 1.1115, 0.45)); }},
    {"romm",
     [](const K& k) {
       return power(k, {16, 1.0 / 512, 1.0 / 32, 1, 0, 1 / 1.8, 1.8, 0});
     }},
    {"adobe", [](const K& k) { return power(k, exponent(kAdobeGamma)); }},
    {"lstar", [](const K& k) { return power(k, lstar()); }},
    {"pq",
     [](const K& k) {
       return CurveKernels{k.pq_encode, k.pq_decode, {}};
     }},
    {"hlg",
     [](const K& k) {
       return CurveKernels{k.hlg_encode, k.hlg_decode, hlg()};
     }},
    {"acescc",
     [](const K& k) {
       return CurveKernels{k.acescc_encode, k.acescc_decode, {}};
     }},
    {"acescct",
     [](const K& k) {
       return CurveKernels{k.acescct_encode, k.acescct_decode, {}};
     }},
};

}  // namespace

std::optional<CurveKernels> curve_kernels(const RgbCurve& curve, const K& kernels) {
  if (curve.is_exponent()) return power(kernels, exponent(curve.gamma));
  if (curve.function.name == "bt1886") {
    return CurveKernels{kernels.bt1886_encode, kernels.bt1886_decode, monitor(curve.black)};
  }
  for (const NamedKernels& named : kNamed) {
    if (named.name == curve.function.name) return named.kernels(kernels);
  }
  return std::nullopt;
}

}  // namespace tristim::detail
