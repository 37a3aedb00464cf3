#include "tristim/dither/threshold_matrix.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

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
    EXPECT_EQ(matrix.name, recipe.name);
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
  const char* const sizes[] = {"bayer2", "bayer4", "bayer8", "bayer16"};
  for (int i = 1; i < 4; ++i) {
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

}  // namespace
}  // namespace tristim
