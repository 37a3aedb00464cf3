#include "tests/tools/command_test.h"

namespace tristim {
namespace {

class DeviceNew : public CommandTest {};

TEST_F(DeviceNew, WritesFilesThatCheckGood) {
  good({"device",    "new",      "--name", "My \"CRT\"", "--response", "gamma",   "--gamma",
        "2.35",      "--levels", "255",    "--i0",       "0.01",       "--store", "index",
        "--packing", "gray8",    "--size", "640x480",    "-o",         "crt.toml"});
  const auto json = parsed(good("device show ./crt.toml --json"));
  EXPECT_EQ(json["name"], "My \"CRT\"");
  EXPECT_EQ(json["I0"], 0.01);
  EXPECT_EQ(json["store"], "index");
  EXPECT_EQ(json["bytes_per_line"], 640);
  EXPECT_EQ(json["bytes_per_picture"], 640 * 480);
  good("process s.exr --size 64x36 -d crt.toml -o out.png --quiet");
}

TEST_F(DeviceNew, StartsFromAnotherDevice) {
  good({"device", "new", "--like", "lcd-rgb565", "--name", "mine", "--white", "d50", "-o",
        "a.toml"});
  const auto json = parsed(good("device show ./a.toml --json"));
  EXPECT_EQ(json["packing"], "rgb565");
  EXPECT_EQ(json["name"], "mine");
  EXPECT_NEAR(json["primaries"]["white"][0].get<double>(), 0.3457, 1e-4);
  refuses({"device", "new", "--like", "lcd-rgb565", "--i0", "0.1"}, 2,
          "--i0: needs levels; add --levels N");
}

TEST_F(DeviceNew, NeverAsksWithoutATerminal) {
  refuses("device new", 2, "--name: is missing; give --name NAME", {.input = "panel\nrgb888\n"});
}

TEST_F(DeviceNew, AsksOnATerminal) {
  if (shell("command -v script").exit_code != 0) GTEST_SKIP() << "no script";
  const CommandResult result = shell(
      "(sleep 1; printf 'My panel\\nrgb999\\ngray4\\ngamma\\n2.4\\n'; sleep 1) | "
      "script -qec '\"$TRISTIM\" device new -o asked.toml' /dev/null");
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  const auto json = parsed(good("device show ./asked.toml --json"));
  EXPECT_EQ(json["name"], "My panel");
  EXPECT_EQ(json["packing"], "gray4");
  EXPECT_NE(json["response"].get<std::string>().find("gamma = 2.4,"), std::string::npos);
}

TEST_F(DeviceNew, RefusesWhatMakesNoDevice) {
  refuses("device new --name x --packing rgb565x", 2,
          "--packing: unknown packing 'rgb565x'; did you mean rgb565?");
  refuses("device new --name x --gamma 0", 2,
          "--gamma: '0' is out of range; give a number from 0.01 to 100");
  refuses("device new --name x --red 0.3", 2,
          "--red: '0.3' is no chromaticity; give x,y such as 0.64,0.33");
  refuses(
      "device new --name x --levels 300", 2,
      "options: n = 300 is out of range; give a number from 1 to 255, the packing's highest code");
  refuses("device new --name x --red 0.3,0.6", 2,
          "primaries: the three chromaticities lie on a line");
  refuses("device new --name x --response table", 2,
          "--response: table has no figures; add --measured FILE.csv");
  refuses("device new --name x --size 0x3", 2,
          "--size: '0x3' is no size of a panel; give WIDTHxHEIGHT in pixels, 1 to 65535: 320x240");
  refuses("device new --name x --set srbg", 2,
          "--set: unknown primaries 'srbg'; did you mean srgb?");
}

TEST_F(DeviceNew, CheckDrawsIt) {
  good("device check crt-p22 --plot crt.svg");
  EXPECT_NE(read("crt.svg").find("bt2020"), std::string::npos);
  std::filesystem::create_directory(file("plots"));
  good("device check epaper-7color --plot plots");
  EXPECT_TRUE(exists("plots/response.svg"));
  EXPECT_NE(read("plots/gamut.svg").find("chromaticity diagram"), std::string::npos);
  refuses("device show srgb --plot a.svg", 2,
          "--plot: draws one device; use: tristim device check D --plot OUT.svg");
}

}  // namespace
}  // namespace tristim
