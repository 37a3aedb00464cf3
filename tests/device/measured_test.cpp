#include "tristim/device/measured.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/error_text.h"

namespace tristim {
namespace {

using Numbers = std::vector<double>;

std::string refusal(const std::string& text) {
  return error_text([&] { measured_response(parse_measured(text, "m.csv"), 0); });
}

TEST(ParseMeasured, ReadsPairsWithHeadingsCommentsAndAnySeparator) {
  for (const char* text :
       {"0,0.5\n128,20\n255,100\n", "# cd/m2\ncode, Y\n0, 0.5\r\n\n128,20\n255,100",
        "\xEF\xBB\xBF"
        "code;Y\n0;0.5\n128;20\n255;100\n",
        "0\t.5\n128\t2e1\n255\t+100"}) {
    SCOPED_TRACE(text);
    const MeasuredTable table = parse_measured(text, "m.csv");
    EXPECT_EQ(table.code, (Numbers{0, 128, 255}));
    ASSERT_EQ(table.luminance.size(), 1U);
    EXPECT_EQ(table.luminance[0], (Numbers{0.5, 20, 100}));
  }
}

TEST(ParseMeasured, ReadsThreeChannels) {
  const MeasuredTable table = parse_measured("code,red,green,blue\n0,1,2,3\n255,4,5,6\n", "m.csv");
  ASSERT_EQ(table.luminance.size(), 3U);
  EXPECT_EQ(measured_response(table, 2).luminance, (Numbers{3, 6}));
  EXPECT_EQ(table.line, (std::vector<int>{2, 3}));
}

TEST(ParseMeasured, SaysWhichLineIsWrong) {
  const std::string numbers = " is no finite number; give numbers with decimal points: 64,12.5";
  EXPECT_EQ(refusal("0,0\n1,nan\n2,3\n"), "3 m.csv:2: 'nan'" + numbers);
  EXPECT_EQ(refusal("0,0\n1,inf\n2,3\n"), "3 m.csv:2: 'inf'" + numbers);
  EXPECT_EQ(refusal("c;Y\n0;0\n1;0,5\n2;3\n"), "3 m.csv:3: '0,5'" + numbers);
  EXPECT_EQ(refusal("0,0\n1\n"),
            "3 m.csv:2: has 1 column; give code,luminance (or code,red,green,blue) in every row");
  EXPECT_EQ(refusal("0,0,0,0\n1,2\n"),
            "3 m.csv:2: has 2 columns; give code,red,green,blue in every row");
  EXPECT_EQ(refusal("a,b\nc,d\n1,2\n2,3\n"), "3 m.csv:2: 'c'" + numbers);
  const std::string few = "; a measured table needs 2 or more: code,luminance";
  EXPECT_EQ(refusal(""), "3 m.csv: has 0 rows of figures" + few);
  EXPECT_EQ(refusal("0,1\n"), "3 m.csv: has 1 row of figures" + few);
}

TEST(MeasuredResponse, MustRiseFromCodeToCode) {
  EXPECT_EQ(
      refusal("# x\n0,1\n5,2\n5,3\n"),
      "3 m.csv:4: code 5 does not ascend from 5; sort the rows by code and give each code once");
  EXPECT_EQ(refusal("0,1\n5,3\n6,2.5\n7,2.25\n8,9\n"),
            "3 m.csv:3: luminance falls from 3 at code 5 to 2.5 at code 6 (so too in line 4); "
            "measure again, or level it out with --monotone");
  EXPECT_EQ(refusal("0,1\n5,1\n"), "3 m.csv:2: luminance does not rise; measure again");
  EXPECT_EQ(
      refusal("0,-1\n5,1\n"),
      "3 m.csv:1: luminance -1 at code 0 is below 0; subtract less of the meter's dark reading");
  EXPECT_EQ(refusal("-1,0\n5,1\n"), "3 m.csv:1: code -1 is below 0; give codes");
  EXPECT_EQ(refusal("0,0\n1,0\n2,1\n3,1\n"), "");  // level is not falling
}

TEST(MonotoneLuminance, PoolsNeighboursThatFall) {
  EXPECT_EQ(monotone_luminance(Numbers{1, 2, 3}), (Numbers{1, 2, 3}));
  EXPECT_EQ(monotone_luminance(Numbers{1, 3, 2, 5}), (Numbers{1, 2.5, 2.5, 5}));
  // By hand: 4 and 1 become 2.5, which 2 pulls down to 7/3 for all three.
  const double third = 7.0 / 3;
  EXPECT_EQ(monotone_luminance(Numbers{4, 1, 2, 8}), (Numbers{third, third, third, 8}));
}

}  // namespace
}  // namespace tristim
