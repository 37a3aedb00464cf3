#include <cmath>

#include "tests/tools/command_test.h"

namespace tristim {
namespace {

class DeviceFit : public CommandTest {
 protected:
  // Luminances of a display with white 100, gamma 2.2 and a black of .5, at 18 codes.
  void write_panel() const {
    std::string rows = "code,luminance\n";
    for (int i = 0; i <= 17; ++i) {
      const double light = 0.5 + 99.5 * std::pow(i / 17.0, 2.2);
      rows += std::to_string(15 * i) + "," + std::to_string(light) + "\n";
    }
    write("panel.csv", rows);
  }
};

TEST_F(DeviceFit, WritesAFileThatDescribesThePanel) {
  write_panel();
  const auto fit = parsed(good("device fit panel.csv -o my.toml --json"));
  EXPECT_EQ(fit["model"], "gamma-black");
  EXPECT_NEAR(fit["gamma"].get<double>(), 2.2, 1e-4);
  EXPECT_NEAR(fit["white"].get<double>(), 100, 1e-3);
  EXPECT_NEAR(fit["black"].get<double>(), 0.5, 1e-3);
  EXPECT_NEAR(fit["K"].get<double>(), 99.5 * std::pow(255, -2.2), 1e-7);
  EXPECT_EQ(fit["residuals"].size(), 18U);
  EXPECT_EQ(fit["recommended"], "model");
  good("device check my.toml");
  EXPECT_NE(read("my.toml").find("\nkind       = \"gog\""), std::string::npos) << read("my.toml");
  good("process s.exr --size 64x36 -d my.toml -o out.png --quiet");
  refuses("device fit panel.csv -o my.toml", 1,
          "my.toml: exists already; give --force to replace it");
}

TEST_F(DeviceFit, TakesTheTableWhereTheModelIsBad) {
  write("knee.csv", "0,1\n64,2\n128,2.5\n192,60\n255,100\n");
  const auto fit = parsed(good("device fit knee.csv -o knee.toml --json"));
  EXPECT_EQ(fit["recommended"], "table");
  EXPECT_EQ(fit["written"], "table");
  EXPECT_NE(read("knee.toml").find("kind       = \"table\""), std::string::npos);
  good("device check knee.toml");
  const CommandResult gate = run("device fit knee.csv --max-error 1");
  EXPECT_EQ(gate.exit_code, 4);
  EXPECT_NE(good("device fit knee.csv --write model -o m.toml").find("the model was asked for"),
            std::string::npos);
}

TEST_F(DeviceFit, FitsThreeChannelsAndPrimaries) {
  std::string rows = "code,red,green,blue\n";
  for (int i = 0; i <= 16; ++i) {
    const double v = i / 16.0;
    rows += std::to_string(i == 16 ? 255 : 255.0 * i / 16) + "," +
            std::to_string(21 * std::pow(v, 2.0)) + "," + std::to_string(72 * std::pow(v, 2.2)) +
            "," + std::to_string(7 * std::pow(v, 2.5)) + "\n";
  }
  write("ramps.csv", rows);
  write("xyz.csv",
        "name,x,y,Y\nred,0.64,0.33,21.26\ngreen,0.3,0.6,71.52\nblue,0.15,0.06,7.22\n"
        "white,0.3127,0.329,100\n");
  const auto fit = parsed(good("device fit ramps.csv --primaries xyz.csv -o rgb.toml --json"));
  EXPECT_NEAR(fit["channels"][0]["gamma"].get<double>(), 2.0, 1e-4);
  EXPECT_NEAR(fit["channels"][2]["gamma"].get<double>(), 2.5, 1e-4);
  EXPECT_NEAR(fit["primaries"]["xyz_from_rgb"][1][1].get<double>(), 0.7152, 1e-3);
  EXPECT_NEAR(fit["primaries"]["gamut"]["cie1931"]["coverage"]["srgb"].get<double>(), 1, 1e-4);
  EXPECT_LT(fit["primaries"]["additivity"]["ciede2000"].get<double>(), 0.1);
  const auto shown = parsed(good("device show ./rgb.toml --json"));
  EXPECT_NE(shown["green"]["response"].get<std::string>().find("gamma = 2.2,"), std::string::npos);
  good("process s.exr --size 64x36 -d rgb.toml -o out.png --quiet");
}

TEST_F(DeviceFit, Draws) {
  write_panel();
  good("device fit panel.csv --plot fit.svg");
  EXPECT_NE(read("fit.svg").find("error, L*"), std::string::npos);
}

TEST_F(DeviceFit, RefusesBadMeasurements) {
  write("falls.csv", "0,1\n64,5\n128,4\n255,9\n");
  refuses(
      "device fit falls.csv", 3,
      "falls.csv:3: luminance falls from 5 at code 64 to 4 at code 128; measure again, or level "
      "it out with --monotone");
  const CommandResult level = run("device fit falls.csv --monotone");
  EXPECT_EQ(level.exit_code, 0) << level.err;
  EXPECT_NE(level.err.find("levelled out, by 0.5 at the most, at code 64"), std::string::npos);
  write("short.csv", "0,1\n");
  refuses("device fit short.csv", 3,
          "short.csv: has 1 row of figures; a measured table needs 2 or more: code,luminance");
  refuses("device fit absent.csv", 1, "absent.csv: there is no such file; check the name");
  write("ten.csv", "0,0\n512,50\n1023,90\n");
  refuses("device fit ten.csv", 2,
          "--packing: gray8 ends at code 255, the measurement at 1023; give the packing that was "
          "measured");
  write("xyz.csv", "gren,1,2,3\n");
  refuses("device fit ten.csv --primaries xyz.csv", 3,
          "xyz.csv:1: unknown light 'gren'; did you mean green?");
  refuses("device fit ten.csv --model gogg", 2, "--model: unknown model 'gogg'; did you mean gog?");
}

}  // namespace
}  // namespace tristim
