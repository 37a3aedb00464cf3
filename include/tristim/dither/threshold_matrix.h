#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tristim {

/// Ranks that tile the picture from its top left pixel. A pixel of tone I is lit where
/// S > rank[y mod height][x mod width], S = floor(I ranks + 1/2) [Shoaff 2.1.2].
///
/// Every rank from 0 to ranks - 1 occurs equally often, or once more: ranks is width x height, but
/// at most 65536.
struct ThresholdMatrix {
  std::string name;
  std::string source;
  int width = 0, height = 0;
  int ranks = 0;
  std::vector<std::uint16_t> rank;  // rows from y
  int shift = 0;  // dots by which every row of tiles lies to the right of the one above, [0, width)

  const std::uint16_t* row(int y) const noexcept {
    return rank.data() + static_cast<std::ptrdiff_t>(y % height) * width;
  }

  /// The place in row(y) of the picture's first pixel of row y >= 0; what follows goes on from the
  /// start of the row when it has reached its end.
  int column(int y) const noexcept {
    if (shift == 0) return 0;
    const long long right = static_cast<long long>(y / height) * shift % width;
    return right == 0 ? 0 : static_cast<int>(width - right);
  }
};

/// What the maker of a matrix may be told.
struct MatrixParameters {
  int size = 0;              // side of the tile; 0: the recipe's own
  std::uint64_t seed = 0;    // of what is made by chance
  int channel = 0;           // 0 .. 3, for matrices that differ from channel to channel
  std::optional<int> frame;  // of an animation, for matrices that change with time
};

/// How a matrix is made.
struct MatrixRecipe {
  std::string_view name;
  int size;        // of its own
  bool clustered;  // its dots grow together: for devices that cannot hold isolated dots
  ThresholdMatrix (*make)(const MatrixParameters& parameters);  // the size is given
  std::string_view source;
  bool sizes = false;       // it can be made in other sizes
  bool by_channel = false;  // colour devices get one for each channel
  bool by_frame = false;    // it changes with time
};

}  // namespace tristim
