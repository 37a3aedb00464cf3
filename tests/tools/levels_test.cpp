#include <cmath>

#include "tests/tools/command_test.h"

namespace tristim {
namespace {

class LevelsCommand : public CommandTest {};

TEST_F(LevelsCommand, PrintsTheTableAsJson) {
  const auto table = parsed(good("levels --n 7 --i0 0.1 --gamma 2.2 --vmax 255 --json"));
  EXPECT_EQ(table["I0"], 0.1);
  EXPECT_EQ(table["n"], 7);
  EXPECT_EQ(table["gamma"], 2.2);
  EXPECT_EQ(table["Vmax"], 255);
  EXPECT_EQ(table["spacing"], "ratio");
  EXPECT_EQ(table["dynamic_range"], 10);
  EXPECT_EQ(table["distinct"], 8);
  EXPECT_NEAR(table["ratio"].get<double>(), std::pow(10, 1.0 / 7), 1e-14);
  ASSERT_EQ(table["I"].size(), 8U);
  ASSERT_EQ(table["V"].size(), 8U);
  EXPECT_EQ(table["V"][0], 90);  // 89.5354 by the formula [Shoaff 2.1.1]
  EXPECT_EQ(table["V"][7], 255);
  EXPECT_EQ(table["I"][7], 1);
}

TEST_F(LevelsCommand, PrintsTheTableAsText) {
  const std::string text = good("levels --n 3");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 8) << text;
  EXPECT_NE(text.find("dynamic range 50"), std::string::npos);
  EXPECT_NE(text.find("distinct codes 4 of 4"), std::string::npos);
  EXPECT_NE(text.find("   0  0.02                    43\n"), std::string::npos) << text;
  EXPECT_NE(text.find("   3  1                       255\n"), std::string::npos) << text;
}

TEST_F(LevelsCommand, PrintsAHeaderThatCompiles) {
  write("table.h", good("levels --n 40 --vmax 1023 --c"));
  const CommandResult compiled = shell(
      "printf '#include \"table.h\"\\nint main(void) { return level_codes[LEVEL_COUNT - 1] == 1023 "
      "? "
      "0 : 1; }\\n' > t.c && ${CC:-cc} -Wall -Wextra -Werror t.c -o t && ./t");
  EXPECT_EQ(compiled.exit_code, 0) << compiled.err;
}

TEST_F(LevelsCommand, FindsTheNearestLevel) {
  EXPECT_EQ(good("levels --n 15 --i0 0.02 --nearest 0.2"), "9\n");
  EXPECT_EQ(good("levels --n 15 --i0 0.02 --nearest -1,0,0.02,nan,1,inf"),
            "0\n0\n0\nnone\n15\n15\n");
  EXPECT_EQ(parsed(good("levels --n 15 --i0 0.02 --nearest 0.2,nan --json")),
            nlohmann::json::array({9, nullptr}));
}

TEST_F(LevelsCommand, RefusesValuesOutOfRange) {
  const std::string whole = "give a whole number from 1 to 65535";
  refuses("levels --n 0", 2, "--n: '0' is out of range; " + whole);
  refuses("levels --n -3", 2, "--n: '-3' is out of range; " + whole);
  refuses("levels --n 1.5", 2, "--n: '1.5' is no whole number; " + whole);
  refuses("levels --vmax 100000", 2, "--vmax: '100000' is out of range; " + whole);
  for (const std::string value : {"0", "1", "-0.1", "nan"}) {
    refuses("levels --i0 " + value, 2,
            "--i0: '" + value + "' is out of range; give a number between 0 and 1");
  }
  refuses("levels --gamma abc", 2, "--gamma: 'abc' is no number; give a number from 0.01 to 100");
  refuses("levels --k 0", 2, "--k: '0' is out of range; give a number above 0");
  refuses("levels --spacing ration", 2, "--spacing: unknown spacing 'ration'; did you mean ratio?");
  refuses("levels --nearest 0.2,", 2,
          "--nearest: '' is no number; give intensities separated by commas: 0.1,0.2");
  refuses("levels --c --json", 2, "--c: does not go with --json; give one of them");
}

// Levels of PQ with white at 10000 cd/m2, in 50 digits: pq^-1 of half way between pq(.01) and 1.
TEST_F(LevelsCommand, TakesEverySpacing) {
  for (const char* spacing : {"ratio", "lstar", "pq", "srgb", "gamma", "bt1886"}) {
    const auto table =
        parsed(good(std::string("levels --n 7 --i0 0.1 --json --spacing ") + spacing));
    EXPECT_EQ(table["spacing"], spacing);
    EXPECT_EQ(table["I"][0], 0.1);
    EXPECT_EQ(table["I"][7], 1);
  }
  EXPECT_EQ(parsed(good("levels --n 2 --spacing lstar --from-zero --json"))["I"][0], 0);
  refuses("levels --from-zero", 2, "from zero: there is no ratio to 0");
}

TEST_F(LevelsCommand, MakesTablesOfThreeChannels) {
  const auto table = parsed(good("levels --n 3 --gamma 2.1,2.2,2.3 --json"));
  EXPECT_EQ(table["gamma"], (nlohmann::json{2.1, 2.2, 2.3}));
  ASSERT_EQ(table["V"].size(), 3U);
  EXPECT_EQ(table["V"][1], parsed(good("levels --n 3 --gamma 2.2 --json"))["V"]);
  EXPECT_EQ(table["channels"][2], "blue");
  refuses("levels --gamma 2,2", 2,
          "--gamma: gives 2 numbers; give one, or three for red, green and blue");
}

TEST_F(LevelsCommand, HasBothArrangements) {
  const auto value = parsed(good("levels --n 3 --vmax 7 --json"));
  EXPECT_EQ(value["frame_buffer"], value["V"]);
  EXPECT_EQ(value["color_table"].size(), 8U);
  const auto index = parsed(good("levels --n 3 --vmax 7 --store index --json"));
  EXPECT_EQ(index["frame_buffer"], (nlohmann::json{0, 1, 2, 3}));
  EXPECT_EQ(index["color_table"], value["V"]);
}

TEST_F(LevelsCommand, TakesMeasuredPanels) {
  write("panel.csv", "code;cd/m2\n0;0.5\n64;6\n128;22\n255;100\n");
  const auto table = parsed(good("levels --n 15 --measured panel.csv --json --plot p.svg"));
  EXPECT_EQ(table["I0"], 0.005);
  EXPECT_EQ(table["Vmax"], 255);
  EXPECT_EQ(table["V"][0], 0);
  EXPECT_EQ(table["V"][15], 255);
  EXPECT_NE(read("p.svg").find("as the codes show them"), std::string::npos);
  const auto steps = parsed(good("levels --n 255 --spacing measured --measured panel.csv --json"));
  EXPECT_EQ(steps["V"][64], 64);
  EXPECT_EQ(steps["distinct"], 256);
  write("bad.csv", "0,1\n10,0.5\n20,3\n");
  refuses("levels --measured bad.csv", 3,
          "bad.csv:2: luminance falls from 1 at code 0 to 0.5 at code 10; measure again, or level "
          "it out with --monotone");
  const CommandResult level = run("levels --n 3 --measured bad.csv --monotone");
  EXPECT_EQ(level.exit_code, 0);
  EXPECT_NE(level.err.find("by 0.25 at the most"), std::string::npos) << level.err;
  write("nan.csv", "0,1\n10,nan\n20,3\n");
  refuses("levels --measured nan.csv", 3,
          "nan.csv:2: 'nan' is no finite number; give numbers with decimal points: 64,12.5");
  refuses(
      "levels --measured panel.csv --gamma 2", 2,
      "--measured: does not go with --gamma, --k, --response, --lw and --lb; give one response");
  refuses("levels --measured panel.csv --vmax 100", 2,
          "--vmax: 100 is below the highest measured code; give 255");
}

TEST_F(LevelsCommand, MakesDimmingTablesWithoutADeadZone) {
  const auto plain = parsed(good("levels --dimming --n 255 --vmax 4095 --json"));
  EXPECT_EQ(plain["V"][0], 0);
  EXPECT_EQ(plain["V"][255], 4095);
  EXPECT_EQ(plain["V"][128], 761);  // 4095 ((100 128/255 + 16)/116)^3 = 760.98
  const auto rising = parsed(good("levels --dimming --n 255 --vmax 1023 --dead-reckoned --json"));
  EXPECT_EQ(rising["distinct"], 256);
  EXPECT_TRUE(rising["same_code"].empty());
  const std::string few = good("levels --dimming --n 255 --vmax 63 --dead-reckoned");
  EXPECT_NE(few.find("more levels than codes: they cannot all differ"), std::string::npos);
}

TEST_F(LevelsCommand, SpreadsLevelsOverFrames) {
  const auto table = parsed(good("levels --dimming --n 15 --vmax 15 --temporal 2 --json"));
  ASSERT_EQ(table["frames"].size(), 16U);
  EXPECT_EQ(table["frames"][0], (nlohmann::json{0, 0, 0, 0}));
  EXPECT_EQ(table["frames"][15], (nlohmann::json{15, 15, 15, 15}));
  EXPECT_EQ(table["frames"][2], (nlohmann::json{1, 0, 0, 0}));  // 15 Y(13.3) = .247
}

TEST_F(LevelsCommand, MakesPanelsAnswerAsBt1886) {
  const auto table = parsed(good("levels --spacing bt1886 --lw 100 --lb 0.1 --gamma 2.2 --json"));
  EXPECT_EQ(table["I0"], 0.001);
  EXPECT_EQ(table["V"][0], 0);  // the panel has its black at code 0
  EXPECT_EQ(table["V"][255], 255);
  EXPECT_NEAR(table["bt1886"]["b"].get<double>(), 0.0595849, 1e-6);
  refuses("levels --lw 100", 2, "--lw: stands alone; give both --lw and --lb");
  refuses("levels --lw 100 --lb 100", 2, "Lb: 100 is not from 0 up to Lw, 100");
}

TEST_F(LevelsCommand, PrintsHeadersOfEveryKindThatCompile) {
  int number = 0;
  for (const std::string options :
       {"--n 40 --store index --progmem", "--n 7 --gamma 2,2.2,2.4 --progmem --name ramp",
        "--dimming --n 15 --temporal 3 --vmax 15", "--dimming --n 9 --temporal 1 --gamma 1,1,1"}) {
    SCOPED_TRACE(options);
    const std::string name = "t" + std::to_string(number++);
    write(name + ".h", good("levels --c " + options));
    const CommandResult compiled =
        shell("printf '#include \"" + name + ".h\"\nint main(void) { return sizeof(" +
              (options.find("ramp") != std::string::npos    ? "ramp"
               : options.find("index") != std::string::npos ? "color_table"
                                                            : "level_frames") +
              ") == 0; }\n' > t.c && ${CC:-cc} -Wall -Wextra -Werror t.c -o t && ./t");
    EXPECT_EQ(compiled.exit_code, 0) << compiled.err;
  }
  refuses("levels --c --name 3x", 2, "--name: '3x' is no name in C; give letters, digits and '_'");
  refuses("levels --progmem", 2, "--progmem: needs --c; add --c");
}

TEST_F(LevelsCommand, TakesDevices) {
  const auto table = parsed(good("levels --device crt-p22 --json"));
  EXPECT_EQ(table["I0"], 0.02);
  EXPECT_EQ(table["gamma"], 2.3);
  EXPECT_EQ(table["V"][128], 109);
  const auto panel = parsed(good("levels --device lcd-rgb565 --n 7 --json"));
  EXPECT_EQ(panel["Vmax"], (nlohmann::json{31, 63, 31}));
  EXPECT_EQ(panel["V"][1][7], 63);
  refuses("levels --device vga16", 2,
          "--device: has a palette, not levels; name a device whose codes are levels");
}

TEST_F(LevelsCommand, WritesDecimalPointsWhateverTheLocale) {
  const std::string plain = good("levels --n 3 --json");
  EXPECT_EQ(good("levels --n 3 --json", {.variables = {"LC_ALL=de_DE.UTF-8", "LANG=de_DE.UTF-8"}}),
            plain);
}

}  // namespace
}  // namespace tristim
