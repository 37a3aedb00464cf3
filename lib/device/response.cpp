#include "tristim/device/response.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lib/color/precise_curves.h"
#include "lib/core/math.h"
#include "lib/core/rounding.h"
#include "lib/device/precise_response.h"
#include "tristim/color/transfer.h"
#include "tristim/core/text.h"
#include "tristim/device/measured.h"
#include "tristim/device/monotone.h"

namespace tristim {
namespace {

using detail::decimal;
using Dd = detail::DoubleDouble;

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
double light(const GogResponse& r, double code, double code_max) noexcept {
  const double drive = r.offset + (1 - r.offset) * (code / code_max);
  return r.black + (1 - r.black) * gamma_decode(std::max(drive, 0.0), r.gamma);
}

// Codes of a table per code of the channel.
double table_scale(const TableResponse& r, double code_max) noexcept {
  return r.code_max > 0 ? r.code_max / code_max : 1;
}
double light(const TableResponse& r, double code, double code_max) noexcept {
  return monotone_value(r.code, r.luminance, code * table_scale(r, code_max)) / r.luminance.back();
}

Dd root(Dd light, Dd gamma) noexcept {
  return light.hi > 0 ? detail::pow_precise(light, 1 / gamma) : Dd(0);
}

// Of black + (1 - black) (gain V + offset)^gamma, V in [0, 1]. Light below the black has code 0.
Dd drive_of(Dd light, Dd gamma, Dd offset, Dd black) noexcept {
  return (root((light - black) / (1 - black), gamma) - offset) / (1 - offset);
}

Dd code(const SrgbResponse&, Dd light, double code_max) noexcept {
  return detail::srgb_encode_precise(light) * code_max;
}
Dd code(const LinearResponse&, Dd light, double code_max) noexcept { return light * code_max; }
Dd code(const GammaResponse& r, Dd light, double code_max) noexcept {
  const Dd gamma = decimal(r.gamma);
  const Dd i0 = decimal(r.i0);
  if (r.k > 0) return root((light - i0) / (1 - i0) / decimal(r.k), gamma);
  return drive_of(light, gamma, 0, i0) * code_max;
}
Dd code(const Bt1886Response& r, Dd light, double code_max) noexcept {
  const Dd gamma = Dd(12) / 5;
  return drive_of(light, gamma, root(decimal(r.black), gamma), 0) * code_max;
}
Dd code(const GogResponse& r, Dd light, double code_max) noexcept {
  const Dd black = decimal(r.black);
  if (!((light - black).hi > 0)) return 0;
  return drive_of(light, decimal(r.gamma), decimal(r.offset), black) * code_max;
}
Dd code(const TableResponse& r, Dd light, double code_max) noexcept {
  const double luminance = (light * r.luminance.back()).value();
  return monotone_inverse(r.code, r.luminance, luminance) / table_scale(r, code_max);
}

void require(bool good, std::string_view figure, double value, std::string_view range) {
  if (good) return;
  throw std::invalid_argument(std::string(figure) + ": " + shortest(value) + " is not " +
                              std::string(range));
}

void require_gamma(double gamma) {
  require(gamma > 0 && std::isfinite(gamma), "gamma", gamma, "above 0");
}
void require_black(double black) { require(black >= 0 && black < 1, "black", black, "in [0, 1)"); }

void check(const SrgbResponse&) {}
void check(const LinearResponse&) {}
void check(const GammaResponse& r) {
  require_gamma(r.gamma);
  require(r.i0 >= 0 && r.i0 < 1, "i0", r.i0, "in [0, 1)");
  require(r.k >= 0 && std::isfinite(r.k), "k", r.k, "above 0");
}
void check(const Bt1886Response& r) { require_black(r.black); }
void check(const GogResponse& r) {
  require_gamma(r.gamma);
  require(r.offset > -1 && r.offset < 1, "offset", r.offset, "between -1 and 1");
  require_black(r.black);
}
void check(const TableResponse& r) {
  if (r.code.size() < 2 || r.code.size() != r.luminance.size()) {
    throw std::invalid_argument("table: it has not two codes and a luminance for each");
  }
  const auto fault = measured_fault(r.code, r.luminance);
  if (fault) throw std::invalid_argument("table: " + fault->wrong);
}

std::string_view name(const SrgbResponse&) noexcept { return "srgb"; }
std::string_view name(const LinearResponse&) noexcept { return "linear"; }
std::string_view name(const GammaResponse&) noexcept { return "gamma"; }
std::string_view name(const Bt1886Response&) noexcept { return "bt1886"; }
std::string_view name(const GogResponse&) noexcept { return "gog"; }
std::string_view name(const TableResponse&) noexcept { return "table"; }

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
std::string words(const GogResponse& r) {
  return "gain-offset-gamma: I = black + (1 - black) max(gain V/Vmax + offset, 0)^gamma, gamma = " +
         shortest(r.gamma) + ", offset = " + shortest(r.offset) +
         ", gain = " + shortest(1 - r.offset) + ", black = " + shortest(r.black);
}
std::string words(const TableResponse& r) {
  return "measured table of " + std::to_string(r.code.size()) + " codes, a monotone spline between";
}

}  // namespace

double light_of_code(const Response& response, double v, double code_max) noexcept {
  return std::clamp(std::visit([&](const auto& r) { return light(r, v, code_max); }, response), 0.0,
                    1.0);
}

Dd detail::precise_code(const Response& response, Dd i, double code_max) noexcept {
  if (i.hi > 0x1p500) return code_max;  // light without end has no digits
  const Dd v = std::visit([&](const auto& r) { return code(r, i, code_max); }, response);
  if (v.hi < 0) return 0;
  return v.hi > code_max ? Dd(code_max) : v;
}

int detail::nearest_code(const Response& response, Dd i, int code_max) noexcept {
  return static_cast<int>(round_half_up(precise_code(response, i, code_max)));
}

double code_of_light(const Response& response, double i, double code_max) noexcept {
  return detail::precise_code(response, decimal(i), code_max).value();
}

int nearest_code(const Response& response, double light, int code_max) noexcept {
  return detail::nearest_code(response, decimal(light), code_max);
}

void check_response(const Response& response) {
  std::visit([](const auto& r) { check(r); }, response);
}

std::string_view kind_of(const Response& response) noexcept {
  return std::visit([](const auto& r) { return name(r); }, response);
}

std::string describe(const Response& response) {
  return std::visit([](const auto& r) { return words(r); }, response);
}

}  // namespace tristim
