#include <cmath>

#include "tests/tools/command_test.h"
#include "tristim/color/cns.h"

namespace tristim {
namespace {

class ConvertNames : public CommandTest {};

TEST_F(ConvertNames, WritesMunsellThatReadsBack) {
  const std::string notation = good("convert --to munsell-notation #ff8000");
  EXPECT_TRUE(notation.starts_with("3.1636858")) << notation;
  EXPECT_NE(notation.find("YR 6.6139660"), std::string::npos) << notation;
  const std::string back = good({"convert", "--from", "munsell-notation", "--to", "rgb:srgb",
                                 notation.substr(0, notation.size() - 1)});
  const std::vector<std::string_view> rgb = split(std::string_view(back), ' ');
  ASSERT_EQ(rgb.size(), 3U) << back;
  EXPECT_NEAR(parse_number(rgb[0]).value_or(-1), 1, 1e-12);
  EXPECT_NEAR(parse_number(rgb[1]).value_or(-1), 128 / 255.0, 1e-12);
  EXPECT_EQ(good("convert --to munsell-notation black white"), "N 0/\nN 10/\n");
  const std::string gray = good("convert --to munsell-notation gray");
  EXPECT_TRUE(gray.starts_with("N 5.25471073215337")) << gray;  // ASTM D1535: 5.25471073215337879
}

TEST_F(ConvertNames, TellsTheRowOfAColourWithoutAValue) {
  refuses("convert --from munsell --to rgb", 3,
          "standard input, row 2: munsell 5 11 4: Munsell value 11 is not between 0 and 10",
          {.input = "5 5 4\n5 11 4\n"});
}

TEST_F(ConvertNames, ReadsMunsellAsNumbersAndAsNotation) {
  const std::string numbers = good("convert --from munsell --to xyy 17.5 5 12");
  EXPECT_EQ(good("convert --from munsell --to xyy 7.5YR 5/12"), numbers);
  EXPECT_EQ(good({"convert", "--from", "munsell", "--to", "xyy", "7.5yr5/12"}), numbers);
  EXPECT_EQ(good("convert --from munsell --to xyy", {.input = "7.5 YR 5/12  # a row\n"}), numbers);
  EXPECT_TRUE(numbers.starts_with("0.5335 0.4378 0.1927")) << numbers;
  EXPECT_EQ(good("convert --from munsell --to munsell none 5 0"), "none 5 0\n");
}

TEST_F(ConvertNames, NamesColorsAndReadsNames) {
  EXPECT_EQ(good("convert --to iscc-nbs #ff0000 navy"), "vivid reddish orange\nvivid blue\n");
  EXPECT_EQ(good("convert --to cns red saddlebrown"), "vivid red\nvivid brown\n");
  EXPECT_EQ(good("convert --to css 0.39 0.21 0.6"), "rebeccapurple\n");
  EXPECT_EQ(
      good({"convert", "--from", "iscc-nbs", "--to", "munsell-notation", "strong greenish blue"}),
      "4.5B 4.5/9\n");
  EXPECT_EQ(good("convert --from cns --to cns light vivid red-purple"), "light vivid purple-red\n");
  EXPECT_EQ(good("convert --from cns --to cns", {.input = "Light grey\nvivid red\n"}),
            "light gray\nvivid red\n");
  EXPECT_EQ(good("convert --from css --to rgb rebeccapurple"), "0.4 0.2 0.6\n");
}

// Rows in, rows out, through sRGB and back.
TEST_F(ConvertNames, EveryCnsNameSurvivesTheCommand) {
  std::string names;
  for (const CnsName& name : cns_names()) names += cns_text(name) + "\n";
  const std::string codes = good("convert --from cns --to rgb:srgb", {.input = names});
  EXPECT_EQ(good("convert --to cns", {.input = codes}), names);
}

TEST_F(ConvertNames, HasTheValueFunctions) {
  EXPECT_EQ(good("convert --from xyz --to munsell-value:priest1920 .2 .25 .3"), "5\n");
  EXPECT_EQ(good("convert --from xyz --to munsell-value 1 1 1"), "10\n");
  const std::string text = good("convert --to munsell-value:mccamy1987 gray --explain");
  EXPECT_NE(text.find("[McCamy92]"), std::string::npos);
}

TEST_F(ConvertNames, ExplainsTheValueFunctionAndTheInterpolation) {
  const std::string text = good("convert --to munsell tomato --explain");
  for (const char* part :
       {"1.1914 V", "[ASTMD1535]", "linear or radial in hue", "[Newhall43]", "white d65 to c"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
}

TEST_F(ConvertNames, SaysWhyThereIsNoMunsellColor) {
  refuses("convert --from munsell --to rgb 17.5 11 4", 3,
          "munsell 17.5 11 4: Munsell value 11 is not between 0 and 10");
  refuses("convert --from munsell --to rgb 17.5 5 40", 3,
          "munsell 17.5 5 40: Munsell chroma 40 is beyond the renotation, which ends at 16 there");
  refuses("convert --from xyy@c --to munsell 0.1 0.8 0.9", 3,
          "xyy 0.1 0.8 0.9: it lies outside the MacAdam limits of illuminant C: at x 0.1 and y 0.8 "
          "Y is 0.1915 at the most, not 0.9");
  refuses("convert --from xyy@c --to iscc-nbs 0.3 0.3 1.5", 3,
          "xyy 0.3 0.3 1.5: Y 1.5 is not between 0 and 1");
}

TEST_F(ConvertNames, HintsAtNames) {
  refuses({"convert", "--from", "cns", "--to", "rgb", "dark vivid bleu"}, 3,
          "value 1: 'dark vivid bleu' is no colour of cns; did you mean dark vivid blue?");
  refuses({"convert", "--from", "iscc-nbs", "--to", "rgb", "strong greenisch blue"}, 3,
          "value 1: 'strong greenisch blue' is no colour of iscc-nbs; did you mean strong greenish "
          "blue?");
  refuses({"convert", "--from", "munsell", "--to", "rgb", "11R 5/4"}, 3,
          "value 1: '11R 5/4' is no colour of munsell; the hue is a number of 0 to 10 before R");
  refuses("convert --from cns --to rgb", 3,
          "standard input, row 2: 'red-green' is no colour of cns; did you mean red-brown?",
          {.input = "red\nred-green\n"});
}

TEST_F(ConvertNames, KeepsNaN) {
  EXPECT_EQ(good("convert --to munsell nan 0.5 0.5"), "nan nan nan\n");
  EXPECT_EQ(good("convert --to cns nan 0.5 0.5"), "none\n");
}

TEST_F(ConvertNames, MixesMunsellHuesTheShortWay) {
  EXPECT_EQ(good("convert --from munsell --mix munsell --steps 3 --to munsell 95 5 4 5 5 6"),
            "95 5 4\n0 5 5\n5 5 6\n");
}

}  // namespace
}  // namespace tristim
