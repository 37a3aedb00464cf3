#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "tristim/dither/screen.h"

namespace tristim {

/// What screens may be told; what is not given comes from the device, or is what printers use.
struct ScreenParameters {
  double dpi = 0;                  // of the device; 0: 600
  double lpi = 0;                  // 0: usual_lpi()
  std::vector<double> angles_deg;  // by channel, or one for all; empty: usual_angles()
  std::optional<Spot> spot;        // empty: euclidean
  int smallest_dot = 0;            // 0: the recipe's
  bool single_cell = false;        // as of Screen
};

/// A screen as a dither.
struct ScreenRecipe {
  std::string_view name;
  int smallest_dot;  // as far as a quarter of a cell allows it
  std::string_view source;
};

/// Every kind of screen. The command line, the docs and the property tests read this list.
inline constexpr std::array kScreenRecipes{
    ScreenRecipe{"screen", 1, "dots that grow, at --lpi, --angle, with --spot [Kang99]"},
    ScreenRecipe{"hybrid-screen", 4,
                 "a screen whose smallest dots and holes are dispersed [Kang99]"},
};

/// What laser printers and imagesetters use: the finest up to 150 lpi whose cells at 45 degrees lie
/// on whole dots, 4 or more from one row of cells to the next. 53 lpi at 300 dpi, 106 at 600, 141
/// at 1200 and 2400.
double usual_lpi(double dpi) noexcept;

/// 45 degrees for one channel; 15, 75, 0 and 45 for cyan or red, magenta or green, yellow or blue,
/// black; from the fifth on 22.5 degrees more than the fourth before.
std::vector<double> usual_angles(int channels);

/// The screen of a channel.
Screen screen_of(const ScreenRecipe& recipe, const ScreenParameters& parameters, int channel,
                 int channels);

/// The matrix of each channel. Throws std::invalid_argument as screen_matrix() does, and where the
/// number of angles is neither one nor that of the channels.
std::vector<ThresholdMatrix> screen_matrices(const ScreenRecipe& recipe,
                                             const ScreenParameters& parameters, int channels);

}  // namespace tristim
