#pragma once

#include <span>
#include <vector>

#include "tristim/device/levels.h"

namespace tristim {

/// Neighbours `first` .. `last` that come to one and the same `shared`.
struct SharedRun {
  int first = 0, last = 0;
  int shared = 0;
  int count() const noexcept { return last - first + 1; }
  friend constexpr bool operator==(const SharedRun&, const SharedRun&) = default;
};

/// The runs of two or more equal neighbours of a list.
std::vector<SharedRun> shared_runs(std::span<const int> values);

/// How many different values a list has whose equals are neighbours.
int distinct_values(std::span<const int> values) noexcept;

/// What a table of codes makes of its levels.
struct LevelReport {
  double dynamic_range = 0;             // 1/I_0; infinite where level 0 is no light
  double ratio = 0;                     // I_1/I_0, of a ratio table the same for all
  int distinct = 0;                     // levels left once those that share a code are one
  std::vector<SharedRun> shared_codes;  // levels that share a code
  std::vector<SharedRun> dead_zones;    // codes that give the same level: the nearest
  double largest_lstar_step = 0;        // between neighbouring levels as asked for
  int largest_step_at = 0;              // the upper level of that step
  double largest_shown_lstar_step = 0;  // between neighbouring levels as the codes show them
};

/// `codes` are V_j of each level of `table` on a channel with that response. Throws as
/// intensity_levels does, and where there is not one code for each level.
LevelReport level_report(const LevelTable& table, const Response& response,
                         std::span<const int> codes, int code_max);

}  // namespace tristim
