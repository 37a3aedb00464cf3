#include "tristim/dither/matrices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

#include "tests/error_text.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

using Ranks = std::vector<std::uint16_t>;

ThresholdMatrix named(std::string_view name) {
  return make_matrix(*find_by_name(kMatrixRecipes, name));
}

int rank_at(const ThresholdMatrix& m, int x, int y) { return m.row(y)[x % m.width]; }

TEST(ThresholdMatrix, HoldsEveryRankOnce) {
  for (const MatrixRecipe& recipe : kMatrixRecipes) {
    SCOPED_TRACE(recipe.name);
    const ThresholdMatrix matrix = make_matrix(recipe);
    EXPECT_EQ(matrix.name,
              std::string(recipe.name) + (recipe.sizes ? std::to_string(recipe.size) : ""));
    EXPECT_EQ(matrix.ranks, matrix.width * matrix.height);
    Ranks expected(static_cast<std::size_t>(matrix.ranks));
    std::iota(expected.begin(), expected.end(), std::uint16_t{0});
    Ranks sorted = matrix.rank;
    std::ranges::sort(sorted);
    EXPECT_EQ(sorted, expected);
  }
}

TEST(ThresholdMatrix, HasTheDocumentsCellsVerbatim) {  // [Shoaff 2.1.2]
  EXPECT_EQ(named("d2").rank, (Ranks{0, 2, 3, 1}));
  EXPECT_EQ(named("d3").rank, (Ranks{6, 8, 4, 1, 0, 3, 5, 2, 7}));
}

TEST(ThresholdMatrix, BayerFollowsItsRecursion) {  // [Bayer73]
  EXPECT_EQ(named("bayer2").rank, named("d2").rank);
  EXPECT_EQ(named("bayer4").rank, (Ranks{0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5}));
  const char* const sizes[] = {"bayer2",  "bayer4",  "bayer8",   "bayer16",
                               "bayer32", "bayer64", "bayer128", "bayer256"};
  for (int i = 1; i < 8; ++i) {
    const ThresholdMatrix half = named(sizes[i - 1]);
    const ThresholdMatrix whole = named(sizes[i]);
    SCOPED_TRACE(whole.name);
    constexpr int kOffset[2][2] = {{0, 2}, {3, 1}};
    for (int y = 0; y < whole.width; ++y) {
      for (int x = 0; x < whole.width; ++x) {
        const int offset = kOffset[y / half.width][x / half.width];
        EXPECT_EQ(rank_at(whole, x, y), 4 * rank_at(half, x, y) + offset);
      }
    }
  }
}

// Whether a pixel has one of the eight neighbours on the same side of the threshold `lit`.
bool has_company(const ThresholdMatrix& m, int x, int y, int lit) {
  const bool side = rank_at(m, x, y) < lit;
  int alike = -1;  // itself
  for (int dy = 0; dy <= 2; ++dy) {
    for (int dx = 0; dx <= 2; ++dx) {
      const int other = rank_at(m, x + m.width - 1 + dx, y + m.width - 1 + dy);
      if ((other < lit) == side) ++alike;
    }
  }
  return alike > 0;
}

TEST(ThresholdMatrix, ClusteredDotsAreNeverAlone) {
  for (const MatrixRecipe& recipe : kMatrixRecipes) {
    if (!recipe.clustered) continue;
    SCOPED_TRACE(recipe.name);
    const ThresholdMatrix matrix = make_matrix(recipe);
    const int cells = recipe.size * recipe.size;
    // A cell has one or two dots; their first pixels cannot but be alone.
    const int first = recipe.size == 3 ? 2 : 4;
    for (int lit = first; lit <= cells - first; ++lit) {
      for (int y = 0; y < recipe.size; ++y) {
        for (int x = 0; x < recipe.size; ++x) {
          ASSERT_TRUE(has_company(matrix, x, y, lit)) << x << " " << y << " at " << lit;
        }
      }
    }
  }
}

TEST(ThresholdMatrix, ClusteredEightIsTwoEqualDots) {
  const ThresholdMatrix matrix = named("clustered8");
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      // Half a cell to the right and down lies the other dot, one step apart.
      EXPECT_EQ(rank_at(matrix, x, y) / 2, rank_at(matrix, x + 4, y + 4) / 2);
    }
  }
}

