#include "tristim/color/parse.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace tristim {
namespace {

// The table itself: every row must come out of the parser.
constexpr NamedColor kColors[] = {
#include "luts/css_colors.csv"
};

TEST(ParseColor, TakesHexDigits) {
  EXPECT_EQ(parse_color("#ff8000"), (EncodedRgb{1, 128 / 255.0, 0}));
  EXPECT_EQ(parse_color("#FF8000"), parse_color("#ff8000"));
  EXPECT_EQ(parse_color("#f80"), parse_color("#ff8800"));
  EXPECT_EQ(parse_color("#000"), (EncodedRgb{0, 0, 0}));
}

TEST(ParseColor, TakesThreeNumbers) {
  EXPECT_EQ(parse_color("0.25,0.5,1"), (EncodedRgb{0.25, 0.5, 1}));
  EXPECT_EQ(parse_color("0.25, 0.5, 1"), (EncodedRgb{0.25, 0.5, 1}));
  EXPECT_EQ(parse_color("0.25 0.5  1"), (EncodedRgb{0.25, 0.5, 1}));
}

TEST(ParseColor, TakesTheNamesOfCss) {
  ASSERT_EQ(std::size(kColors), 148U);  // [CSS4 6.1]
  for (const NamedColor& color : kColors) {
    SCOPED_TRACE(color.name);
    const auto parsed = parse_color(color.name);
    ASSERT_TRUE(parsed);
    EXPECT_EQ(parsed->r * 255, color.rgb >> 16);
    EXPECT_EQ(parsed->g * 255, color.rgb >> 8 & 0xff);
    EXPECT_EQ(parsed->b * 255, color.rgb & 0xff);
  }
}

// A few of [CSS4 6.1], those that are often wrong.
TEST(ParseColor, KnowsWhatTheNamesMean) {
  EXPECT_EQ(parse_color("RebeccaPurple"), parse_color("#663399"));
  EXPECT_EQ(parse_color("grey"), parse_color("#808080"));
  EXPECT_EQ(parse_color("gray"), parse_color("#808080"));
  EXPECT_EQ(parse_color("green"), parse_color("#008000"));
  EXPECT_EQ(parse_color("lime"), parse_color("#00ff00"));
  EXPECT_EQ(parse_color("lightgoldenrodyellow"), parse_color("#fafad2"));
  EXPECT_EQ(parse_color("yellow-green"), parse_color("#9acd32"));
}

TEST(ParseColor, RefusesTheRest) {
  for (const char* text :
       {"", "#", "#ff", "#ffff", "#fffffff", "#gggggg", "#12345-", "redd", "1,2", "1,1,1,1",
        "1,1,1.1", "-0.1,0,0", "1,,1", "255 255 255", "nan,0,0", "1;1;1", "1 1 1 1", " ", ",,"}) {
    EXPECT_FALSE(parse_color(text)) << "'" << text << "'";
  }
}

TEST(ColorHint, OffersTheNearestNameOrTheForms) {
  EXPECT_EQ(color_hint("chartruse"), "did you mean chartreuse?");
  const std::string forms = "give #rrggbb, a CSS name, or r,g,b in 0..1";
  EXPECT_EQ(color_hint("#12"), forms);
  EXPECT_EQ(color_hint("1,2,3"), forms);
  EXPECT_EQ(color_hint("qqqqqqqqqqqq"), forms);
  EXPECT_EQ(color_hint(""), forms);
}

}  // namespace
}  // namespace tristim
