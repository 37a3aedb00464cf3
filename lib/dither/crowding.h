#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "lib/dither/tournament.h"

namespace tristim::detail {

/// A stack of slices, each of which tiles the plane, and the stack itself repeats in time.
struct Torus {
  int width = 1, height = 1, slices = 1;
  std::size_t cells() const noexcept {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
           static_cast<std::size_t>(slices);
  }
  friend constexpr bool operator==(const Torus&, const Torus&) = default;
};

/// Dots on a torus, and how crowded each of its cells is: the sum of a Gaussian around every dot of
/// the same slice [Ulichney93], and of one along time at the dot's own place in the other slices
/// [Wolfe22].
///
/// In whole numbers, so that sums do not depend on the order of their terms, nor on the processor.
class Crowding {
 public:
  /// No dots yet. `sigma` in cells. Where two cells are alike `chance` decides: a small number for
  /// each cell, below kChances.
  Crowding(const Torus& torus, double sigma, const std::vector<std::int32_t>& chance);

  static constexpr std::int32_t kChances = 1024;

  void put(std::size_t cell);   // a cell without a dot
  void take(std::size_t cell);  // a cell with one
  bool has_dot(std::size_t cell) const noexcept { return crowding_[cell] >= 0; }

  /// The most crowded dot: the tightest cluster. There is a dot.
  std::size_t tightest_cluster() { return greatest_.best(); }

  /// The least crowded cell without a dot: the largest void. There is one.
  std::size_t largest_void() { return least_.best(); }

 private:
  // Cells without a dot lie below all others, by more than any crowding.
  static constexpr std::int32_t kNoDot = std::numeric_limits<std::int32_t>::min();

  // A Gaussian on a ring of cells, cut where it no longer counts.
  struct Bell {
    int first = 0;  // offset of the first weight
    std::vector<double> weight;
  };
  static Bell bell(int ring, double sigma);

  template <typename Add>
  void change(std::size_t cell, Add add);

  Torus torus_;
  Bell across_, down_, along_;
  std::vector<std::int32_t> plane_;  // of a dot's slice: rows of across_ for each of down_
  std::vector<std::int32_t> time_;   // of the other slices: for each of along_
  std::vector<std::int32_t> crowding_;
  GreatestOf greatest_;
  LeastOf least_;
};

}  // namespace tristim::detail
