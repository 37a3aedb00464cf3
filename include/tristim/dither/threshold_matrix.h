#pragma once

#include <array>
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

/// Dispersed, of side 2^k up to 256: D(2n) = [4 D(n), 4 D(n) + 2; 4 D(n) + 3, 4 D(n) + 1] from D(1)
/// = 0 [Bayer73].
ThresholdMatrix bayer_matrix(const MatrixParameters& parameters);

/// The document's 3 x 3 cell [6 8 4; 1 0 3; 5 2 7] [Shoaff 2.1.2].
ThresholdMatrix d3_matrix(const MatrixParameters& parameters);

/// A screen of two dots at 45 degrees in an 8 x 8 cell: highlights grow as round holes and shadows
/// as round dots from their centres, in pairs that differ by one step [Ulichney87 ch. 5].
ThresholdMatrix clustered_matrix(const MatrixParameters& parameters);

/// Every matrix. The command line, the docs and the property tests read this list.
inline constexpr std::array kMatrixRecipes{
    MatrixRecipe{"d2", 2, false, bayer_matrix, "[Shoaff 2.1.2] D2 = [0 2; 3 1]"},
    MatrixRecipe{"d3", 3, true, d3_matrix, "[Shoaff 2.1.2] D3 = [6 8 4; 1 0 3; 5 2 7]"},
    MatrixRecipe{"bayer2", 2, false, bayer_matrix, "[Bayer73]"},
    MatrixRecipe{"bayer4", 4, false, bayer_matrix, "[Bayer73]"},
    MatrixRecipe{"bayer8", 8, false, bayer_matrix, "[Bayer73]"},
    MatrixRecipe{"bayer16", 16, false, bayer_matrix, "[Bayer73]"},
    MatrixRecipe{"clustered8", 8, true, clustered_matrix,
                 "[Ulichney87 ch. 5], two dots at 45 degrees"},
};

/// The matrix of a recipe, with its name.
ThresholdMatrix make_matrix(const MatrixRecipe& recipe, MatrixParameters parameters = {});

}  // namespace tristim
