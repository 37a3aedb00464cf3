#include "lib/dither/growth_rules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

using Step = PatternSequence::Step;

constexpr double kLinesShare = 0.75;
constexpr std::size_t kLeastDot = 8;  // cells of a dot that has others beside it
constexpr double kSameShare = 1e-9;   // rounding: of equal levels the first is told

struct Place {
  int x, y;
};

std::size_t cell_count(const PatternSequence& s) {
  return static_cast<std::size_t>(s.width) * static_cast<std::size_t>(s.height);
}

Place place_of(const PatternSequence& s, int cell) { return {cell % s.width, cell / s.width}; }

std::string place_text(const PatternSequence& s, int cell) {
  const Place at = place_of(s, cell);
  return "row " + std::to_string(at.y + 1) + ", column " + std::to_string(at.x + 1);
}

std::string level_text(std::size_t step) { return "level " + std::to_string(step + 1); }

// The four cells that share a side with one, on the torus. A cell of one row or column meets
// itself there.
std::array<int, 4> neighbours(const PatternSequence& s, int cell) {
  const auto [x, y] = place_of(s, cell);
  const int left = (x + s.width - 1) % s.width;
  const int right = (x + 1) % s.width;
  const int up = (y + s.height - 1) % s.height;
  const int down = (y + 1) % s.height;
  return {y * s.width + left, y * s.width + right, up * s.width + x, down * s.width + x};
}

// Which cells are lit, and in how many pieces.
class LitCells {
 public:
  explicit LitCells(const PatternSequence& sequence)
      : sequence_(&sequence), lit_(cell_count(sequence)), piece_(lit_.size()) {}

  void take(const Step& step) {
    for (const int cell : step.dark) lit_[static_cast<std::size_t>(cell)] = 0;
    if (!step.dark.empty()) join_again();  // pieces may have come apart
    for (const int cell : step.lit) join(cell);
  }

  bool touches_lit(int cell) const {
    const auto around = neighbours(*sequence_, cell);
    return std::any_of(around.begin(), around.end(),
                       [&](int other) { return other != cell && is_lit(other); });
  }

  bool is_lit(int cell) const { return lit_[static_cast<std::size_t>(cell)] != 0; }
  int pieces() const { return pieces_; }

 private:
  // Union of sets; paths are halved [Tarjan75].
  int root(int cell) {
    while (piece_[static_cast<std::size_t>(cell)] != cell) {
      int& up = piece_[static_cast<std::size_t>(cell)];
      up = piece_[static_cast<std::size_t>(up)];
      cell = up;
    }
    return cell;
  }

  void join(int cell) {
    lit_[static_cast<std::size_t>(cell)] = 1;
    piece_[static_cast<std::size_t>(cell)] = cell;
    ++pieces_;
    for (const int other : neighbours(*sequence_, cell)) {
      if (!is_lit(other)) continue;
      const int a = root(cell);
      const int b = root(other);
      if (a == b) continue;
      piece_[static_cast<std::size_t>(b)] = a;
      --pieces_;
    }
  }

  void join_again() {
    const std::vector<std::uint8_t> all = lit_;
    std::fill(lit_.begin(), lit_.end(), std::uint8_t{0});
    pieces_ = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i] != 0) join(static_cast<int>(i));
    }
  }

  const PatternSequence* sequence_;
  std::vector<std::uint8_t> lit_;
  std::vector<int> piece_;
  int pieces_ = 0;
};

bool touches_with_corners(const LitCells& lit, const PatternSequence& s, int cell) {
  const auto [x, y] = place_of(s, cell);
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const int column = (x + dx + s.width) % s.width;
      const int row = (y + dy + s.height) % s.height;
      if ((dx != 0 || dy != 0) && lit.is_lit(row * s.width + column)) return true;
    }
  }
  return false;
}

// Whether places repeat with the step from the first to any other: the dots of a screen.
bool is_lattice(const PatternSequence& s, const std::vector<int>& cells) {
  std::vector<std::uint8_t> taken(cell_count(s));
  for (const int cell : cells) taken[static_cast<std::size_t>(cell)] = 1;
  const Place first = place_of(s, cells.front());
  for (const int to : cells) {
    const Place other = place_of(s, to);
    for (const int cell : cells) {
      const Place from = place_of(s, cell);
      const int x = (from.x + other.x - first.x + s.width) % s.width;
      const int y = (from.y + other.y - first.y + s.height) % s.height;
      if (taken[static_cast<std::size_t>(y * s.width + x)] == 0) return false;
    }
  }
  return true;
}

