#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tristim/dither/palette.h"

namespace tristim::detail {

/// The nearest entry of a palette where a metric places colours, exactly; of several the first.
/// A grid over the places knows for each of its cells the entries that can be nearest in it.
///
/// The grid reaches as far as errors may push a colour, with wider cells beyond the palette; places
/// outside of it are moved to its rim first. May be asked by several threads.
class EntryGrid {
 public:
  explicit EntryGrid(const MixPalette& palette);

  /// The entry nearest to `color`, in the numbers of the mix.
  int nearest(const MixPalette::Color& color) const noexcept;

  /// Where the metric places a colour: of Oklab with a toe by the floats of oklab_toe.h.
  MixPalette::Color place(const MixPalette::Color& color) const noexcept;

  /// Whether places are those of oklab_toe.h, so that vectors can take them.
  bool toe() const noexcept { return toe_; }

  static constexpr int kSide = 32;  // cells of all zones

  static constexpr int kZones = 3;
  static constexpr std::array<int, kZones> kCells{4, 24, 4};  // of a side: below, among, above

  /// A zone reaches from knot[i] to knot[i + 1]; a place counts the cells that it has behind it in
  /// each of them.
  struct Axis {
    std::array<float, kZones + 1> knot{};
    std::array<float, kZones> cells_per_unit{};
    std::vector<float> place;  // of the entries
  };
  const std::array<Axis, 3>& axes() const noexcept { return axes_; }

  /// By cell, the last axis fastest: where its entries begin in the list, and how many they are.
  const std::vector<std::int32_t>& first() const noexcept { return first_; }
  const std::vector<std::int32_t>& count() const noexcept { return count_; }
  const std::vector<std::int32_t>& list() const noexcept { return list_; }

 private:
  using Entries = std::vector<std::int32_t>;
  struct Box {
    std::array<float, 3> middle, reach;  // reach: half of a side
  };
  Box box(const std::array<int, 3>& cell, int cells) const noexcept;  // so many cells a side
  void set_knots();
  Entries possible(const Box& box, const Entries& among) const;

  const MixPalette* palette_;
  bool toe_;
  std::array<Axis, 3> axes_;
  std::vector<std::int32_t> first_, count_, list_;
};

}  // namespace tristim::detail
