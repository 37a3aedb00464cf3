#include "tristim/device/levels.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "lib/device/precise_response.h"
#include "lib/device/spacing.h"

namespace tristim {

std::vector<double> intensity_levels(const LevelTable& table) {
  const detail::LevelPositions positions(table);
  std::vector<double> levels;
  for (int j = 0; j <= table.n; ++j) levels.push_back(positions.intensity(j).value());
  levels.front() = lowest_intensity(table);
  return levels;
}

std::optional<int> nearest_level(double intensity, const LevelTable& table) {
  const detail::LevelPositions positions(table);
  if (std::isnan(intensity)) return std::nullopt;
  return positions.nearest(intensity);
}

double level_position(double intensity, const LevelTable& table) {
  const detail::LevelPositions positions(table);
  if (std::isnan(intensity)) return intensity;
  return intensity > 0 ? positions.position(intensity).value() : 0;
}

std::vector<int> level_codes(const LevelTable& table, const Response& response, int code_max) {
  if (code_max < 1) {
    throw std::invalid_argument("Vmax: " + std::to_string(code_max) + " is not above 0");
  }
  check_response(response);
  const detail::LevelPositions positions(table);
  std::vector<int> codes;
  for (int j = 0; j <= table.n; ++j) {
    codes.push_back(detail::nearest_code(response, positions.intensity(j), code_max));
  }
  return codes;
}

}  // namespace tristim
