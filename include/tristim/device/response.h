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

/// Measured: pairs of code and luminance (any unit), both strictly ascending, joined by straight
/// lines; the last is the white. Codes beyond the ends have the end's light.
struct TableResponse {
  std::vector<double> code;
  std::vector<double> luminance;
};

/// How codes become light.
using Response =
    std::variant<SrgbResponse, LinearResponse, GammaResponse, Bt1886Response, TableResponse>;

/// Light of a code in [0, code_max] relative to the white, [0, 1]; between codes too.
double light_of_code(const Response& response, double code, double code_max) noexcept;

/// The code, not rounded, whose light is `light`: the inverse of light_of_code. Light below that of
/// code 0 gives 0 and above the white code_max.
double code_of_light(const Response& response, double light, double code_max) noexcept;

/// One line of formula with its numbers, for reports.
std::string describe(const Response& response);

}  // namespace tristim
