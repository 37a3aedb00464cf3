#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace tristim {

/// A rule by which levels lie between the lowest intensity and 1.
struct LevelSpacing {
  std::string_view name;
  double (*position)(double intensity, double gamma);  // the quantity of which the steps are equal
  double (*intensity)(double position, double gamma);
  std::string_view formula;
  std::string_view source;
};

/// Every spacing. `ratio` is the document's; the others take equal steps of L*, of the sRGB curve,
/// of intensity^(1/gamma).
const std::vector<LevelSpacing>& level_spacings();

/// n + 1 intensity levels from `i0` to 1.
struct LevelTable {
  int n = 255;                            // 1 .. 65535
  double i0 = 0.02;                       // (0, 1)
  double gamma = 2.2;                     // of the spacing `gamma` alone
  const LevelSpacing* spacing = nullptr;  // nullptr: ratio
};

/// The intensities of the levels, ascending from i0 to 1 exactly: I_j = I0^((n-j)/n) for equal
/// ratios r = (1/I0)^(1/n) [Shoaff 2.1.1]. Throws std::invalid_argument where n is below 1 or above
/// 65535, or i0 not inside (0, 1).
std::vector<double> intensity_levels(const LevelTable& table);

/// The level nearest to an intensity, j = floor(log_r(I/I0) + 0.5) clamped to 0..n [Shoaff 2.1.1];
/// other spacings take the nearest in the quantity of which their steps are equal. I <= 0 gives 0,
/// I > 1 gives n, NaN has none. Throws as intensity_levels does.
std::optional<int> nearest_level(double intensity, const LevelTable& table);

/// The codes that make the intensities, V = floor((I/K)^(1/gamma) + 0.5) clamped to 0..code_max
/// [Shoaff 2.1.1]. `k` 0 stands for code_max^-gamma. Throws std::invalid_argument for a gamma or
/// code_max that is not above 0.
std::vector<int> level_codes(const std::vector<double>& intensities, double gamma, int code_max,
                             double k = 0);

}  // namespace tristim
