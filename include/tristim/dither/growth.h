#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tristim/dither/threshold_matrix.h"

namespace tristim {

/// Patterns of growing intensity of one cell that tiles the plane: what a threshold matrix stands
/// for, or a list of any patterns.
struct PatternSequence {
  /// Cells, counted in reading order, that come and go from one level to the next.
  struct Step {
    std::vector<int> lit, dark;
  };
  std::string name;
  int width = 0, height = 0;
  std::vector<Step> steps;  // steps[j] makes level j + 1; at level 0 all is dark
};

/// The levels 1, 2, ... of a matrix.
PatternSequence pattern_sequence(const ThresholdMatrix& matrix);

/// Patterns for the levels 0, 1, ...: rows of 1 (lit) and 0, all of one size. Where the first one
/// has lit cells it is taken for level 1.
PatternSequence pattern_sequence(std::string name, int width, int height,
                                 std::span<const std::vector<std::uint8_t>> patterns);

/// What a guideline says about patterns.
struct GrowthFinding {
  bool holds = false;
  std::string text;                                      // what was found, and where
  std::vector<std::pair<std::string, double>> measures;  // by name
};

/// One of the guidelines for halftone patterns [Shoaff 2.1.2].
struct GrowthGuideline {
  std::string_view name;
  std::string_view text;
  GrowthFinding (*judge)(const PatternSequence& sequence);
  std::string_view measure;  // how it is judged
};

/// All of them. The command line, the docs and the tests read this list.
std::span<const GrowthGuideline> growth_guidelines() noexcept;

}  // namespace tristim
