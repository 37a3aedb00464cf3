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
  refuses("palette", 2, "palette: an action is missing; use one of: build, show, convert, check");
  refuses("palette chek red", 2, "palette: unknown action 'chek'; did you mean check?");
  refuses("palette check", 2,
          "palette check: no colours are given; give colours, or a file of colours, or a picture");
  refuses("palette check red --background bluue", 2,
          "--background: 'bluue' is no colour; did you mean blue?");
}

TEST_F(PaletteCheck, TellsWhatIsTooClose) {
  const auto json = parsed(good("palette check #ff0000 #fe0000 #00ff00 --json"));
  ASSERT_EQ(json["close_pairs"].size(), 1U);
  EXPECT_EQ(json["close_pairs"][0]["first"], 0);
  EXPECT_EQ(json["close_pairs"][0]["second"], 1);
  EXPECT_NEAR(json["close_pairs"][0]["ciede2000"].get<double>(), 0.19, 0.05);
  EXPECT_EQ(parsed(good("palette check vga16 --json"))["confusions"].size(), 4U);
  EXPECT_LT(json["coverage"]["mixed_share"].get<double>(), 0.05);
  EXPECT_EQ(parsed(good("palette check #ff0000 #fe0000 --json --min-difference 0.1"))["close_pairs"]
                .size(),
            0U);
  const std::string text = good("palette check vga16");
  EXPECT_NE(text.find("too close (CIEDE2000 below 2.3): none"), std::string::npos);
  EXPECT_NE(text.find("protanopia: #55ff55 and #ffff55: 22 become 2.43"), std::string::npos);
  EXPECT_NE(text.find("gamut: mixed in light the colours make 65.9 % of sRGB"), std::string::npos);
}

using PaletteShow = CommandTest;

TEST_F(PaletteShow, PrintsEveryColour) {
  const std::string text = good("palette show epaper-7color");
  EXPECT_NE(text.find("E-paper, 7 colours, 600x448: 7 colours\n"), std::string::npos);
  EXPECT_NE(text.find("    6     6  #b16a49  orange"), std::string::npos) << text;
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_NE(text.find("11.4 to 3"), std::string::npos);
  const auto json = parsed(good("palette show red #fe0000 --json"));
  EXPECT_EQ(json["colors"][0]["name"], "red");
  EXPECT_EQ(json["colors"][1]["css"], "red");
  EXPECT_EQ(json["colors"][1]["iscc_nbs"], "vivid reddish orange");
  EXPECT_EQ(json["colors"][0]["nearest"]["index"], 1);
}

TEST_F(PaletteShow, PaintsWhereTheTerminalCan) {
  EXPECT_NE(good("palette show #ff8000 --color always", {.variables = {"COLORTERM=truecolor"}})
                .find("\x1b[48;2;255;128;0m    \x1b[0m"),
            std::string::npos);
  EXPECT_NE(good("palette show #ff8700 --color always", {.variables = {"COLORTERM="}})
                .find("\x1b[48;5;208m    \x1b[0m"),
            std::string::npos);
  EXPECT_EQ(good("palette show red", {.variables = {"COLORTERM=truecolor"}}).find('\x1b'),
            std::string::npos);
  refuses("palette show red --color maybe", 2,
          "--color: unknown choice 'maybe'; use one of: auto, always, never");
}

TEST_F(PaletteShow, CountsThePixelsOfAPicture) {
  good("process s.exr -d vga16 -o v.png --size 64x36 --quiet");
  const auto json = parsed(good("palette show v.png --json"));
  ASSERT_EQ(json["colors"].size(), 16U);
  int pixels = 0;
  for (const auto& color : json["colors"]) pixels += color["pixels"].get<int>();
  EXPECT_EQ(pixels, 64 * 36);
  write("two.ppm", "P3\n3 1\n255\n255 0 0  255 0 0  0 0 0\n");
  EXPECT_EQ(parsed(good("palette show two.ppm --json"))["colors"][1]["pixels"], 2);
  refuses(
      "palette show s.exr", 3,
      "s.exr: is a picture of more than 256 colours; choose some of them: tristim palette build "
      "s.exr");
  refuses("palette show srgb", 2,
          "srgb: is a device without palette; tristim device list tells which have one");
}

using PaletteConvert = CommandTest;

TEST_F(PaletteConvert, GoesThroughEveryFormat) {
  good("palette convert vga16 a.toml");
  std::string before = "a.toml";
  for (const char* name : {"b.csv", "c.json", "d.h", "e.toml"}) {
    good("palette convert " + before + " " + name);
    before = name;
  }
  const auto colors = [](const std::string& text) { return text.substr(text.find("[frame")); };
  EXPECT_EQ(colors(read("a.toml")), colors(read("e.toml")));  // CSV has no name for all
  for (const char* name : {"f.gpl", "g.hex", "h.act", "i.aco", "j.ase", "k.pal", "l.png"}) {
    good("palette convert " + before + " " + name + " --quiet");
    before = name;
    EXPECT_EQ(parsed(good("palette show " + before + " --json"))["colors"][6]["hex"], "#aa5500");
  }
  EXPECT_EQ(parsed(good("palette convert vga16 m.pal --format riff --json"))["lost"][0], "names");
  EXPECT_EQ(read("m.pal").substr(0, 4), "RIFF");
  EXPECT_EQ(good("palette convert g.hex --format hex -"), read("g.hex"));
}

TEST_F(PaletteConvert, MakesADevice) {
  write("ink.csv", "hex,code,name\n#ffffff,3,paper\n#102030,0,ink\n#c03020,1,red\n");
  good("palette convert ink.csv ink.toml");
  EXPECT_NE(good("device check ./ink.toml").find("good"), std::string::npos);
  good("process s.exr -d ./ink.toml -o out.raw --quiet --size 8x4");
  EXPECT_EQ(read("out.raw").size(), 8U);  // 2 bits a pixel
}

TEST_F(PaletteConvert, TellsMistakes) {
  std::string many;
  for (int i = 0; i < 300; ++i) many += "0000" + std::to_string(10 + i % 90) + "\n";
  write("many.hex", many);
  refuses("palette convert many.hex x.act", 2,
          "x.act: a palette of 300 colours, but format act holds at most 256; use fewer colours or "
          "another format");
  refuses("palette convert many.hex many.hex", 2,
          "many.hex: is an input too; choose another name for the output");
  good("palette convert vga16 v.gpl");
  refuses("palette convert vga16 v.gpl", 1, "v.gpl: exists already; give --force to replace it");
  refuses(
      "palette convert vga16 v.jpg", 2,
      "v.jpg: has no extension that tells a palette's format; use one of: gpl hex txt act aco ase "
      "pal csv json toml png h hpp c inc");
}

}  // namespace
}  // namespace tristim
