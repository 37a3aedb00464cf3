#include "tests/tools/command_test.h"
#include "tristim/color/difference.h"

namespace tristim {
namespace {

using Compare = CommandTest;

CommandOptions rows(const std::string& text) {
  CommandOptions options;
  options.input = text;
  return options;
}

double number(const std::string& text) {
  return parse_number(text.substr(0, text.size() - 1)).value();
}

// Pair 1 of [Sharma05 table 1].
TEST_F(Compare, PrintsOneDifference) {
  const std::string pair = " 50 2.6772 -79.7751 50 0 -82.7485";
  EXPECT_NEAR(number(good("compare --from lab --difference ciede2000" + pair)), 2.0424596801565604,
              1e-13);
  EXPECT_NEAR(number(good("compare --from lab --difference CMC:1:1" + pair)), 1.7387361057261508,
              1e-13);
  EXPECT_EQ(good("compare --difference ok black white black black"), "0.9999999934735468\n0\n");
}

TEST_F(Compare, PrintsAllDifferencesOfEachPair) {
  const std::string text = good("compare #ff0000 #fe0000 red red");
  const auto json = parsed(good("compare #ff0000 #fe0000 red red --json"));
  ASSERT_EQ(json["pairs"].size(), 2U);
  for (const DifferenceFormula& formula : kDifferenceFormulas) {
    EXPECT_NE(text.find(formula.name), std::string::npos);
    EXPECT_GT(json["pairs"][0][std::string(formula.name)], 0);
    EXPECT_EQ(json["pairs"][1][std::string(formula.name)], 0);
  }
}

TEST_F(Compare, ReadsRows) {
  EXPECT_EQ(good("compare --from lab --difference cie76", rows("50 0 0\n53 4 0 # far\n")), "5\n");
}

TEST_F(Compare, ListsEveryDifference) {
  EXPECT_EQ(parsed(good("compare --list --json")).size(), kDifferenceFormulas.size());
  EXPECT_NE(good("compare --list").find("[Sharma05 eqs 2-22]"), std::string::npos);
}

TEST_F(Compare, TellsMistakes) {
  refuses("compare red", 3,
          "compare: 1 colours are no pairs; give two colours for each difference");
  refuses("compare --difference ciede20 red blue", 2,
          "--difference: unknown difference 'ciede20'; did you mean ciede2000?");
  refuses("compare --difference cmc:-1 red blue", 2,
          "--difference: 'cmc:-1' has wrong factors; give cmc:L:C, each above 0");
}

}  // namespace
}  // namespace tristim
