#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "tristim/color/munsell.h"

namespace tristim {
namespace {

TEST(ParseMunsell, ReadsNotation) {
  const double nan = std::nan("");
  const struct {
    const char* text;
    Munsell munsell;
  } rows[] = {
      {"7.5YR 5/12", {17.5, 5, 12}}, {"10RP 5/4", {100, 5, 4}},
      {"0R 5/4", {100, 5, 4}},       {"0YR 5/4", {10, 5, 4}},
      {"10R 5/4", {10, 5, 4}},       {"2.5pb4.25/8.125", {72.5, 4.25, 8.125}},
      {" 5 r  4 / 14 ", {5, 4, 14}}, {"N 5/", {nan, 5, 0}},
      {"N5", {nan, 5, 0}},           {"n 5.25/0", {nan, 5.25, 0}},
      {"5G 5/0", {nan, 5, 0}},       {"N 0/", {nan, 0, 0}},
      {"N 10/", {nan, 10, 0}},       {"5BG 10/2", {55, 10, 2}},
  };
  for (const auto& row : rows) {
    const auto munsell = parse_munsell(row.text);
    ASSERT_TRUE(munsell) << row.text;
    EXPECT_TRUE(same(*munsell, row.munsell)) << row.text;
  }
}

TEST(ParseMunsell, RefusesOtherTextsAndSaysWhy) {
  const struct {
    const char *text, *hint;
  } rows[] = {
      {"11R 5/4", "the hue is a number of 0 to 10 before R"},
      {"R 5/4", "the hue is a number"},
      {"nanR 5/4", "give hue value/chroma"},
      {"5X 4/4", "give hue value/chroma"},
      {"5R 11/4", "the value, before '/', is 0 to 10"},
      {"5R /4", "the value"},
      {"5R 5/-1", "the chroma"},
      {"5R 5/inf", "the chroma"},
      {"5R 5/4/3", "the chroma"},
      {"5R 5", "the chroma"},
      {"N 11", "a gray is N and its value"},
      {"N5/2", "a gray"},
      {"5N 5/", "a gray"},
      {"", "give hue"},
      {"#ff8000", "give hue"},
      {"5-R 5/4", "the hue"},
      {"\xff\xfe/", "give hue"},
  };
  for (const auto& row : rows) {
    EXPECT_FALSE(parse_munsell(row.text)) << row.text;
    EXPECT_TRUE(munsell_hint(row.text).starts_with(row.hint)) << munsell_hint(row.text);
  }
}

TEST(MunsellNotation, ReadsBackTheSame) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 20000; ++i) {
    const Munsell m{100 - 100 * unit(random), 10 * unit(random), 50 * unit(random) * unit(random)};
    const auto back = parse_munsell(munsell_notation(m));
    ASSERT_TRUE(back && *back == m) << munsell_notation(m);
  }
  EXPECT_EQ(munsell_notation({70.00001, 1e-7, 1e-7}),
            "0.000010000000003174137PB 0.0000001/0.0000001");
}

TEST(MunsellNotation, RoundsToDecimals) {
  EXPECT_EQ(munsell_notation({17.5, 5, 12}), "7.5YR 5/12");
  EXPECT_EQ(munsell_notation({std::nan(""), 5, 0}), "N 5/");
  EXPECT_EQ(munsell_notation({41.85, 8.794, 10.836}, 2), "1.85G 8.79/10.84");
  EXPECT_EQ(munsell_notation({10.004, 5, 4}, 2), "10R 5/4");
  EXPECT_EQ(munsell_notation({0.001, 5, 4}, 2), "10RP 5/4");
  EXPECT_EQ(munsell_notation({99.999, 5, 4}, 2), "10RP 5/4");
  EXPECT_EQ(munsell_notation({50, 5, 0.001}, 2), "N 5/");
  EXPECT_EQ(munsell_notation({50, std::nan(""), 0.001}), "none");
}

}  // namespace
}  // namespace tristim
