#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tristim {

/// Light I = i0 + (1 - i0) K V^gamma, relative to the white [Shoaff 2.1.1]: V is the code, K =
/// Vmax^-gamma unless given, i0 the light of code 0.
struct GammaResponse {
  double gamma = 2.2;  // above 0
  double i0 = 0;       // [0, 1)
  double k = 0;        // above 0; 0: Vmax^-gamma
};

/// The curve of sRGB [IEC61966].
struct SrgbResponse {};

/// Light proportional to the code.
struct LinearResponse {};

/// BT.1886 with a black of `black` times the white's luminance, [0, 1) [BT1886].
struct Bt1886Response {
  double black = 0;
};

/// Gain, offset, gamma [Berns93]: I = black + (1 - black) max(gain V/Vmax + offset, 0)^gamma with
/// gain = 1 - offset, so that the white is 1. An offset below 0 leaves the lowest codes without
/// light of their own; `black` is light that no code takes away: leaks and reflections.
struct GogResponse {
  double gamma = 2.2;  // above 0
  double offset = 0;   // (-1, 1)
  double black = 0;    // [0, 1)
};

/// Measured: pairs of code and luminance (any unit), codes strictly ascending and luminances
/// nowhere falling; monotone_value joins them. The last is the white, above the first. Codes beyond
/// the ends have the end's light.
struct TableResponse {
  std::vector<double> code;
  std::vector<double> luminance;
  double code_max = 0;  // the highest code as `code` counts, where that is not the channel's; 0: is
};

/// How codes become light.
using Response = std::variant<SrgbResponse, LinearResponse, GammaResponse, Bt1886Response,
                              GogResponse, TableResponse>;

/// Light of a code in [0, code_max] relative to the white, [0, 1]; between codes too.
double light_of_code(const Response& response, double code, double code_max) noexcept;

/// The code, not rounded, whose light is `light`: the inverse of light_of_code, the lowest where
/// several have it. Light below that of code 0 gives 0 and above the white code_max.
double code_of_light(const Response& response, double light, double code_max) noexcept;

/// V = floor(code_of_light + 0.5), computed with more digits so that halves go up: light and the
/// figures of the response are read as decimals.
int nearest_code(const Response& response, double light, int code_max) noexcept;

/// Throws std::invalid_argument where a figure is outside of its range or a table is no response.
void check_response(const Response& response);

/// The name of the response's kind in device files: "gamma".
std::string_view kind_of(const Response& response) noexcept;

/// One line of formula with its numbers, for reports.
std::string describe(const Response& response);

}  // namespace tristim
