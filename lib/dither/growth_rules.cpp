#include "lib/dither/growth_rules.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "lib/dither/lit_cells.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

using Step = PatternSequence::Step;

constexpr double kLinesShare = 0.75;
constexpr double kSameShare = 1e-9;  // rounding: of equal levels the first is told

// Sums of lit cells along parallel lines of a torus.
class LineSums {
 public:
  LineSums(int lines, std::size_t cells) : sum_(static_cast<std::size_t>(lines)), cells_(cells) {}

  void add(int line, int change) {
    double& sum = sum_[static_cast<std::size_t>(line)];
    squares_ += change * (2 * sum + change);
    sum += change;
    total_ += change;
  }

  // The part of the pattern's variance that lies between lines: 1 where each is all lit or dark.
  double share() const {
    const auto n = static_cast<double>(cells_);
    const double mean = total_ / n;
    const double variance = n * mean * (1 - mean);
    if (!(variance > 0)) return 0;
    const double length = n / static_cast<double>(sum_.size());
    return (squares_ / length - n * mean * mean) / variance;
  }

 private:
  std::vector<double> sum_;
  std::size_t cells_;
  double squares_ = 0, total_ = 0;
};

constexpr std::string_view kDirections[] = {"horizontal", "vertical", "falling diagonal",
                                            "rising diagonal"};

}  // namespace

GrowthFinding judge_sequence(const PatternSequence& sequence) {
  for (std::size_t step = 0; step < sequence.steps.size(); ++step) {
    const Step& change = sequence.steps[step];
    if (change.dark.empty()) continue;
    return {false,
            level_text(step) + " puts out " + place_text(sequence, change.dark.front()) +
                ", which is lit at level " + std::to_string(step),
            {{"level", static_cast<double>(step + 1)}}};
  }
  const std::string levels = std::to_string(sequence.steps.size() + 1);
  return {true, levels + " levels, each keeps the pixels of the one before", {}};
}

GrowthFinding judge_together(const PatternSequence& sequence) {
  const std::vector<int> dots = first_dots(sequence);
  const int allowed = std::max(1, static_cast<int>(dots.size()));
  LitCells lit(sequence);
  GrowthFinding finding{true, "", {}};
  int most = 0;
  for (std::size_t step = 0; step < sequence.steps.size(); ++step) {
    lit.take(sequence.steps[step]);
    most = std::max(most, lit.pieces());
    if (lit.pieces() <= allowed || !finding.holds) continue;
    finding = {false,
               level_text(step) + " is in " + std::to_string(lit.pieces()) + " pieces",
               {{"level", static_cast<double>(step + 1)}}};
  }
  finding.measures.emplace_back("pieces", most);
  if (finding.holds) {
    finding.text = allowed == 1 ? "one piece at every level"
                                : std::to_string(allowed) + " dots a cell, each in one piece";
  }
  return finding;
}

GrowthFinding judge_lines(const PatternSequence& sequence) {
  const std::size_t cells = cell_count(sequence);
  const int diagonals = std::gcd(sequence.width, sequence.height);
  std::array<LineSums, 4> lines{LineSums(sequence.height, cells), LineSums(sequence.width, cells),
                                LineSums(diagonals, cells), LineSums(diagonals, cells)};
  const auto change = [&](int cell, int by) {
    const auto [x, y] = place_of(sequence, cell);
    lines[0].add(y, by);
    lines[1].add(x, by);
    lines[2].add((x + sequence.height - y) % diagonals, by);  // height is a multiple
    lines[3].add((x + y) % diagonals, by);
  };
  double worst = 0;
  std::size_t worst_step = 0;
  std::size_t worst_direction = 0;
  for (std::size_t step = 0; step < sequence.steps.size(); ++step) {
    for (const int cell : sequence.steps[step].lit) change(cell, 1);
    for (const int cell : sequence.steps[step].dark) change(cell, -1);
    for (std::size_t d = 0; d < lines.size(); ++d) {
      const double excess = lines[d].share() - lines[d ^ 1].share();
      if (excess <= worst + kSameShare) continue;
      worst = excess;
      worst_step = step;
      worst_direction = d;
    }
  }
  if (worst == 0) return {true, "no direction at any level", {{"share", 0}}};
  return {worst < kLinesShare,
          "strongest " + std::string(kDirections[worst_direction]) + ": " +
              rounded(100 * worst, 3) + " % of the contrast at " + level_text(worst_step),
          {{"share", worst}, {"level", static_cast<double>(worst_step + 1)}}};
}

}  // namespace tristim::detail
