#include "tristim/dither/matrix_text.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/error_text.h"
#include "tristim/dither/matrices.h"
#include "tristim/image/view.h"

namespace tristim {
namespace {

using Ranks = std::vector<std::uint16_t>;

std::string wrong(std::string_view text) {
  return error_text([text] { parse_matrix(text, "m.csv"); });
}

TEST(ParseMatrix, ReadsRowsOfRanksFromZeroOrOne) {
  EXPECT_EQ(parse_matrix("0,2\n3,1\n", "m").rank, (Ranks{0, 2, 3, 1}));
  EXPECT_EQ(parse_matrix("# D2\r\n1 3\r\n4\t2 // last\r\n", "m").rank, (Ranks{0, 2, 3, 1}));
  EXPECT_EQ(parse_matrix("\xef\xbb\xbf 0; 1; 2,\n", "m").width, 3);
  const ThresholdMatrix one = parse_matrix("0", "m");
  EXPECT_EQ(one.width * one.height, 1);
  EXPECT_EQ(one.ranks, 1);
}

TEST(ParseMatrix, TellsWhereAndWhatIsWrong) {
  EXPECT_EQ(wrong("0 1\n2\n"),
            "3 m.csv: row 2 has 1 numbers, the first row 2; make all rows of one length");
  EXPECT_EQ(
      wrong("0 2\n2 1\n"),
      "3 m.csv: row 2, column 1 repeats the 2 of row 1, column 2, and 3 is missing; use each of "
      "0 to 3 once");
  EXPECT_EQ(wrong("1,2\n3,5\n"), "3 m.csv: row 2, column 2: 5 is no rank of 4 cells; use 1 to 4");
  EXPECT_EQ(wrong("0,,2\n3,1,4\n"),
            "3 m.csv: row 1, column 2 is empty; write a whole number between the commas");
  EXPECT_EQ(
      wrong("0 1\nx 2\n"),
      "3 m.csv: row 2, column 1: 'x' is no whole number; write the ranks 0, 1, 2, ... in rows");
  EXPECT_EQ(wrong("0 1\n2 1.5\n").substr(0, 40), "3 m.csv: row 2, column 2: '1.5' is no wh");
  EXPECT_EQ(wrong("# nothing\n\n"),
            "3 m.csv: holds no numbers; write a matrix of one cell at least");
  EXPECT_EQ(wrong(""), "3 m.csv: holds no numbers; write a matrix of one cell at least");
  EXPECT_EQ(wrong("-1 0\n"), "3 m.csv: row 1, column 1: -1 is no rank of 2 cells; use 0 to 1");
}

TEST(MatrixCsv, ReadsBack) {
  for (const char* name : {"d3", "magic6", "blue-noise32"}) {
    const ThresholdMatrix matrix = make_matrix(*find_matrix_recipe(name));
    EXPECT_EQ(parse_matrix(matrix_csv(matrix), name).rank, matrix.rank);
  }
  EXPECT_EQ(matrix_csv(make_matrix(kMatrixRecipes[0])), "# d2, 2 x 2, ranks 0 to 3\n0, 2\n3, 1\n");
}

TEST(MatrixCHeader, IsAnArray) {
  const std::string text = matrix_c_header(make_matrix(*find_matrix_recipe("blue-noise2")));
  EXPECT_NE(text.find("static const uint16_t blue_noise2[2][2] = {\n    {"), std::string::npos);
}

TEST(ParsePatterns, ReadsAPatternForEachLevel) {
  const auto list = parse_patterns("00\n00\n\n1 0\n0 0\n\n10\n01\n", "p.txt");
  ASSERT_TRUE(list);
  EXPECT_EQ(list->width, 2);
  ASSERT_EQ(list->steps.size(), 2U);
  EXPECT_EQ(list->steps[1].lit, std::vector<int>{3});
  EXPECT_FALSE(parse_patterns("0 1\n3 2\n", "m.csv"));
  EXPECT_FALSE(parse_patterns("0 1\n", "m.csv"));
  EXPECT_EQ(error_text([] { parse_patterns("10\n\n11\n01\n", "p.txt"); }),
            "3 p.txt: pattern 2 has 2 rows, the first pattern 1; make all patterns of one size");
}

TEST(MatrixFromPicture, RanksGreysEquallyOften) {
  Image picture(3, 2, 1);
  const float greys[] = {0.5F, 0.1F, 0.9F, 0.5F, 0.2F, 0.5F};
  std::copy(std::begin(greys), std::end(greys), picture.view().data);
  const ThresholdMatrix matrix = matrix_from_picture(picture.view(), "p.pgm");
  EXPECT_EQ(matrix.ranks, 6);
  EXPECT_EQ(matrix.rank[1], 0);
  EXPECT_EQ(matrix.rank[4], 1);
  EXPECT_EQ(matrix.rank[2], 5);
  Ranks sorted = matrix.rank;
  std::ranges::sort(sorted);
  EXPECT_EQ(sorted, (Ranks{0, 1, 2, 3, 4, 5}));
}

}  // namespace
}  // namespace tristim