// Rows, columns and diagonals of one sum, by each of the three constructions.
TEST(MagicSquare, HasOneSumInAllDirections) {
  for (int n = 1; n <= 34; ++n) {
    if (n == 2) continue;
    SCOPED_TRACE(n);
    const ThresholdMatrix matrix = magic_square_matrix({.size = n});
    Ranks sorted = matrix.rank;
    std::ranges::sort(sorted);
    for (int i = 0; i < n * n; ++i) ASSERT_EQ(sorted[static_cast<std::size_t>(i)], i);
    const int sum = n * (n * n - 1) / 2;
    int falling = 0;
    int rising = 0;
    for (int i = 0; i < n; ++i) {
      int row = 0;
      int column = 0;
      for (int k = 0; k < n; ++k) {
        row += rank_at(matrix, k, i);
        column += rank_at(matrix, i, k);
      }
      ASSERT_EQ(row, sum);
      ASSERT_EQ(column, sum);
      falling += rank_at(matrix, i, i);
      rising += rank_at(matrix, i, n - 1 - i);
    }
    EXPECT_EQ(falling, sum);
    EXPECT_EQ(rising, sum);
  }
}

TEST(MagicSquare, IsLohShuAndThereIsNoneOfTwo) {
  EXPECT_EQ(magic_square_matrix({.size = 3}).rank, (Ranks{7, 0, 5, 2, 4, 6, 3, 8, 1}));
  EXPECT_THROW(magic_square_matrix({.size = 2}), std::invalid_argument);
}

TEST(Spiral, GoesRoundFromTheMiddle) {
  EXPECT_EQ(spiral_matrix({.size = 1}).rank, Ranks{0});
  EXPECT_EQ(spiral_matrix({.size = 3}).rank, (Ranks{6, 7, 8, 5, 0, 1, 4, 3, 2}));
  EXPECT_EQ(spiral_matrix({.size = 4}).rank,
            (Ranks{6, 7, 8, 9, 5, 0, 1, 10, 4, 3, 2, 11, 15, 14, 13, 12}));
}

TEST(Clustered, IsTwoEqualDotsInEveryEvenSize) {
  for (const int n : {2, 4, 6, 10, 16, 30}) {
    const ThresholdMatrix matrix = clustered_matrix({.size = n});
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        ASSERT_EQ(rank_at(matrix, x, y) / 2, rank_at(matrix, x + n / 2, y + n / 2) / 2) << n;
      }
    }
  }
  EXPECT_EQ(clustered_matrix({.size = 8}).rank, named("clustered8").rank);
  EXPECT_THROW(clustered_matrix({.size = 7}), std::invalid_argument);
}

TEST(FindMatrixRecipe, TakesASizeBehindTheName) {
  EXPECT_EQ(find_matrix_recipe("magic5")->size, 5);
  EXPECT_EQ(find_matrix_recipe("Blue_Noise64")->size, 64);
  EXPECT_EQ(find_matrix_recipe("bayer16")->size, 16);
  EXPECT_FALSE(find_matrix_recipe("bayer17"));
  EXPECT_FALSE(find_matrix_recipe("d27"));
  EXPECT_FALSE(find_matrix_recipe("magic99999999999999999999"));
  EXPECT_FALSE(find_matrix_recipe(""));
  EXPECT_EQ(make_matrix(*find_matrix_recipe("spiral6")).name, "spiral6");
}

std::string refusal(const MatrixRecipe& recipe, const MatrixParameters& parameters) {
  return error_text([&] { make_matrix(recipe, parameters); });
}

TEST(MakeMatrix, RefusesSizesAndFramesThatThereAreNone) {
  const MatrixRecipe& d2 = kMatrixRecipes[0];
  EXPECT_EQ(refusal(d2, {.size = 3}), "invalid: size of d2: 3; it comes in 2 alone");
  EXPECT_EQ(refusal(d2, {.frame = 1}),
            "invalid: frame: dither d2 does not change with time; leave it out, or use blue-noise");
  EXPECT_EQ(refusal(*find_matrix_recipe("spiral300"), {}),
            "invalid: size of a spiral: 300; expected 1 to 256");
  EXPECT_EQ(refusal(*find_matrix_recipe("blue-noise0"), {}),
            "invalid: size of blue noise: 0; expected 1 to 1024");
}

}  // namespace
}  // namespace tristim
