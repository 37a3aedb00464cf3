#include "tristim/color/rgb_curve.h"

#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

// "2.2" or "563/256".
std::optional<double> parse_exponent(std::string_view text) {
  const std::size_t slash = text.find('/');
  const auto numerator = parse_number(text.substr(0, slash));
  if (!numerator || slash == std::string_view::npos) return numerator;
  const auto denominator = parse_number(text.substr(slash + 1));
  if (!denominator) return std::nullopt;
  return *numerator / *denominator;
}

// "100,0.1": the luminances of white and black.
std::optional<RgbCurve> parse_monitor(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const auto white = parse_number(text.substr(0, comma));
  const auto black = parse_number(text.substr(comma + 1));
  if (!white || !black || !(*black >= 0 && *black < *white)) return std::nullopt;
  return RgbCurve{*find_by_name(kTransferFunctions, "bt1886"), 1, *black / *white};
}

}  // namespace

double encode(const RgbCurve& curve, double linear) noexcept {
  if (curve.is_exponent()) return gamma_encode(linear, curve.gamma);
  return curve.black > 0 ? bt1886_encode(linear, curve.black) : curve.function.encode(linear);
}

double decode(const RgbCurve& curve, double encoded) noexcept {
  if (curve.is_exponent()) return gamma_decode(encoded, curve.gamma);
  return curve.black > 0 ? bt1886_decode(encoded, curve.black) : curve.function.decode(encoded);
}

std::optional<RgbCurve> parse_rgb_curve(std::string_view text) {
  if (const TransferFunction* known = find_by_name(kTransferFunctions, text)) {
    return RgbCurve{*known, 1};
  }
  if (const std::size_t comma = text.find(','); comma != std::string_view::npos) {
    return same_name(text.substr(0, comma), "bt1886") ? parse_monitor(text.substr(comma + 1))
                                                      : std::nullopt;
  }
  constexpr std::string_view kGamma = "gamma";
  if (!same_name(text.substr(0, kGamma.size()), kGamma)) return std::nullopt;
  text.remove_prefix(kGamma.size());
  if (text.starts_with(' ')) text.remove_prefix(1);
  const auto exponent = parse_exponent(text);
  if (!exponent || !(*exponent > 0 && *exponent < 1e3)) return std::nullopt;
  return RgbCurve{{}, *exponent};
}

std::string curve_name(const RgbCurve& curve) {
  if (!curve.is_exponent()) {
    const std::string name(curve.function.name);
    return curve.black > 0 ? name + ",1," + shortest(curve.black) : name;
  }
  return "gamma " + shortest(curve.gamma);
}

std::string curve_formula(const RgbCurve& curve) {
  if (!curve.is_exponent()) {
    return std::string(curve.function.formula) + " " + std::string(curve.function.source);
  }
  return "E = L^(1/" + shortest(curve.gamma) + "), odd below 0";
}

}  // namespace tristim
