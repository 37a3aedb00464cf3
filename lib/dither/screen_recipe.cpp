#include "tristim/dither/screen_recipe.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>

namespace tristim {
namespace {

constexpr double kUsualDpi = 600;
constexpr double kLeastUsualStep = 4;  // dots from one row of cells at 45 degrees to the next
constexpr double kMostUsualLpi = 150;
constexpr double kUsualAngles[] = {15, 75, 0, 45};
constexpr double kNextAngles = 22.5;

}  // namespace

double usual_lpi(double dpi) noexcept {
  const double side_of_step = std::sqrt(2.0);
  const double step = std::ceil(dpi / (kMostUsualLpi * side_of_step));
  return dpi / (std::max(step, kLeastUsualStep) * side_of_step);
}

std::vector<double> usual_angles(int channels) {
  if (channels == 1) return {45};
  std::vector<double> angles;
  for (std::size_t i = 0; i < static_cast<std::size_t>(channels); ++i) {
    const std::size_t round = i / std::size(kUsualAngles);
    angles.push_back(kUsualAngles[i % std::size(kUsualAngles)] +
                     kNextAngles * static_cast<double>(round));
  }
  return angles;
}

Screen screen_of(const ScreenRecipe& recipe, const ScreenParameters& parameters, int channel,
                 int channels) {
  const std::vector<double> angles =
      parameters.angles_deg.empty() ? usual_angles(channels) : parameters.angles_deg;
  if (angles.size() != 1 && angles.size() != static_cast<std::size_t>(channels)) {
    throw std::invalid_argument("screen: " + std::to_string(angles.size()) + " angles for " +
                                std::to_string(channels) + " channels; give one for each, or one");
  }
  Screen screen;
  screen.dpi = parameters.dpi > 0 ? parameters.dpi : kUsualDpi;
  screen.lpi = parameters.lpi > 0 ? parameters.lpi : usual_lpi(screen.dpi);
  screen.angle_deg = angles.size() == 1 ? angles[0] : angles[static_cast<std::size_t>(channel)];
  if (parameters.spot) screen.spot = *parameters.spot;
  screen.single_cell = parameters.single_cell;
  screen.smallest_dot = parameters.smallest_dot;
  if (screen.smallest_dot == 0) {
    const int quarter = static_cast<int>(reach(screen).cell_dots() / 4);
    screen.smallest_dot = std::clamp(quarter, 1, recipe.smallest_dot);
  }
  return screen;
}

std::vector<ThresholdMatrix> screen_matrices(const ScreenRecipe& recipe,
                                             const ScreenParameters& parameters, int channels) {
  std::vector<ThresholdMatrix> matrices;
  for (int channel = 0; channel < channels; ++channel) {
    matrices.push_back(screen_matrix(screen_of(recipe, parameters, channel, channels)));
  }
  return matrices;
}

}  // namespace tristim
