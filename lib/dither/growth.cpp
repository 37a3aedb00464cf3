#include "tristim/dither/growth.h"

#include <algorithm>
#include <stdexcept>

#include "lib/dither/growth_rules.h"

namespace tristim {
namespace {

constexpr GrowthGuideline kGuidelines[] = {
    {"growth", "A pixel lit at one level stays lit at every higher level.", detail::judge_sequence,
     "no pixel goes out from one level to the next"},
    {"outward", "Patterns grow outward from the centre, so that the dot's size grows.",
     detail::judge_outward,
     "every new pixel touches a dot, and is nearer to its centre than the farthest one before by "
     "less than a pixel, or no farther in by rings"},
    {"together", "All lit pixels touch, for devices that cannot hold isolated dots.",
     detail::judge_together,
     "tiled, and by shared sides: no more pieces than dots of a cell at any level"},
    {"lines", "No pattern shows lines of one direction.", detail::judge_lines,
     "share of a pattern's contrast in lines of a direction, less that of the direction across: "
     "below .75"},
};

}  // namespace

PatternSequence pattern_sequence(const ThresholdMatrix& matrix) {
  PatternSequence sequence{matrix.name, matrix.width, matrix.height, {}};
  sequence.steps.resize(static_cast<std::size_t>(matrix.ranks));
  int cell = 0;
  for (const std::uint16_t rank : matrix.rank) sequence.steps[rank].lit.push_back(cell++);
  return sequence;
}

PatternSequence pattern_sequence(std::string name, int width, int height,
                                 std::span<const std::vector<std::uint8_t>> patterns) {
  PatternSequence sequence{std::move(name), width, height, {}};
  const std::size_t cells = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::vector<std::uint8_t> before(cells, 0);
  for (const std::vector<std::uint8_t>& pattern : patterns) {
    if (pattern.size() != cells) {
      throw std::invalid_argument("patterns: " + std::to_string(pattern.size()) +
                                  " cells; expected " + std::to_string(cells) + " in each");
    }
    PatternSequence::Step step;
    for (std::size_t i = 0; i < cells; ++i) {
      if (pattern[i] == before[i]) continue;
      (pattern[i] != 0 ? step.lit : step.dark).push_back(static_cast<int>(i));
    }
    const bool is_level_0 =
        sequence.steps.empty() && &pattern == &patterns.front() && step.lit.empty();
    if (!is_level_0) sequence.steps.push_back(std::move(step));
    before = pattern;
  }
  return sequence;
}

std::span<const GrowthGuideline> growth_guidelines() noexcept { return kGuidelines; }

}  // namespace tristim
