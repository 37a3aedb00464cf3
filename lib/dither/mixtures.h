#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tristim/dither/palette.h"

namespace tristim::detail {

/// Up to four entries of a palette and how their shares follow from the colour that they mix.
struct Mixture {
  static constexpr std::size_t kParts = 4;

  /// By the factor, red, green, blue and 1, then by the part: shares of the entries, brightest
  /// first, and behind them what is given up of a colour that the entries do not mix. The sum of
  /// the entries' shares is 1; none is below 0 in the colours that the mixture is for.
  alignas(16) std::array<std::array<float, kParts>, kParts> share;
  std::array<std::uint16_t, kParts> entry;     // behind the last one: the last once more
  std::array<std::uint16_t, kParts + 1> next;  // the mixture where that share is below 0, or this
                                               // one where there is none and where none is
};

/// Of all mixtures of a palette's entries whose mean is a colour the one that strays least from it,
/// exactly.
///
/// How far an entry strays from a colour is a Bregman divergence in what the three cones see of
/// both, with the fourth root as its generator: the same dot is seen more beside a dark colour. Of
/// such a divergence the mixtures are the simplices of one triangulation of the palette, the same
/// for all colours [Boissonnat10]. A colour that the palette does not mix is moved on opponent
/// axes, at a price; in a palette chosen for a picture (Beyond::kDamped), one that it mixes by far
/// dots alone is as well, where that is seen less than the dots.
///
/// Simplices are found from each other by dual steps of linear programming, that of a colour by
/// walking to it. Nothing is written after construction: any number of threads may ask.
class Mixtures {
 public:
  using Color = MixPalette::Color;

  /// Palettes that have more entries or more simplices have no mixtures.
  static constexpr int kMostEntries = 1024;
  static constexpr std::size_t kMost = 65535;  // of 96 bytes

  explicit Mixtures(const MixPalette& palette);

  bool known() const noexcept { return !list_.empty(); }

  /// What a pixel of a colour, in the numbers of the mix, becomes: the brightest entry where its
  /// share reaches `threshold`, (0, 1), else the next one where theirs together do, and so on.
  std::uint16_t entry(const Color& color, float threshold) const noexcept;

  /// The same of pixels side by side, in vectors; `planes` are their colours.
  void entry_row(const std::array<const float*, 3>& planes, const float* thresholds,
                 std::span<std::uint16_t> indices) const noexcept;

  const std::vector<Mixture>& list() const noexcept { return list_; }

  static constexpr int kSide = 48;  // cells, in each number

  /// Where the walk to a colour in a cell begins; cells are equal steps of the square root.
  const std::vector<std::uint16_t>& start() const noexcept { return start_; }

  /// A share so far below 0 is 0 still: what floats leave.
  static constexpr float kRounding = 1e-6F;
  /// No walk is longer: rounding cannot send it round for ever.
  static constexpr int kMostSteps = 256;

 private:
  using Shares = std::array<float, Mixture::kParts>;
  std::size_t walk(const Color& color, std::size_t from, Shares& shares) const noexcept;

  std::vector<Mixture> list_;
  std::vector<std::uint16_t> start_;
};

}  // namespace tristim::detail
