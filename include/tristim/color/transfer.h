#pragma once

#include <string_view>

namespace tristim {

/// Linear light to sRGB code [IEC61966]: 12.92 x up to 0.0031308, else 1.055 x^(1/2.4) - 0.055.
/// [0, 1] to [0, 1]; beyond 1 the formula goes on, below 0 it is odd.
double srgb_encode(double linear) noexcept;

/// The inverse of srgb_encode: e/12.92 up to 0.04045, else ((e + 0.055)/1.055)^2.4.
double srgb_decode(double encoded) noexcept;

/// Linear light to code by a pure exponent, x^(1/gamma); odd below 0. gamma > 0.
double gamma_encode(double linear, double gamma) noexcept;

/// Code to linear light by a pure exponent, x^gamma; odd below 0. gamma > 0.
double gamma_decode(double encoded, double gamma) noexcept;

/// EOTF of studio monitors [BT1886, annex 1] relative to the white: a max(V + b, 0)^2.4, with
/// `black` the luminance of black over that of white, [0, 1). Returns light relative to the white.
double bt1886_decode(double encoded, double black) noexcept;

/// The inverse of bt1886_decode for light of at least `black`; below it, 0.
double bt1886_encode(double linear, double black) noexcept;

/// A curve without parameters.
struct TransferFunction {
  std::string_view name;
  double (*encode)(double linear) noexcept;
  double (*decode)(double encoded) noexcept;
  std::string_view formula;
  std::string_view source;
};

inline constexpr TransferFunction kSrgbTransfer{
    "srgb", srgb_encode, srgb_decode, "E = 12.92 L up to .0031308, else 1.055 L^(1/2.4) - .055",
    "[IEC61966]"};

}  // namespace tristim
