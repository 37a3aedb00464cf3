#include "tristim/device/response.h"

#include <algorithm>
#include <cstddef>

#include "lib/core/math.h"
#include "tristim/color/transfer.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

double interpolate(const std::vector<double>& x, const std::vector<double>& y, double at) noexcept {
  if (at <= x.front()) return y.front();
  if (at >= x.back()) return y.back();
  const auto above = std::upper_bound(x.begin(), x.end(), at);
  const auto i = static_cast<std::size_t>(above - x.begin());
  return y[i - 1] + (y[i] - y[i - 1]) * ((at - x[i - 1]) / (x[i] - x[i - 1]));
}

double light(const SrgbResponse&, double code, double code_max) noexcept {
  return srgb_decode(code / code_max);
}
double light(const LinearResponse&, double code, double code_max) noexcept {
  return code / code_max;
}
double light(const GammaResponse& r, double code, double code_max) noexcept {
  const double power =
      r.k > 0 ? r.k * gamma_decode(code, r.gamma) : gamma_decode(code / code_max, r.gamma);
  return r.i0 + (1 - r.i0) * power;
}
double light(const Bt1886Response& r, double code, double code_max) noexcept {
  return bt1886_decode(code / code_max, r.black);
}
double light(const TableResponse& r, double code, double) noexcept {
  return interpolate(r.code, r.luminance, code) / r.luminance.back();
}

double code(const SrgbResponse&, double light, double code_max) noexcept {
  return srgb_encode(light) * code_max;
}
double code(const LinearResponse&, double light, double code_max) noexcept {
  return light * code_max;
}
double code(const GammaResponse& r, double light, double code_max) noexcept {
  const double power = (light - r.i0) / (1 - r.i0);
  return r.k > 0 ? gamma_encode(power / r.k, r.gamma) : gamma_encode(power, r.gamma) * code_max;
}
double code(const Bt1886Response& r, double light, double code_max) noexcept {
  return bt1886_encode(light, r.black) * code_max;
}
double code(const TableResponse& r, double light, double) noexcept {
  return interpolate(r.luminance, r.code, light * r.luminance.back());
}

std::string words(const SrgbResponse&) { return "sRGB: " + std::string(kSrgbTransfer.formula); }
std::string words(const LinearResponse&) { return "linear: I = V / Vmax"; }
std::string words(const GammaResponse& r) {
  const std::string k = r.k > 0 ? shortest(r.k) : "Vmax^-gamma";
  return "gamma: I = i0 + (1 - i0) K V^gamma, gamma = " + shortest(r.gamma) +
         ", i0 = " + shortest(r.i0) + ", K = " + k;
}
std::string words(const Bt1886Response& r) {
  return "BT.1886: I = a max(V + b, 0)^2.4, black = " + shortest(r.black);
}
std::string words(const TableResponse& r) {
  return "measured table of " + std::to_string(r.code.size()) + " codes, straight lines between";
}

}  // namespace

double light_of_code(const Response& response, double v, double code_max) noexcept {
  return std::clamp(std::visit([&](const auto& r) { return light(r, v, code_max); }, response), 0.0,
                    1.0);
}

double code_of_light(const Response& response, double i, double code_max) noexcept {
  const double v = std::visit([&](const auto& r) { return code(r, i, code_max); }, response);
  return std::clamp(v, 0.0, code_max);
}

std::string describe(const Response& response) {
  return std::visit([](const auto& r) { return words(r); }, response);
}

}  // namespace tristim
