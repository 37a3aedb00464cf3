#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "tristim/palette/histogram.h"
#include "tristim/palette/metric.h"

namespace tristim {

namespace detail {
struct ColorCells;
}

/// Pictures of 8-bit codes to positions in a palette: the nearest entry in a metric, exactly, of
/// equally near ones the first. Each colour of the picture is looked for once, among the entries
/// that can be nearest to its neighbours too, and each pixel then looked up.
class PaletteMap {
 public:
  /// For pictures whose colours `histogram` counted, with a palette of 1 to 65536 colours. Entries
  /// of alpha 0 are found by colours of alpha 0 alone. Throws std::invalid_argument for other
  /// sizes.
  PaletteMap(const Histogram& histogram, std::span<const Color8> palette, const Metric& metric);
  /// Likewise for colours whose places in the metric are known.
  PaletteMap(std::span<const Color8> palette, const Metric& metric,
             const detail::ColorCells& cells);

  /// `codes` has three channels, or four with alpha; `positions` one, and the same size; both on
  /// any thread. Throws std::invalid_argument for other shapes; a colour that the histogram does
  /// not hold gives position 0.
  void map(ImageView<const std::uint8_t> codes, ImageView<std::uint16_t> positions) const;

  /// The position of one colour; 0 where the histogram does not hold it.
  std::uint16_t position(Color8 color) const noexcept;

 private:
  using Block = std::array<std::uint16_t, 64>;  // of a cell of 4 x 4 x 4 colours

  template <int kChannels>
  void map_row(const std::uint8_t* codes, std::span<std::uint16_t> positions) const noexcept;

  std::vector<std::uint32_t> directory_;  // of each cell the number of its block; 0: all zeros
  std::vector<Block> blocks_;
  std::unordered_map<std::uint32_t, std::uint16_t> translucent_;
};

}  // namespace tristim
