#include "lib/dither/lit_cells.h"

#include <algorithm>
#include <array>

namespace tristim::detail {
namespace {

constexpr std::size_t kLeastDot = 8;  // cells of a dot that has others beside it

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

}  // namespace

std::size_t cell_count(const PatternSequence& s) {
  return static_cast<std::size_t>(s.width) * static_cast<std::size_t>(s.height);
}

Place place_of(const PatternSequence& s, int cell) { return {cell % s.width, cell / s.width}; }

std::string place_text(const PatternSequence& s, int cell) {
  const Place at = place_of(s, cell);
  return "row " + std::to_string(at.y + 1) + ", column " + std::to_string(at.x + 1);
}

std::string level_text(std::size_t step) { return "level " + std::to_string(step + 1); }

LitCells::LitCells(const PatternSequence& sequence)
    : sequence_(&sequence), lit_(cell_count(sequence)), piece_(lit_.size()) {}

void LitCells::take(const PatternSequence::Step& step) {
  for (const int cell : step.dark) lit_[static_cast<std::size_t>(cell)] = 0;
  if (!step.dark.empty()) join_again();  // pieces may have come apart
  for (const int cell : step.lit) join(cell);
}

bool LitCells::touches_lit(int cell) const {
  const auto around = neighbours(*sequence_, cell);
  return std::any_of(around.begin(), around.end(),
                     [&](int other) { return other != cell && is_lit(other); });
}

bool LitCells::touches_with_corners(int cell) const {
  const PatternSequence& s = *sequence_;
  const auto [x, y] = place_of(s, cell);
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const int column = (x + dx + s.width) % s.width;
      const int row = (y + dy + s.height) % s.height;
      if ((dx != 0 || dy != 0) && is_lit(row * s.width + column)) return true;
    }
  }
  return false;
}

// Union of sets; paths are halved [Tarjan75].
int LitCells::root(int cell) {
  while (piece_[static_cast<std::size_t>(cell)] != cell) {
    int& up = piece_[static_cast<std::size_t>(cell)];
    up = piece_[static_cast<std::size_t>(up)];
    cell = up;
  }
  return cell;
}

void LitCells::join(int cell) {
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

void LitCells::join_again() {
  const std::vector<std::uint8_t> all = lit_;
  std::fill(lit_.begin(), lit_.end(), std::uint8_t{0});
  pieces_ = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i] != 0) join(static_cast<int>(i));
  }
}

std::vector<int> first_dots(const PatternSequence& sequence) {
  const std::size_t most = std::max<std::size_t>(1, cell_count(sequence) / kLeastDot);
  std::vector<int> dots;
  LitCells lit(sequence);
  for (const PatternSequence::Step& step : sequence.steps) {
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

}  // namespace tristim::detail
