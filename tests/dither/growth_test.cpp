#include "tristim/dither/growth.h"

#include <gtest/gtest.h>

#include "tristim/core/find.h"
#include "tristim/dither/matrices.h"

namespace tristim {
namespace {

GrowthFinding judged(std::string_view guideline, const PatternSequence& sequence) {
  return find_by_name(growth_guidelines(), guideline)->judge(sequence);
}

GrowthFinding judged(std::string_view guideline, std::string_view matrix) {
  return judged(guideline, pattern_sequence(make_matrix(*find_matrix_recipe(matrix))));
}

// Ranks of a small matrix.
PatternSequence ranks(int width, int height, std::vector<std::uint16_t> rank) {
  ThresholdMatrix matrix{.name = "own", .width = width, .height = height};
  matrix.ranks = static_cast<int>(rank.size());
  matrix.rank = std::move(rank);
  return pattern_sequence(matrix);
}

TEST(Growth, TheDocumentsThreeByThreeCellKeepsAllGuidelines) {
  for (const GrowthGuideline& guideline : growth_guidelines()) {
    EXPECT_TRUE(judged(guideline.name, "d3").holds) << guideline.name;
  }
  EXPECT_EQ(judged("growth", "d3").text, "10 levels, each keeps the pixels of the one before");
  EXPECT_EQ(judged("outward", "d3").text, "from row 2, column 2");
  EXPECT_EQ(judged("lines", "d3").text, "strongest horizontal: 60 % of the contrast at level 4");
}

TEST(Growth, EveryMatrixIsAGrowthSequence) {
  for (const MatrixRecipe& recipe : kMatrixRecipes) {
    EXPECT_TRUE(judged("growth", recipe.name).holds) << recipe.name;
  }
}

TEST(Growth, ListsTellWhatGoesOut) {
  const std::vector<std::vector<std::uint8_t>> patterns{
      {0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 1}, {1, 1, 0, 1}};
  const PatternSequence list = pattern_sequence("list", 2, 2, patterns);
  ASSERT_EQ(list.steps.size(), 3U);
  const GrowthFinding finding = judged("growth", list);
  EXPECT_FALSE(finding.holds);
  EXPECT_EQ(finding.text, "level 2 puts out row 1, column 1, which is lit at level 1");
}

TEST(Growth, ListsWithoutTheDarkLevelBeginAtLevelOne) {
  const std::vector<std::vector<std::uint8_t>> patterns{{1, 0}, {1, 1}};
  EXPECT_EQ(pattern_sequence("list", 2, 1, patterns).steps.size(), 2U);
}

TEST(Growth, ClusteredDotsStayTogetherAndGrowOutward) {
  for (const MatrixRecipe& recipe : kMatrixRecipes) {
    if (!recipe.clustered) continue;
    EXPECT_TRUE(judged("together", recipe.name).holds) << recipe.name;
    EXPECT_TRUE(judged("outward", recipe.name).holds) << recipe.name;
  }
  EXPECT_EQ(judged("together", "clustered8").text, "2 dots a cell, each in one piece");
  EXPECT_EQ(judged("together", "spiral33").text, "one piece at every level");
}

TEST(Growth, DispersedDotsDoNot) {
  for (const char* name : {"d2", "bayer4", "bayer16", "magic5", "blue-noise64"}) {
    const GrowthFinding finding = judged("together", name);
    EXPECT_FALSE(finding.holds) << name;
    EXPECT_EQ(finding.text, "level 2 is in 2 pieces") << name;
  }
  EXPECT_EQ(judged("outward", "bayer4").text, "level 2 begins another dot at row 3, column 3");
}

// The tile's left and right sides touch, and its top and bottom.
TEST(Growth, TilesTouchTheirCopies) {
  EXPECT_TRUE(judged("together", ranks(4, 1, {0, 2, 3, 1})).holds);
  EXPECT_FALSE(judged("together", ranks(4, 1, {0, 3, 1, 2})).holds);
  // Two dots of four have no room to grow: corner by corner is not together.
  EXPECT_FALSE(judged("together", ranks(3, 3, {1, 5, 2, 6, 0, 7, 3, 8, 4})).holds);
}

TEST(Growth, WhatGoesBackInIsNotOutward) {
  // A row of seven from its middle, where one end comes before its inner neighbour.
  EXPECT_TRUE(judged("outward", ranks(7, 1, {5, 3, 1, 0, 2, 4, 6})).holds);
  const GrowthFinding finding = judged("outward", ranks(9, 1, {8, 6, 4, 2, 0, 1, 3, 5, 7}));
  EXPECT_TRUE(finding.holds);
  const GrowthFinding late = judged("outward", ranks(9, 1, {5, 6, 7, 8, 0, 1, 2, 3, 4}));
  EXPECT_FALSE(late.holds);
  EXPECT_EQ(late.text, "level 8 goes back in at row 1, column 3");
}

TEST(Growth, LinesHaveADirection) {
  EXPECT_EQ(judged("lines", ranks(2, 2, {0, 1, 2, 3})).text,
            "strongest horizontal: 100 % of the contrast at level 2");
  EXPECT_EQ(judged("lines", ranks(2, 2, {0, 2, 1, 3})).text,
            "strongest vertical: 100 % of the contrast at level 2");
  EXPECT_EQ(judged("lines", ranks(3, 3, {0, 3, 6, 7, 1, 4, 5, 8, 2})).text,
            "strongest falling diagonal: 100 % of the contrast at level 3");
  EXPECT_EQ(judged("lines", ranks(3, 3, {6, 3, 0, 4, 1, 7, 2, 8, 5})).text,
            "strongest rising diagonal: 100 % of the contrast at level 3");
  EXPECT_FALSE(judged("lines", ranks(2, 2, {0, 1, 2, 3})).holds);
  // A checkerboard has both diagonals alike.
  EXPECT_EQ(judged("lines", "d2").text, "no direction at any level");
  EXPECT_TRUE(judged("lines", "blue-noise64").holds);
}

}  // namespace
}  // namespace tristim