// The dots of a cell: the first cells that are lit, as long as none touches another, where they are
// a lattice and have room to grow; else the first alone.
std::vector<int> first_dots(const PatternSequence& sequence) {
  const std::size_t most = std::max<std::size_t>(1, cell_count(sequence) / kLeastDot);
  std::vector<int> dots;
  LitCells lit(sequence);
  for (const Step& step : sequence.steps) {
    for (const int cell : step.lit) {
      const bool ends = lit.touches_lit(cell);
      if (!ends) dots.push_back(cell);
      if (!ends && dots.size() <= most) {
        lit.take({{cell}, {}});
        continue;
      }
      if (dots.size() > most || !is_lattice(sequence, dots)) dots.resize(1);
      return dots;
    }
  }
  return dots;
}

// How far a cell is from the nearest dot's centre, the short way round.
struct Reach {
  double distance;  // pixels
  double ring;      // the larger of both coordinates: squares around the centre
};

// `shift`: where in its pixel a dot's centre lies, -1/2 to 1/2.
Reach reach_of(const PatternSequence& s, const std::vector<int>& dots, double shift_x,
               double shift_y, int cell) {
  const auto short_way = [](double d, int size) {
    const double around = std::fabs(d);
    return std::min(around, size - around);
  };
  const Place at = place_of(s, cell);
  Reach nearest{1e30, 1e30};
  for (const int dot : dots) {
    const Place centre = place_of(s, dot);
    const double dx = short_way(at.x - centre.x - shift_x, s.width);
    const double dy = short_way(at.y - centre.y - shift_y, s.height);
    const double distance = std::sqrt(dx * dx + dy * dy);
    if (distance < nearest.distance) nearest = {distance, std::max(dx, dy)};
  }
  return nearest;
}

// The first cell that lies farther in than growth outward allows, as its place in the order of
// lighting; the number of cells where there is none.
std::size_t first_inward(const PatternSequence& s, const std::vector<int>& dots, double shift_x,
                         double shift_y) {
  Reach farthest{0, 0};
  bool by_distance = true;
  bool by_ring = true;
  std::size_t order = 0;
  for (const Step& step : s.steps) {
    Reach next = farthest;
    for (const int cell : step.lit) {
      const Reach reach = reach_of(s, dots, shift_x, shift_y, cell);
      by_distance = by_distance && reach.distance > farthest.distance - 1;
      by_ring = by_ring && reach.ring >= farthest.ring;
      if (!by_distance && !by_ring) return order;
      next = {std::max(next.distance, reach.distance), std::max(next.ring, reach.ring)};
      ++order;
    }
    farthest = next;
  }
  return order;
}

std::size_t lit_count(const PatternSequence& s) {
  std::size_t count = 0;
  for (const Step& step : s.steps) count += step.lit.size();
  return count;
}

struct Cell {
  std::size_t step;
  int cell;
};

Cell cell_in_order(const PatternSequence& s, std::size_t order) {
  for (std::size_t step = 0; step < s.steps.size(); ++step) {
    const auto& lit = s.steps[step].lit;
    if (order < lit.size()) return {step, lit[order]};
    order -= lit.size();
  }
  return {0, 0};
}

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

GrowthFinding judge_outward(const PatternSequence& sequence) {
  const std::vector<int> dots = first_dots(sequence);
  LitCells lit(sequence);
  std::size_t begun = 0;
  for (std::size_t step = 0; step < sequence.steps.size(); ++step) {
    for (const int cell : sequence.steps[step].lit) {
      if (begun++ >= dots.size() && !touches_with_corners(lit, sequence, cell)) {
        return {false,
                level_text(step) + " begins another dot at " + place_text(sequence, cell),
                {{"level", static_cast<double>(step + 1)}}};
      }
    }
    lit.take(sequence.steps[step]);
  }
  std::size_t outward = 0;
  for (const double x : {-0.5, 0.0, 0.5}) {
    for (const double y : {-0.5, 0.0, 0.5}) {
      outward = std::max(outward, first_inward(sequence, dots, x, y));
    }
  }
  if (outward < lit_count(sequence)) {
    const auto [step, cell] = cell_in_order(sequence, outward);
    return {false,
            level_text(step) + " goes back in at " + place_text(sequence, cell),
            {{"level", static_cast<double>(step + 1)}}};
  }
  const auto count = static_cast<double>(dots.size());
  return {true,
          dots.size() == 1 ? "from " + place_text(sequence, dots.front())
                           : std::to_string(dots.size()) + " dots a cell",
          {{"dots", count}}};
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
