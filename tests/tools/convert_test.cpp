#include <cmath>

#include "tests/tools/command_test.h"
#include "tristim/color/models.h"

namespace tristim {
namespace {

class Convert : public CommandTest {
 protected:
  CommandOptions rows(const std::string& text) const { return {.input = text}; }

  std::vector<double> numbers(const std::string& text) const {
    std::vector<double> all;
    for (const std::string_view word :
         split(std::string_view(text).substr(0, text.find('\n')), ' ')) {
      all.push_back(parse_number(word).value_or(std::nan("")));
    }
    return all;
  }
};

TEST_F(Convert, TakesNegativeNumbersAsValues) {
  const std::vector<double> rgb = numbers(good("convert --from lab --to rgb 50 -20 30"));
  ASSERT_EQ(rgb.size(), 3U);
  EXPECT_NEAR(rgb[0], 0.3999, 1e-4);  // an independent calculation, CSS Color 4 with Bradford: none
  EXPECT_NEAR(rgb[1], 0.4983, 1e-4);
  EXPECT_NEAR(rgb[2], 0.2599, 1e-4);
  EXPECT_EQ(good("convert --from lab --to rgb 50,-20,30"),
            good("convert --from lab --to rgb 50 -20 30"));
  EXPECT_EQ(good("convert --to lab -.5 0 -1e-3"), good("convert --to lab -- -0.5 0 -0.001"));
}

TEST_F(Convert, TakesNamesAndHexadecimalColours) {
  EXPECT_EQ(good("convert --to lab #FFF"), "100 0 0\n");
  EXPECT_EQ(good("convert --to rgb rebeccapurple Rebecca_Purple"), "0.4 0.2 0.6\n0.4 0.2 0.6\n");
}

TEST_F(Convert, ReadsRowsWithCommentsAndCommas) {
  const std::string text =
      "\xef\xbb\xbf# a comment\n\n0.2, 0.3,0.4 # more\r\n#\n\t#ff8000\nnone 1 1\n1 1 1";
  const std::string out = good("convert --to rgb", rows(text));
  EXPECT_EQ(out, "0.2 0.3 0.4\n1 0.5019607843137255 0\nnone 1 1\n1 1 1\n");
  EXPECT_EQ(good("convert --to lab", rows("")), "");
}

TEST_F(Convert, TellsTheRowOfAMistake) {
  refuses("convert --to lab", 3,
          "standard input, row 2: the last colour has 2 of its 3 numbers; give R G B of rgb",
          rows("1 1 1\n0.2,0.3\n"));
  refuses("convert --to lab", 3,
          "standard input, row 3: 'x' is no number and no colour; give R G B of rgb, #rrggbb or a "
          "CSS name",
          rows("1 1 1\n\n0.2 x 1\n"));
  refuses("convert --from lab --to xyz", 3, "standard input, row 1: 2 colours in a row; give one",
          rows("1 1 1 2 2 2\n"));
  refuses("convert --from lab --to xyz", 3,
          "standard input, row 1: the last colour has 1 of its 3 numbers; give L* a* b* of lab",
          rows("1 1 1 2\n"));
  refuses("convert --to lab", 3,
          "standard input, row 1: '#comment' is no number and no colour; a colour is #rrggbb, a "
          "comment begins with '# '",
          rows("#comment\n"));
}

TEST_F(Convert, TellsTheArgumentOfAMistake) {
  refuses("convert --to lab 1 2", 3,
          "arguments: the last colour has 2 of its 3 numbers; give R G B of rgb");
  refuses("convert --to lab 1 2 3 4", 3,
          "arguments: the last colour has 1 of its 3 numbers; give R G B of rgb");
  refuses("convert --to lab 1 red", 3, "arguments: 'red' is no number; give R G B of rgb");
  refuses("convert --to lab redd", 3,
          "arguments: 'redd' is no number and no colour; did you mean red?");
  refuses(
      "convert --to lab 1e999 0 0", 3,
      "arguments: '1e999' is no number and no colour; give R G B of rgb, #rrggbb or a CSS name");
}

TEST_F(Convert, HintsAtTheNearestModel) {
  std::string models;
  for (const ColorModel& model : color_models()) {
    models += (models.empty() ? "" : ", ") + std::string(model.name);
  }
  refuses("convert 1 1 1", 2, "--to: is missing; give one of " + models);
  refuses("convert --to labb 1 1 1", 2, "--to: unknown model 'labb'; did you mean lab?");
  refuses("convert --from foo --to lab 1 1 1", 2,
          "--from: unknown model 'foo'; use one of: " + models);
  refuses("convert --from rgb:nstc1953 --to lab 1 1 1", 2,
          "--from: unknown primaries 'nstc1953'; did you mean ntsc-1953?");
  refuses("convert --from lab@d51 --to rgb 1 1 1", 2,
          "--from: unknown white 'd51'; did you mean d50?");
  refuses("convert --to lab --adapt bradfort 1 1 1", 2,
          "--adapt: unknown adaptation 'bradfort'; did you mean bradford?");
}

TEST_F(Convert, TellsUndefinedFromNotANumber) {
  EXPECT_EQ(good("convert --to xyy black"), "none none 0\n");
  EXPECT_EQ(good("convert --to rgb none nan -inf"), "nan nan -inf\n");
  EXPECT_EQ(good("convert --to rgb none 0 1"), "none 0 1\n");
  const auto json = parsed(good("convert --to rgb --json none nan -inf"));
  EXPECT_TRUE(json["rows"][0][0].is_null());
  EXPECT_TRUE(json["rows"][0][1].is_null());
  EXPECT_EQ(json["rows"][0][2], "-inf");
}

TEST_F(Convert, PrintsJson) {
  const auto json = parsed(good("convert --to xyz --json --explain white #000"));
  EXPECT_EQ(json["from"], "rgb:srgb");
  EXPECT_EQ(json["to"], "xyz");
  ASSERT_EQ(json["rows"].size(), 2U);
  EXPECT_NEAR(json["rows"][0][1].get<double>(), 1, 1e-14);
  EXPECT_EQ(json["rows"][1], nlohmann::json::array({0.0, 0.0, 0.0}));
  EXPECT_GE(json["steps"].size(), 1U);
}

TEST_F(Convert, ExplainsItsMatrix) {
  const std::string text = good("convert --from linear:srgb --to xyz 1 1 1 --explain");
  EXPECT_NE(text.find("0.4123907992659"), std::string::npos) << text;
  EXPECT_NE(text.find("[Shoaff 2.2.4]"), std::string::npos) << text;
}

TEST_F(Convert, ListsEveryModel) {
  const std::string text = good("convert --list");
  const auto json = parsed(good("convert --list --json"));
  ASSERT_EQ(json.size(), color_models().size());
  for (const auto& model : json) {
    EXPECT_NE(text.find(model["model"].get<std::string>()), std::string::npos);
    EXPECT_TRUE(model["components"].is_string() && model["ranges"].is_string() &&
                model["formula"].is_string() && model["source"].is_string());
  }
}

}  // namespace
}  // namespace tristim
