#include "tristim/device/level_report.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "lib/device/spacing.h"
#include "tristim/color/lab.h"

namespace tristim {
namespace {

double lstar_step(double lower, double upper) {
  return lstar_from_luminance(upper) - lstar_from_luminance(lower);
}

// The level nearest to the light of every code.
std::vector<int> levels_of_codes(const LevelTable& table, const Response& response, int code_max) {
  const detail::LevelPositions positions(table);
  std::vector<int> levels;
  for (int v = 0; v <= code_max; ++v) {
    levels.push_back(positions.nearest(light_of_code(response, v, code_max)));
  }
  return levels;
}

}  // namespace

std::vector<SharedRun> shared_runs(std::span<const int> values) {
  std::vector<SharedRun> runs;
  for (std::size_t first = 0; first < values.size();) {
    std::size_t end = first;
    while (end < values.size() && values[end] == values[first]) ++end;
    if (end - first > 1) {
      runs.push_back({static_cast<int>(first), static_cast<int>(end) - 1, values[first]});
    }
    first = end;
  }
  return runs;
}

int distinct_values(std::span<const int> values) noexcept {
  int distinct = values.empty() ? 0 : 1;
  for (std::size_t i = 1; i < values.size(); ++i) distinct += values[i] != values[i - 1] ? 1 : 0;
  return distinct;
}

LevelReport level_report(const LevelTable& table, const Response& response,
                         std::span<const int> codes, int code_max) {
  const std::vector<double> levels = intensity_levels(table);
  if (codes.size() != levels.size()) {
    throw std::invalid_argument("codes: there is not one for each level");
  }
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  LevelReport report;
  report.dynamic_range = levels[0] > 0 ? 1 / levels[0] : kInfinity;
  report.ratio = levels[0] > 0 ? levels[1] / levels[0] : kInfinity;
  report.distinct = distinct_values(codes);
  report.shared_codes = shared_runs(codes);
  report.dead_zones = shared_runs(levels_of_codes(table, response, code_max));
  for (std::size_t j = 1; j < levels.size(); ++j) {
    const double step = lstar_step(levels[j - 1], levels[j]);
    if (step > report.largest_lstar_step) {
      report.largest_lstar_step = step;
      report.largest_step_at = static_cast<int>(j);
    }
    const double shown = lstar_step(light_of_code(response, codes[j - 1], code_max),
                                    light_of_code(response, codes[j], code_max));
    report.largest_shown_lstar_step = std::max(report.largest_shown_lstar_step, shown);
  }
  return report;
}

}  // namespace tristim
