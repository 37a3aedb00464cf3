#include <cmath>

#include "tests/tools/command_test.h"
#include "tristim/color/gamut_map.h"

namespace tristim {
namespace {

class ConvertGamut : public CommandTest {};

constexpr const char* kGreen = "convert --from linear:bt2020 --to rgb:srgb 0 1 0 --gamut-map ";

TEST_F(ConvertGamut, LeavesNothingOutside) {
  for (const GamutMethod& method : kGamutMethods) {
    SCOPED_TRACE(method.name);
    const std::string out = good(kGreen + std::string(method.name));
    for (const std::string_view word :
         split(std::string_view(out).substr(0, out.size() - 1), ' ')) {
      const double value = parse_number(word).value_or(NAN);
      EXPECT_GE(value, 0);
      EXPECT_LE(value, 1);
    }
  }
  EXPECT_EQ(good("convert --from linear:bt2020 --to rgb:srgb 0 1 0 --gamut-map clip"), "0 1 0\n");
}

TEST_F(ConvertGamut, KeepsColoursInsideToTheBit) {
  const std::string rows = "convert --from hsv --to rgb 210 0.6 0.3 33 0.7 0.123 none 0 0.5";
  EXPECT_EQ(good(rows + " --gamut-map desaturate"), good(rows));
  EXPECT_EQ(good(rows + " --gamut-map clip"), good(rows));
}

TEST_F(ConvertGamut, CountsThoseOutside) {
  const CommandResult result = run("convert --to linear 1.5 0 0 1 1 1 nan 0 0 --gamut-map clip");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, "1 0 0\n1 1 1\nnan 0 0\n");
  EXPECT_EQ(result.err, "tristim: note: 1 of 3 colours outside the gamut, 1 changed by clip\n");
  const auto json = nlohmann::json::parse(
      run("convert --to linear 1.5 0 0 1 1 1 --gamut-map clip --json --quiet").out);
  EXPECT_EQ(json["gamut_map"]["outside"], 1);
}

TEST_F(ConvertGamut, ExplainsTheMapping) {
  const std::string out = good("convert --to linear 1.5 0 0 --gamut-map clip --explain");
  EXPECT_NE(out.find("gamut map clip, between linear and linear: each channel to [0, 1]"),
            std::string::npos);
  EXPECT_NE(out.find(" 0 0 -> linear 1 0 0\n"), std::string::npos);
}

TEST_F(ConvertGamut, RefusesModelsWithoutAGamut) {
  refuses("convert --to lab red --gamut-map clip", 2,
          "--gamut-map: 'lab' has no gamut; give --to a model of RGB, such as rgb:srgb, "
          "linear:bt2020 or hsv:display-p3");
  refuses("convert --to all red --gamut-map clip", 2,
          "--gamut-map: 'all' models have no gamut; give colours and --to a model of RGB");
  refuses("convert --to rgb red --gamut-map clp", 2,
          "--gamut-map: unknown gamut map 'clp'; did you mean clip?");
  refuses("convert --to hsv s.exr -o o.exr --gamut-map clip", 2,
          "--gamut-map: is for colours; use process for pictures");
  refuses("convert --to hsv s.exr -o o.exr --json", 2,
          "--json: is for colours; leave it out, or leave out -o");
}

}  // namespace
}  // namespace tristim
