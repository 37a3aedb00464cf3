#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tristim/color/transfer.h"

namespace tristim {

/// How an RGB model is encoded: by a curve of kTransferFunctions or by a pure exponent.
struct RgbCurve {
  TransferFunction function = kSrgbTransfer;  // without a name: code = light^(1/gamma)
  double gamma = 1;
  double black = 0;  // of bt1886: the luminance of black over that of white, [0, 1)

  constexpr bool is_exponent() const noexcept { return function.name.empty(); }
  friend constexpr bool operator==(const RgbCurve& a, const RgbCurve& b) {
    return a.function.name == b.function.name && a.gamma == b.gamma && a.black == b.black;
  }
};

double encode(const RgbCurve& curve, double linear) noexcept;
double decode(const RgbCurve& curve, double encoded) noexcept;

/// A curve by its name, or with numbers: "gamma 2.2", "gamma2.2", "gamma 563/256", and
/// "bt1886,100,0.1" for a monitor whose white and black have those luminances. Nothing where it is
/// none.
std::optional<RgbCurve> parse_rgb_curve(std::string_view text);

/// Its name, "gamma 2.2" where it is an exponent; its formula with its source.
std::string curve_name(const RgbCurve& curve);
std::string curve_formula(const RgbCurve& curve);

}  // namespace tristim
