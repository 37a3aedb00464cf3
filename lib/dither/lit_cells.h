#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tristim/dither/growth.h"

namespace tristim::detail {

/// A cell's column and row in its pattern.
struct Place {
  int x, y;
};

std::size_t cell_count(const PatternSequence& s);
Place place_of(const PatternSequence& s, int cell);

/// "row 2, column 1" and "level 3", as people count: steps[2] makes level 3.
std::string place_text(const PatternSequence& s, int cell);
std::string level_text(std::size_t step);

/// Which cells of a sequence are lit, and in how many pieces by shared sides, on the torus.
class LitCells {
 public:
  explicit LitCells(const PatternSequence& sequence);

  void take(const PatternSequence::Step& step);

  bool is_lit(int cell) const { return lit_[static_cast<std::size_t>(cell)] != 0; }
  int pieces() const { return pieces_; }

  /// Whether another lit cell shares a side with a cell; a side or a corner.
  bool touches_lit(int cell) const;
  bool touches_with_corners(int cell) const;

 private:
  int root(int cell);
  void join(int cell);
  void join_again();

  const PatternSequence* sequence_;  // outlives this
  std::vector<std::uint8_t> lit_;
  std::vector<int> piece_;  // for each lit cell another one of its piece; the root itself
  int pieces_ = 0;
};

/// The dots of a cell: the first cells that are lit, as long as none touches another, where they
/// are a lattice and have room to grow; else the first alone.
std::vector<int> first_dots(const PatternSequence& sequence);

}  // namespace tristim::detail
