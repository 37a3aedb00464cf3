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

TEST_F(Convert, TakesCommentsThatAreNoColours) {
  EXPECT_EQ(good("convert --to rgb", rows("#comment\n1 0 0#end\n#00f # blue\n")), "1 0 0\n0 0 1\n");
}

TEST_F(Convert, TakesNamesOfFilesForFiles) {
  refuses("convert --to lab none.csv", 1, "none.csv: there is no such file; check the name");
  write("rows.csv", "1, 1, 1\n");
  EXPECT_EQ(good("convert --to lab rows.csv"), "100 0 0\n");
}

TEST_F(Convert, MixesNoWords) {
  refuses("convert --mix cns --to rgb red lime", 2,
          "--mix: the colours of 'cns' are words; give a model of numbers such as oklch");
}

TEST_F(Convert, DrawsSvgAlone) {
  refuses("convert red --diagram d.png", 2, "d.png: does not end in .svg; drawings are SVG");
  EXPECT_FALSE(exists("d.png"));
}

TEST_F(Convert, TellsRowAndColumnOfAMistake) {
  refuses("convert --to lab", 3,
          "standard input, row 2: 2 numbers where 3 are expected; give R G B of rgb",
          rows("1 1 1\n0.2,0.3\n"));
  refuses("convert --to lab", 3,
          "standard input, row 3, column 2: 'x' is no number; give R G B of rgb",
          rows("1 1 1\n\n0.2 x 1\n"));
  refuses("convert --to lab", 3,
          "standard input, row 1, column 1: 'x' is no number and no colour; give R G B of rgb, "
          "#rrggbb or a CSS name",
          rows("x 1 1\n"));
  refuses("convert --from lab --to xyz", 3,
          "standard input, row 1: 6 numbers where 3 are expected; give L* a* b* of lab",
          rows("1 1 1 2 2 2\n"));
  refuses("convert --from cmyk --to rgb", 3,
          "standard input, row 1: 3 numbers where 4 are expected; give C M Y K of cmyk:subtract",
          rows("1 1 1\n"));
}

TEST_F(Convert, TellsTheArgumentOfAMistake) {
  refuses("convert --to lab 1 2", 3,
          "the last colour: 2 numbers where 3 are expected; give R G B of rgb");
  refuses("convert --to lab 1 2 3 4", 3,
          "the last colour: 1 number where 3 are expected; give R G B of rgb");
  refuses("convert --to lab 1 red", 3, "value 2: 'red' is no number; give R G B of rgb");
  refuses("convert --to lab redd", 3,
          "value 1: 'redd' is no number and no colour; did you mean red?");
  refuses("convert --to lab 1e999 0 0", 3,
          "value 1: '1e999' is no number and no colour; give R G B of rgb, #rrggbb or a CSS name");
}

TEST_F(Convert, ReadsRowsOfAFile) {
  write("rows.txt", "# two\n1 0 0\n#00ff00\n");
  EXPECT_EQ(good("convert --to hsv rows.txt"), "0 1 1\n120 1 1\n");
  EXPECT_EQ(good("convert --to hsv --input rows.txt"), "0 1 1\n120 1 1\n");
  EXPECT_EQ(good("convert --to hsv --input -", rows("blue")), "240 1 1\n");
  write("bad.txt", "1 0\n");
  refuses("convert --to hsv bad.txt", 3,
          "bad.txt, row 1: 2 numbers where 3 are expected; give R G B of rgb");
  refuses("convert --to hsv --input rows.txt red", 2,
          "--input: there are colours in the arguments as well; give one or the other");
  EXPECT_EQ(run("convert --to hsv --input absent.txt").exit_code, 1);
}

TEST_F(Convert, HintsAtTheNearestModel) {
  refuses("convert 1 1 1", 2,
          "--to: is missing; give a model such as lab or hsv; convert --list shows all");
  refuses("convert --to labb 1 1 1", 2, "--to: unknown model 'labb'; did you mean lab?");
  refuses("convert --from rgb:nstc1953 --to lab 1 1 1", 2,
          "--from: unknown primaries 'nstc1953'; did you mean ntsc-1953?");
  refuses("convert --from lab@d51 --to rgb 1 1 1", 2,
          "--from: unknown white 'd51'; did you mean d50?");
  refuses("convert --to lab --adapt bradfort 1 1 1", 2,
          "--adapt: unknown adaptation 'bradfort'; did you mean bradford?");
}

TEST_F(Convert, NamesIgnoreCaseAndMarks) {
  EXPECT_EQ(good("convert --from RGB:NTSC_1953 --to Yiq:FCC-1953 1 1 1"), "1 0 0\n");
}

