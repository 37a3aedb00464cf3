#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "tristim/dither/threshold_matrix.h"

namespace tristim {

// Makers of matrices. They heed the size that they are given and throw std::invalid_argument for
// one that they cannot make.

/// Dispersed, of side 2^k up to 256: D(2n) = [4 D(n), 4 D(n) + 2; 4 D(n) + 3, 4 D(n) + 1] from D(1)
/// = 0 [Bayer73].
ThresholdMatrix bayer_matrix(const MatrixParameters& parameters);

/// The document's 3 x 3 cell [6 8 4; 1 0 3; 5 2 7] [Shoaff 2.1.2].
ThresholdMatrix d3_matrix(const MatrixParameters& parameters);

/// A magic square of side 1 or 3 to 256: rows, columns and both diagonals have one sum, so that no
/// part of the cell is brighter than another. Odd sides by de la Loubere's rule, multiples of 4 by
/// turning the diagonals over, the others by Conway's LUX [Weisstein].
ThresholdMatrix magic_square_matrix(const MatrixParameters& parameters);

/// One dot that grows along a square spiral from the middle of a cell of 1 to 256 a side
/// [Ulichney87 ch. 5]: every level is in one piece.
ThresholdMatrix spiral_matrix(const MatrixParameters& parameters);

/// A screen of two dots at 45 degrees in a cell of even side, 2 to 256, that grow alike as round
/// dots from their centres, in pairs of ranks [Ulichney87 ch. 5]. From half tone on the dots touch
/// and what is left are round holes.
ThresholdMatrix clustered_matrix(const MatrixParameters& parameters);

/// Blue noise by void-and-cluster [Ulichney93], 1 to kMostBlueNoise a side: every level is as even
/// as it can be and has no direction, which the eye takes for a flat tone. Differs by seed and by
/// channel (the same mask begun elsewhere: not correlated).
///
/// 128 x 128 with seed 0 is built in. With a frame it is slice `frame` modulo kBlueNoiseFrames of a
/// stack that is blue in every slice and, at every pixel, along time [Wolfe22].
ThresholdMatrix blue_noise_matrix(const MatrixParameters& parameters);
inline constexpr int kMostBlueNoise = 1024;
inline constexpr int kBlueNoiseFrames = 16;

/// Every matrix. The command line, the docs and the property tests read this list.
inline constexpr std::array kMatrixRecipes{
    MatrixRecipe{"d2", 2, false, bayer_matrix, "[Shoaff 2.1.2] D2 = [0 2; 3 1]"},
    MatrixRecipe{"d3", 3, true, d3_matrix, "[Shoaff 2.1.2] D3 = [6 8 4; 1 0 3; 5 2 7]"},
    MatrixRecipe{"bayer2", 2, false, bayer_matrix, "[Bayer73]"},
    MatrixRecipe{"bayer4", 4, false, bayer_matrix, "[Bayer73]"},
    MatrixRecipe{"bayer8", 8, false, bayer_matrix, "[Bayer73]"},
    MatrixRecipe{"bayer16", 16, false, bayer_matrix, "[Bayer73]"},
    MatrixRecipe{"bayer32", 32, false, bayer_matrix, "[Bayer73]"},
    MatrixRecipe{"bayer64", 64, false, bayer_matrix, "[Bayer73]"},
    MatrixRecipe{"bayer128", 128, false, bayer_matrix, "[Bayer73]"},
    MatrixRecipe{"bayer256", 256, false, bayer_matrix, "[Bayer73]"},
    MatrixRecipe{"magic", 8, false, magic_square_matrix,
                 "magic square [Weisstein]: de la Loubere, diagonals, or LUX", true},
    MatrixRecipe{"spiral", 8, true, spiral_matrix, "[Ulichney87 ch. 5], one dot along a spiral",
                 true},
    MatrixRecipe{"clustered8", 8, true, clustered_matrix,
                 "[Ulichney87 ch. 5], two dots at 45 degrees"},
    MatrixRecipe{"clustered", 16, true, clustered_matrix,
                 "[Ulichney87 ch. 5], two dots at 45 degrees", true},
    MatrixRecipe{"blue-noise", 128, false, blue_noise_matrix, "void-and-cluster [Ulichney93]", true,
                 true, true},
};

/// The recipe called `name`, or `name` with its size behind it: "magic5", "blue-noise64". Nothing
/// where there is none.
std::optional<MatrixRecipe> find_matrix_recipe(std::string_view name);

/// Throws the std::invalid_argument of a frame number for a dither that does not change with time;
/// it names those that do.
[[noreturn]] void refuse_frame(const std::string& dither);

/// The matrix of a recipe, with its name. Throws std::invalid_argument for a size or a frame that
/// the recipe does not come in.
ThresholdMatrix make_matrix(const MatrixRecipe& recipe, MatrixParameters parameters = {});

}  // namespace tristim
