#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "tristim/device/response.h"

namespace tristim {

namespace detail {
struct SpacingCurve;
}

/// A rule by which levels lie between the lowest intensity and 1.
struct LevelSpacing {
  std::string_view name;
  std::string_view formula;  // of the quantity of which the steps are equal
  std::string_view source;
  const detail::SpacingCurve* curve;  // how the library computes it
};

/// Every spacing. `ratio` is the document's; `lstar`, `pq`, `srgb`, `gamma` and `bt1886` take equal
/// steps of that curve; `measured` equal steps of the codes of a measured response.
const std::vector<LevelSpacing>& level_spacings();

/// n + 1 intensity levels from `i0` to 1.
struct LevelTable {
  int n = 255;                            // 1 .. 65535
  double i0 = 0.02;                       // (0, 1)
  double gamma = 2.2;                     // of the spacing `gamma` alone
  const LevelSpacing* spacing = nullptr;  // nullptr: ratio
  double peak_cd_m2 = 10000;              // of the spacing `pq` alone: the luminance of intensity 1
  bool from_zero = false;                 // level 0 is no light, not i0; never for `ratio`
  std::optional<TableResponse> measured;  // of the spacing `measured` alone
};

/// The spacing of a table: ratio where it names none.
const LevelSpacing& spacing_of(const LevelTable& table);

/// The intensity of level 0: i0, or 0 where the table begins there.
double lowest_intensity(const LevelTable& table) noexcept;

/// The intensities of the levels, ascending from the lowest to 1 exactly, each formula rounded
/// once: I_j = I0^((n-j)/n) for equal ratios r = (1/I0)^(1/n) [Shoaff 2.1.1]. i0, gamma and peak
/// are read as decimals: .02 is 2/100. Throws std::invalid_argument where n is not in 1..65535, i0
/// not inside (0, 1), gamma or peak not above 0, a ratio begins at 0, or a measured response is
/// missing.
std::vector<double> intensity_levels(const LevelTable& table);

/// The level nearest to an intensity, j = floor(log_r(I/I0) + 0.5) clamped to 0..n [Shoaff 2.1.1];
/// other spacings take the nearest in the quantity of which their steps are equal. I <= 0 gives 0,
/// I > 1 gives n, NaN has none. Throws as intensity_levels does.
std::optional<int> nearest_level(double intensity, const LevelTable& table);

/// Where an intensity lies among the levels: 0 at I_0, n at the highest, and half way between two
/// whole numbers where another level becomes the nearest. Light beyond the levels lies beyond 0..n,
/// but light that is not above 0 at 0; NaN passes. Throws as intensity_levels does.
double level_position(double intensity, const LevelTable& table);

/// V_j, the codes that make the levels: V = floor((I_j/K)^(1/gamma) + 0.5) for a power [Shoaff
/// 2.1.1], and the inverse of any other response rounded half up, clamped to 0..code_max. I_j is
/// not rounded before. Throws as intensity_levels and check_response do, and where code_max is
/// below 1.
std::vector<int> level_codes(const LevelTable& table, const Response& response, int code_max);

}  // namespace tristim