TEST_F(Convert, KnowsTheModelsOfTheNotes) {
  EXPECT_EQ(good("convert --from rgb:ntsc1953 --to hsv 1 0.5 0"), "30 1 1\n");
  EXPECT_EQ(good("convert --to cmy orange"), "0 0.3529411764705882 1\n");
  EXPECT_EQ(good("convert --to cmyk:subtract 0.25 0.5 0.75"), "0.5 0.25 0 0.25\n");
  EXPECT_EQ(good("convert --to cmyk:subtract:gcr=0.5 0.25 0.5 0.75"), "0.625 0.375 0.125 0.125\n");
  EXPECT_EQ(good("convert --from hls --to rgb 120 0.5 1"), "0 1 0\n");
  EXPECT_EQ(good("convert --to hsv 0.5 0.5 0.5"), "none 0 0.5\n");
  EXPECT_EQ(good("convert --from hsv --to rgb none 0 0.5"), "0.5 0.5 0.5\n");
  EXPECT_EQ(good("convert --from hsv --to rgb -- -60 1 1"), "1 0 1\n");
  EXPECT_EQ(good("convert --to lch --from lab 50 3 4"), "50 5 53.13010235415598\n");
}

// [Shoaff 2.2.9]: red to green.
TEST_F(Convert, MixesInAnyModel) {
  EXPECT_EQ(good("convert --mix rgb --steps 3 --to rgb red lime"), "1 0 0\n0.5 0.5 0\n0 1 0\n");
  EXPECT_EQ(good("convert --mix hsv --steps 3 --to rgb red lime"), "1 0 0\n1 1 0\n0 1 0\n");
  EXPECT_EQ(good("convert --mix hsv --arc longer --steps 3 --to hsv red lime"),
            "0 1 1\n240 1 1\n120 1 1\n");
  EXPECT_EQ(
      good("convert --from rgb:ntsc1953 --mix hsv --steps 2 --to rgb:ntsc1953 0.2 0.4 0.6 1 1 0"),
      "0.2 0.4 0.6\n1 1 0\n");
  EXPECT_EQ(good("convert --mix hsv --at 0.25 --to hsv red lime"), "30 1 1\n");
  refuses("convert --mix hsv --at 2 --to hsv red lime", 2,
          "--at: '2' is out of range; give a number from 0 to 1");
  refuses("convert --mix hsv --to rgb red", 3,
          "--mix: 1 colours are no pairs; give two colours for each mixture");
  refuses("convert --mix hsv --arc long --to rgb red lime", 2,
          "--arc: unknown arc 'long'; did you mean longer?");
}

TEST_F(Convert, ShowsAColourInEveryModel) {
  const std::string text = good("convert --to all #ff8000");
  const auto json = parsed(good("convert --to all --json #ff8000"));
  for (const ColorModel& model : color_models()) {
    const std::string name(model.name);
    if (model.from_base == nullptr && !model.base.empty()) continue;
    EXPECT_NE(text.find(name), std::string::npos) << name;
    ASSERT_TRUE(json["rows"][0].contains(name)) << name;
  }
  EXPECT_EQ(json["rows"][0]["hsv"][1], 1.0);
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
  EXPECT_EQ(json["steps"].size(), 2U);
  ASSERT_EQ(json["ways"][0].size(), 3U);
  EXPECT_EQ(json["ways"][0][1]["model"], "linear");
  EXPECT_EQ(json["ways"][0][1]["values"], nlohmann::json::array({1.0, 1.0, 1.0}));
}

TEST_F(Convert, ExplainsItsMatrix) {
  const std::string text = good("convert --from linear:srgb --to xyz 1 1 1 --explain");
  EXPECT_NE(text.find("0.4123907992659"), std::string::npos) << text;
  EXPECT_NE(text.find("[Shoaff 2.2.4]"), std::string::npos) << text;
  EXPECT_NE(text.find("linear 1 1 1 -> xyz 0.95"), std::string::npos) << text;
}

TEST_F(Convert, ListsEveryModel) {
  const std::string text = good("convert --list");
  const auto json = parsed(good("convert --list --json"));
  ASSERT_EQ(json["models"].size(), color_models().size());
  for (const auto& model : json["models"]) {
    EXPECT_NE(text.find(model["model"].get<std::string>()), std::string::npos);
    EXPECT_TRUE(model["components"].is_string() && model["ranges"].is_string() &&
                model["formula"].is_string() && model["source"].is_string());
  }
  for (const char* list : {"primaries", "whites", "curves", "adaptations"}) {
    ASSERT_FALSE(json[list].empty());
    for (const auto& member : json[list]) {
      EXPECT_NE(text.find(member["name"].get<std::string>()), std::string::npos);
      EXPECT_TRUE(member["source"].is_string());
    }
  }
}

}  // namespace
}  // namespace tristim
