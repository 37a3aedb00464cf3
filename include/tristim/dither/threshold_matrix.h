#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace tristim {

/// A square of ranks, 0 to size^2 - 1, each once, that tiles the picture from its top left pixel. A
/// pixel of tone I is lit where S > rank[y mod size][x mod size], S = floor(I size^2 + 1/2)
/// [Shoaff 2.1.2].
struct ThresholdMatrix {
  std::string_view name;
  int size = 0;
  std::vector<std::uint16_t> rank;  // rows from y
};

/// How a matrix of a size is made.
struct MatrixRecipe {
  std::string_view name;
  int size;
  bool clustered;  // its dots grow together: for devices that cannot hold isolated dots
  std::uint16_t (*rank)(int x, int y, int size);
  std::string_view source;
};

/// Ranks of a dispersed matrix of side 2^k: D(2n) = [4 D(n), 4 D(n) + 2; 4 D(n) + 3, 4 D(n) + 1]
/// from D(1) = 0 [Bayer73].
std::uint16_t bayer_rank(int x, int y, int size) noexcept;

/// Ranks of the document's 3 x 3 cell [6 8 4; 1 0 3; 5 2 7] [Shoaff 2.1.2].
std::uint16_t d3_rank(int x, int y, int size) noexcept;

/// Ranks of a screen of two dots at 45 degrees in an 8 x 8 cell: highlights grow as round holes and
/// shadows as round dots from their centres, in pairs that differ by one step [Ulichney87 ch. 5].
std::uint16_t clustered_rank(int x, int y, int size) noexcept;

/// Every matrix. The command line, the docs and the property tests read this list.
inline constexpr std::array kMatrixRecipes{
    MatrixRecipe{"d2", 2, false, bayer_rank, "[Shoaff 2.1.2] D2 = [0 2; 3 1]"},
    MatrixRecipe{"d3", 3, true, d3_rank, "[Shoaff 2.1.2] D3 = [6 8 4; 1 0 3; 5 2 7]"},
    MatrixRecipe{"bayer2", 2, false, bayer_rank, "[Bayer73]"},
    MatrixRecipe{"bayer4", 4, false, bayer_rank, "[Bayer73]"},
    MatrixRecipe{"bayer8", 8, false, bayer_rank, "[Bayer73]"},
    MatrixRecipe{"bayer16", 16, false, bayer_rank, "[Bayer73]"},
    MatrixRecipe{"clustered8", 8, true, clustered_rank,
                 "[Ulichney87 ch. 5], two dots at 45 degrees"},
};

ThresholdMatrix make_matrix(const MatrixRecipe& recipe);

}  // namespace tristim
