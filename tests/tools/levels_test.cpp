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
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 6) << text;
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

}  // namespace
}  // namespace tristim
