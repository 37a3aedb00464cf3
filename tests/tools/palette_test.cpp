#include "tests/tools/command_test.h"

namespace tristim {
namespace {

using PaletteCheck = CommandTest;

TEST_F(PaletteCheck, ReportsEveryGuideline) {
  const auto json = parsed(good("palette check --json --background white blue red"));
  ASSERT_EQ(json["guidelines"].size(), 15U);
  EXPECT_EQ(json["guidelines"][1]["verdict"], "warn");
  EXPECT_NEAR(json["guidelines"][1]["measures"]["short_nm"].get<double>(), 464.3, 0.3);
  EXPECT_EQ(json["guidelines"][4]["verdict"], "cannot be judged");
  EXPECT_EQ(json["colors"][0]["color"], "#0000ff");
  EXPECT_NEAR(json["colors"][0]["contrast"].get<double>(), 8.59, 0.01);
  const std::string text = good("palette check blue red");
  EXPECT_NE(text.find("2. Avoid the simultaneous display"), std::string::npos);
  EXPECT_NE(text.find("warn: #0000ff and #ff0000"), std::string::npos) << text;
}

TEST_F(PaletteCheck, ReadsAFileOfColours) {
  write("brand.txt", "\xef\xbb\xbfnavy\r\n#ffd700 # gold\n\n# more\nwhite, black\n");
  const auto json = parsed(good("palette check brand.txt --json"));
  ASSERT_EQ(json["colors"].size(), 4U);
  EXPECT_EQ(json["colors"][1]["color"], "#ffd700");
}

TEST_F(PaletteCheck, ReadsAPicture) {
  write("p.ppm", "P3\n3 1\n255\n255 0 0  255 0 0  0 0 0\n");
  const auto json = parsed(good("palette check p.ppm --json"));
  ASSERT_EQ(json["colors"].size(), 2U);
  EXPECT_EQ(json["colors"][1]["color"], "#ff0000");
  EXPECT_EQ(json["colors"][1]["pixels"], 2);
  EXPECT_EQ(json["guidelines"][8]["verdict"], "warn");  // red all round
  EXPECT_EQ(parsed(good("palette check s.exr --json"))["guidelines"].size(), 15U);
}

TEST_F(PaletteCheck, TellsMistakes) {
  write("bad.txt", "navy\nnavvy\n");
  write("none.txt", "# nothing\n");
  refuses("palette check bad.txt", 3, "bad.txt, row 2: 'navvy' is no colour; did you mean navy?");
  refuses("palette check none.txt", 3, "none.txt: holds no colours");
  refuses("palette check nowhere.txt", 1, "nowhere.txt: there is no such file; check the name");
  refuses("palette check redd blue", 3, "palette check: 'redd' is no colour; did you mean red?");
  refuses("palette", 2, "palette: an action is missing; write palette check ...");
  refuses("palette check", 2,
          "palette check: no colours are given; give colours, or a file of colours, or a picture");
  refuses("palette check red --background bluue", 2,
          "--background: 'bluue' is no colour; did you mean blue?");
}

}  // namespace
}  // namespace tristim
