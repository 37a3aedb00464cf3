#include <gtest/gtest.h>

#include "tests/error_text.h"
#include "tristim/device/display_file.h"

namespace tristim {
namespace {

constexpr const char* kHead = "name = \"p\"\nkind = \"print\"\n";

Display parsed(const std::string& text) { return parse_display(kHead + text, "p.toml"); }

std::string error(const std::string& text) {
  return error_text([&] { parsed(text); });
}

TEST(PressFile, MakesAPaletteOfAllOverprints) {
  const Display display = parsed(
      "[dots]\ndpi = 1200\nlpi = 106\ninks = [\"cyan\", \"magenta\", \"yellow\", \"black\"]\n"
      "angles = [15, 75, 0, 45]\nblack = 0.5\nink_limit = 3\nseparation = \"subtract\"");
  ASSERT_TRUE(display.press);
  EXPECT_EQ(display.press->inks.size(), 4u);
  EXPECT_EQ(display.press->angles_deg, (std::vector<double>{15, 75, 0, 45}));
  EXPECT_EQ(display.press->black.replacement, 0.5);
  EXPECT_EQ(display.press->black.limit, 3);
  EXPECT_EQ(display.press->rule, SeparationRule::kSubtract);
  EXPECT_EQ(display.dots->lpi, 106);
  EXPECT_EQ(display.frame.packing.name, "index4");
  ASSERT_EQ(display.palette.size(), 16u);
  EXPECT_EQ(display.palette[0].name, "paper");
  EXPECT_EQ(display.palette[9].name, "cyan+black");
  EXPECT_EQ(display.palette[9].code, 9);
  EXPECT_NEAR(display.palette[0].appearance.y, 1, 1e-12);
}

TEST(PressFile, TakesInksRelativeToThePaper) {
  const Display display = parsed(
      "[viewing]\nwhite = \"D50\"\n[dots]\ninks = [\"black\"]\n"
      "[[ink]]\nname = \"paper\"\nxyz = [0.4, 0.42, 0.35]\n"
      "[[ink]]\nname = \"black\"\nxyz = [0.04, 0.042, 0.035]\n");
  EXPECT_EQ(display.frame.packing.name, "index1");
  EXPECT_NEAR(display.press->inks[0].light.r, 0.1, 1e-12);
  EXPECT_NEAR(display.press->inks[0].light.g, 0.1, 1e-12);
  EXPECT_NEAR(display.press->inks[0].light.b, 0.1, 1e-12);
}

TEST(PressFile, ReadsEveryKindOfGain) {
  const auto gain = [](const std::string& line) { return parsed("[dots]\n" + line).dots->gain; };
  EXPECT_TRUE(std::holds_alternative<NoGain>(gain("dpi = 300")));
  EXPECT_EQ(std::get<MurrayDaviesGain>(gain("gain = 0.14")).at_half, 0.14);
  EXPECT_EQ(std::get<YuleNielsenGain>(gain("yule_nielsen = 1.7\nsolid = 0.05")).n, 1.7);
  EXPECT_EQ(std::get<MeasuredGain>(gain("gain_table = [[0, 0], [0.5, 0.7], [1, 1]]")).covered,
            (std::vector<double>{0, 0.7, 1}));
}

TEST(PressFile, TellsWhatIsWrong) {
  const std::pair<const char*, const char*> cases[] = {
      {"[dots]\ngain = 0.1\nyule_nielsen = 2",
       "3 p.toml:3:1: dot gain is given more than once; give one of gain, yule_nielsen, "
       "gain_table"},
      {"[dots]\nyule_nielsen = 0.5",
       "3 p.toml:4:16: yule_nielsen = 0.5 is out of range; give a number from 1 to 10"},
      {"[dots]\nsolid = 0.5",
       "3 p.toml:4:9: solid is of yule_nielsen; add yule_nielsen = 1.7, or remove it"},
      {"[dots]\ngain_table = [[0, 0], [0.5, 0.4], [0.6, 0.3], [1, 1]]",
       "3 p.toml:4:14: the table of dot gain does not rise from [0, 0] to [1, 1]; give areas from "
       "0 "
       "to 1 in ascending order, [0, 0] first and [1, 1] last"},
      {"[dots]\nangles = [1]", "3 p.toml:4:10: angles needs inks; add inks = [...]"},
      {"[dots]\ninks = [\"cyan\", \"Cyan\"]",
       "3 p.toml:4:8: 'Cyan' cannot be the name of an ink here; give names without '/' and '.', "
       "each "
       "once, other than paper"},
      {"[dots]\ninks = [\"black\"]\nangles = [1, 2]",
       "3 p.toml:5:10: there are not as many angles as inks; give one for each, in order"},
      {"[dots]\ninks = [\"cyan\", \"red\"]",
       "3 p.toml:4:8: no separation into cyan, red is known; give one ink, or cyan, magenta and "
       "yellow with black or without"},
      {"[dots]\ninks = [\"red\"]",
       "3 p.toml:3:1: ink 'red' has no colour; add [[ink]] name = \"red\" with lab, xyz or rgb"},
      {"[dots]\ninks = [\"black\"]\n[[ink]]\nname = \"blak\"\nrgb = [0, 0, 0]",
       "3 p.toml:6:8: ink 'blak' is not in [dots] inks; add it there"},
      {"[frame_buffer]\npacking = \"rgb888\"\n[dots]\ninks = [\"black\"]",
       "3 p.toml:3:1: packing rgb888 does not hold a bit for each of 1 inks; give an indexed "
       "packing, "
       "or none"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(error(text), expected) << text;
}

}  // namespace
}  // namespace tristim
