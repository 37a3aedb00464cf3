#include <cmath>

#include "tests/tools/command_test.h"
#include "tristim/image/io/read.h"
#include "tristim/lut/io/file.h"

namespace tristim {
namespace {

using LutCommand = CommandTest;

TEST_F(LutCommand, HelpEndsInExamplesThatWork) {
  const std::string help = good("lut --help");
  EXPECT_NE(help.find("lut bake --device crt-p22 --tone-map reinhard:4 -o crt.cube"),
            std::string::npos);
  for (const char* job : {"", "bake", "apply", "invert", "compose", "info"}) {
    const std::string page = good("lut " + std::string(job) + (*job ? " --help" : "--help"));
    const std::string examples = page.substr(page.find("Examples:\n") + 10);
    const CommandResult result =
        shell("rm -rf t && mkdir t && cd t && set -e\n" + examples + "cd .. && rm -r t");
    EXPECT_EQ(result.exit_code, 0) << examples << result.err;
  }
}

TEST_F(LutCommand, BakesACubeAndTellsItsError) {
  const auto json = parsed(good("lut bake --device crt-p22 --size 17 -o crt.cube --json"));
  EXPECT_EQ(json["table"], "curves of 4096 entries, then a cube of 17 points an edge");
  EXPECT_LT(json["ciede2000"]["largest"], 2);
  EXPECT_LT(json["ciede2000"]["mean"], json["ciede2000"]["largest"]);
  EXPECT_EQ(json["ciede2000"]["colors"], 128000);
  const Lut lut = read_lut(file("crt.cube"));
  ASSERT_EQ(lut.steps.size(), 2U);
  EXPECT_EQ(evaluate(lut, {1, 1, 1}), (Rgb{1, 1, 1}));
}

// A 65-point cube of a smooth chain: below .5 with the shaper that tristim chooses.
TEST_F(LutCommand, MakesSmoothChainsFine) {
  const auto json = parsed(
      good("lut bake --device srgb --size 65 --exposure -0.5 -o s.cube --max-error 0.5 --json"));
  EXPECT_LT(json["ciede2000"]["largest"], 0.1);
  EXPECT_LE(json["size_for_0.1"], 65);
}

TEST_F(LutCommand, MissesTheGateWithCode4) {
  const std::vector<std::string> before = files();
  const CommandResult result =
      run("lut bake --device srgb --size 5 --shaper none -o s.cube --max-error 0.5");
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_NE(result.err.find("tristim: s.cube: the largest CIEDE2000 is "), std::string::npos);
  EXPECT_NE(result.out.find("CIEDE2000 to the exact chain"), std::string::npos);
  EXPECT_EQ(files(), before);
}

TEST_F(LutCommand, AppliesWhatProcessDoes) {
  good("lut bake --device srgb --size 33 --tone-map reinhard:4 --range 0,16 -o s.cube");
  good("lut apply s.exr s.cube -o lut.png");
  good("process s.exr --device srgb --tone-map reinhard:4 -o process.png");
  const auto difference = parsed(good("compare process.png lut.png --json"));
  EXPECT_LT(difference["de00_max"], 1.5);
  good("lut apply s.exr s.cube -o lut.exr");
  good("lut apply s.exr s.cube -o one.exr --threads 1");
  EXPECT_EQ(read("lut.exr"), read("one.exr"));
}

TEST_F(LutCommand, InvertsCurvesAndCubes) {
  good("lut bake --from-device crt-p22 --to linear --curves 256 -o light.spi1d");
  const auto curves = parsed(good("lut invert light.spi1d -o codes.csp --json"));
  EXPECT_LT(curves["ciede2000_largest"], 0.05);
  good("lut bake --from rgb:srgb --device crt-p22 --size 9 --shaper none -o crt.cube");
  const auto cube = parsed(good("lut invert crt.cube -o back.cube --size 17 --json"));
  EXPECT_LT(cube["ciede2000_mean"], 1);
  const auto both = parsed(good("lut compose back.cube crt.cube -o both.clf --json"));
  EXPECT_EQ(both["table"], "a cube of 17 points an edge, then a cube of 9 points an edge");
}

TEST_F(LutCommand, DescribesTables) {
  write("g.cube", "TITLE \"half\"\nLUT_1D_SIZE 3\n0 0 1\n0.25 0 0.5\n0.5 0.1 0.7\n");
  EXPECT_EQ(good("lut info g.cube"),
            "g.cube: curves of 3 entries\n"
            "  title: half\n"
            "  1. curves: in 0 to 1, out 0 0 0.5 to 0.5 0.1 1\n"
            "     red rises, green rises, level in places, blue turns\n"
            "     from the identity: largest 1, mean 0.3833\n");
  const auto json = parsed(good("lut info g.cube --json"));
  EXPECT_FALSE(json["steps"][0]["monotone"]);
  EXPECT_EQ(json["steps"][0]["shapes"][2], "turns");
}

TEST_F(LutCommand, RefusesWhatIsWrong) {
  refuses("lut bak", 2, "bak: is nothing that lut does; did you mean bake?");
  refuses("lut bake -o a.cube", 2,
          "lut bake: where the table leads to is missing; give one of --device D, --to MODEL, "
          "--ocio CONFIG");
  refuses("lut bake --device vga16 -o a.cube", 2,
          "device VGA, 16 colours, 640x480: has a palette: no curves lead from light to its codes; "
          "choose a device whose codes are levels of channels");
  refuses("lut bake --device srgb -o a.cube --size 0", 2,
          "--size: '0' is out of range; give a whole number from 2 to 256");
  refuses("lut bake --device srgb -o a.cube --range 1,0", 2,
          "--range: '1,0' is no range; give low and high, for all channels or for each: 0,16");
  refuses("lut bake --device srgb -o a.spi1d", 2,
          "format spi1d: has no cubes; give --curves N, or another format");
  refuses("lut bake --to rgb:srgb --gamut-map clip -o a.cube", 2,
          "--gamut-map: is of devices; give --device D instead of --to");
  write("turns.cube", "LUT_1D_SIZE 3\n0 0 0\n1 1 1\n0.5 0.5 0.5\n");
  refuses("lut invert turns.cube -o a.cube", 3,
          "turns.cube: invert: the red curve rises from end to end, but turns at entry 2 from 1 to "
          "0.5: it has no inverse");
  refuses("lut apply s.exr none.cube -o a.png", 1,
          "none.cube: cannot be opened: no such file or directory; check the path");
}

TEST_F(LutCommand, DoesNotDependOnTheLocale) {
  good("lut bake --device crt-p22 --size 5 --shaper 64 --title x -o a.cube");
  good("lut bake --device crt-p22 --size 5 --shaper 64 --title x -o b.cube",
       {.variables = {"LC_ALL=de_DE.UTF-8"}});
  EXPECT_EQ(read("a.cube"), read("b.cube"));
}

}  // namespace
}  // namespace tristim
