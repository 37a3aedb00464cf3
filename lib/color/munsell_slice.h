#pragma once

#include <optional>

#include "lib/color/munsell_table.h"

namespace tristim::detail {

/// A place on a chart, in columns and rings: column 6.5 is half way from column 6 to 7, ring 0 is
/// neutral, 1 is chroma 2. Both from 0.
struct ChartPlace {
  double column = 0, ring = 0;
};

/// The chart of any value: a mixture of the planes of the table below and above it.
class MunsellSlice {
 public:
  /// `value` in [0, 10] and its luminance.
  MunsellSlice(double value, double luminance);

  /// x and y; nothing outside of the table.
  std::optional<Eigen::Vector2d> position(const ChartPlace& place) const noexcept;

  /// The place that has this position; nothing outside of the table. Not for illuminant C itself.
  std::optional<ChartPlace> locate(const Eigen::Vector2d& position) const noexcept;

  /// Whether all cells of the table around a place are real colours.
  bool is_real(const ChartPlace& place) const noexcept;

  /// How many rings there are between a column and the next: ring 0 to this.
  int cell_rings(int column) const noexcept;

  /// How many rings a column has.
  int rings(int column) const noexcept;

 private:
  struct Cell {
    int column, ring;  // between columns `column` and the next, rings `ring` and the next
    double u, s;       // of the way along the ovoids, and from the inner to the outer one
  };

  static bool is_still(const Cell& before, const Cell& after) noexcept;
  CurvePoint arc(int column, int ring, double u) const noexcept;
  Cell start(const Eigen::Vector2d& offset) const noexcept;
  bool step(Cell& cell, const Eigen::Vector2d& position) const noexcept;
  bool step_at_center(Cell& cell, const Eigen::Vector2d& position) const noexcept;
  void settle(Cell& cell) const noexcept;
  std::optional<Cell> walk(const Eigen::Vector2d& position) const noexcept;
  std::optional<Cell> search(const Eigen::Vector2d& position) const noexcept;

  const MunsellPlane* low_;
  const MunsellPlane* high_;
  double weight_ = 0;  // of high_
};

}  // namespace tristim::detail
