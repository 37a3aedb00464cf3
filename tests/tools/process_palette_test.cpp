#include "tests/tools/command_test.h"
#include "tristim/image/io/indexed.h"

namespace tristim {
namespace {

class ProcessPalette : public CommandTest {
 protected:
  IndexedPicture picture(const std::string& name) const {
    auto found = read_indexed_picture(file(name));
    EXPECT_TRUE(found) << name;
    return found ? std::move(*found) : IndexedPicture{};
  }
};

using Entry = std::array<std::uint8_t, 4>;

TEST_F(ProcessPalette, TakesAFileInItsOrder) {
  write("p.gpl", "GIMP Palette\n255 255 255 white\n0 0 0 black\n200 40 30 red\n");
  for (const char* name : {"o.png", "o.gif", "o.bmp", "o.tif"}) {
    SCOPED_TRACE(name);
    good("process s.exr -d srgb --palette p.gpl --quiet -o " + std::string(name));
    const IndexedPicture out = picture(name);
    EXPECT_EQ(out.palette[0], (Entry{255, 255, 255, 255}));
    EXPECT_EQ(out.palette[2], (Entry{200, 40, 30, 255}));
    EXPECT_EQ(out.positions.view().width, 64);
  }
  // codes of a device's palette go into its frame buffer
  write("codes.csv", "hex,code\n#000000,7\n#ffffff,5\n");
  good("process s.exr -d vga16 --size 4x2 --palette codes.csv --quiet -o o.raw");
  for (const char byte : read("o.raw")) {
    for (const int code : {byte >> 4 & 15, byte & 15}) EXPECT_TRUE(code == 7 || code == 5) << code;
  }
}

TEST_F(ProcessPalette, ChoosesForDevicesWithoutIndices) {
  good("process s.exr -d srgb --palette best:5 --quiet -o a.png");
  EXPECT_EQ(picture("a.png").palette.size(), 5U);
  good("process s.exr -d srgb --colors 6 --quiet -o b.png");
  EXPECT_EQ(picture("b.png").palette.size(), 6U);
  good("process s.exr -d srgb --quiet -o c.gif");
  EXPECT_EQ(picture("c.gif").palette.size(), 256U);
  refuses("process s.exr -d srgb --palette best -o d.raw", 2,
          "--palette: packing rgb888 has no palette; choose a device with an indexed packing, or "
          "leave --palette out");
}

TEST_F(ProcessPalette, MovesWithOnePalette) {
  good("render spheres --size 48x48 --samples 1 -o t.exr");
  good("process s.exr t.exr -d srgb --palette best:8 --delay 0.5 --quiet -o o.gif");
  const IndexedPicture out = picture("o.gif");
  EXPECT_EQ(out.pictures, 2);
  EXPECT_EQ(out.palette.size(), 8U);
  EXPECT_EQ(out.positions.view().height, 36);
  good("palette build s.exr t.exr -n 8 -o p.gpl");  // t at its own size: other counts
  good("process s.exr t.exr -d srgb --quiet -o {stem}.gif");
  EXPECT_EQ(picture("s.gif").pictures, 1);
  EXPECT_EQ(picture("t.gif").positions.view().height, 48);
  const auto info = parsed(good("info o.gif --json"));
  EXPECT_EQ(info["pictures"], 2);
  EXPECT_EQ(info["palette"].size(), 8U);
}

TEST_F(ProcessPalette, KeepsAPositionForTransparentPixels) {
  // red, transparent, half transparent from above and below the half
  write("t.pam", "P7\nWIDTH 4\nHEIGHT 1\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n" +
                     std::string("\xff\0\0\xff\0\xff\0\0\0\0\xff\x7f\0\0\xff\x80", 16));
  for (const char* name : {"o.png", "o.gif"}) {
    good("process t.pam -d srgb --palette best:4 --dither none --transparent 1 --quiet -o " +
         std::string(name));
    const IndexedPicture out = picture(name);
    EXPECT_EQ(out.palette[1][3], 0);
    const auto row = out.positions.view().row(0);
    EXPECT_NE(row[0], 1);
    EXPECT_EQ(row[1], 1);
    EXPECT_EQ(row[2], 1);
    EXPECT_NE(row[3], 1);
    EXPECT_EQ(out.palette[row[0]], (Entry{255, 0, 0, 255}));
  }
  write("p.hex", "00000000\nff0000\n0000ff\n");  // the first is transparent
  good("process t.pam -d srgb --palette p.hex --dither none --quiet -o f.png");
  const auto row = picture("f.png").positions;
  EXPECT_EQ(row.view().row(0)[0], 1);
  EXPECT_EQ(row.view().row(0)[1], 0);
  refuses(
      "process t.pam -d srgb --palette best:2 --transparent 5 -o x.png", 2,
      "--transparent: position 5 leaves no room among 2 colours; give a smaller position or more "
      "colours");
  refuses("process t.pam -d srgb --palette p.hex --transparent last -o x.png", 2,
          "--transparent: does not go with a palette of a file; give that an entry of alpha 0");
}

TEST_F(ProcessPalette, SaysTheLimit) {
  std::string many;
  for (int i = 0; i < 300; ++i) many += "0000" + std::to_string(10 + i % 90) + "\n";
  write("many.hex", many);
  refuses(
      "process s.exr -d vga16 --palette many.hex -o x.png", 2,
      "many.hex: a palette of 300 colours, but packing index4 holds at most 16; use fewer colours "
      "or a device with a wider packing");
  refuses("process s.exr -d srgb --palette nowhere.gpl -o x.png", 1,
          "nowhere.gpl: there is no such file; check the name");
  refuses("process s.exr -d vga16 --colors 5 -o x.png", 2,
          "--colors: is for a palette that is chosen, and the device has one of its own; give "
          "--palette best too, or leave it out");
  refuses("process s.exr -d srgb --colors 0 -o x.png", 2,
          "--colors: '0' is no number of colours; give 1 to 65536");
}

TEST_F(ProcessPalette, InfoTellsUsedPositions) {
  write("p.gpl", "GIMP Palette\n0 0 0\n255 255 255\n1 2 3\n");
  write("w.ppm", "P3\n2 1\n255\n255 255 255 0 0 0\n");
  good("process w.ppm -d srgb --palette p.gpl --dither none -o w.png");
  const std::string text = good("info w.png");
  EXPECT_NE(text.find("palette       3 colours, 2 used: 0 1\n   0 #000000 1 "), std::string::npos)
      << text;
  const auto json = parsed(good("info w.png --json"));
  EXPECT_EQ(json["used"], nlohmann::json::parse("[0, 1]"));
  EXPECT_EQ(json["palette"][2]["hex"], "#010203");
  EXPECT_FALSE(parsed(good("info w.ppm --json")).contains("palette"));
}

using PaletteBuild = ProcessPalette;

TEST_F(PaletteBuild, SharesOnePalette) {
  good("render spheres --size 40x30 --samples 1 -o t.exr");
  good("palette build s.exr t.exr -n 16 -o p.hex");
  good("palette build t.exr s.exr -n 16 -o q.hex");
  EXPECT_EQ(read("p.hex"), read("q.hex"));
  EXPECT_EQ(parsed(good("palette show p.hex --json"))["colors"].size(), 16U);
  // counted on two machines
  EXPECT_EQ(good("palette build s.exr --histogram-out s.hist"), "");
  EXPECT_EQ(good("palette build t.exr --histogram-out t.hist"), "");
  EXPECT_EQ(good("palette build -n 16 --merge-histograms s.hist t.hist"), read("p.hex"));
  EXPECT_EQ(good("palette build -n 16 t.hist s.exr"), read("p.hex"));
}

TEST_F(PaletteBuild, EveryMethod) {
  for (const char* method : {"best", "popularity", "median-cut", "variance-cut", "principal-cut",
                             "wu", "octree", "k-means", "fixed", "uniform"}) {
    SCOPED_TRACE(method);
    const auto json =
        parsed(good("palette build s.exr -n 12 --json --method " + std::string(method)));
    EXPECT_LE(json["colors"].size(), 12U);
    EXPECT_GE(json["colors"].size(), 8U);
  }
}

TEST_F(PaletteBuild, KeepsPlaces) {
  write("a.ppm", "P3\n3 1\n255\n255 0 0 0 255 0 0 0 255\n");
  write("b.ppm", "P3\n3 1\n255\n0 0 250 9 9 9 255 0 0\n");
  good("palette build a.ppm -n 3 -o a.hex");
  const std::string first = read("a.hex");
  const auto before = split(first, '\n');
  const std::string text = good("palette build b.ppm -n 3 --previous a.hex");
  const auto after = split(text, '\n');
  for (std::size_t i = 0; i < 3; ++i) {
    if (before[i] == "ff0000") EXPECT_EQ(after[i], "ff0000");
    if (before[i] == "0000ff") EXPECT_EQ(after[i], "0000fa");
  }
}

TEST_F(PaletteBuild, FixesAndReserves) {
  const std::string text =
      good("palette build s.exr -n 6 --fixed #123456,white --transparent last --order luminance");
  const auto lines = split(text, '\n');
  ASSERT_EQ(lines.size(), 7U);
  EXPECT_EQ(lines[0], "123456");
  EXPECT_EQ(lines[1], "ffffff");
  EXPECT_EQ(lines[5].size(), 8U);
  EXPECT_EQ(lines[5].substr(6), "00");
  EXPECT_EQ(parsed(good("palette build s.exr -n 1 --json"))["colors"].size(), 1U);
}

TEST_F(PaletteBuild, CountsByMaskContrastAndAlpha) {
  write("a.ppm", "P3\n3 1\n255\n255 0 0 0 255 0 0 0 255\n");
  write("m.pgm", "P2\n3 1\n255\n0 255 0\n");
  EXPECT_EQ(good("palette build a.ppm --mask m.pgm"), "00ff00\n");
  EXPECT_EQ(good("palette build a.ppm -n 3 --weights contrast"), "0000ff\n00ff00\nff0000\n");
  // red, green at half and blue not covered at all
  const std::string head =
      "P7\nWIDTH 3\nHEIGHT 1\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n";
  write("a.pam", head + std::string("\xff\0\0\xff\0\xff\0\x80\0\0\xff\0", 12));
  EXPECT_EQ(parsed(good("palette build a.pam --alpha threshold --json"))["colors"],
            nlohmann::json::parse(R"(["#00ff00", "#ff0000"])"));
  EXPECT_EQ(parsed(good("palette build a.pam --alpha entries --json"))["colors"],
            nlohmann::json::parse(R"(["#00000000", "#00ff0080", "#ff0000"])"));
  EXPECT_EQ(parsed(good("palette build a.pam --json"))["colors"],
            nlohmann::json::parse(R"(["#000000", "#00bc00", "#ff0000"])"));
  write("n.pgm", "P2\n2 1\n255\n0 255\n");
  refuses("palette build a.ppm --mask n.pgm", 3,
          "n.pgm: is 2x1 where the picture is 3x1; give a mask of the picture's size, or --size");
  refuses("palette build a.ppm --alpha none", 2,
          "--alpha: unknown name 'none'; use one of: premultiplied, threshold, entries");
}

TEST_F(PaletteBuild, TellsMistakes) {
  refuses("palette build", 2, "palette build: no pictures are given; give pictures, or histograms");
  refuses("palette build s.exr -n 0", 2,
          "--colors: '0' is out of range; give a whole number from 1 to 65536");
  refuses("palette build s.exr -n 70000", 2,
          "--colors: '70000' is out of range; give a whole number from 1 to 65536");
  refuses("palette build s.exr -n 2 --fixed red,green,blue", 2,
          "--fixed: 3 colours are more than the 2 of the palette; fix fewer, or give a larger -n");
  refuses("palette build s.exr --method bestt", 2,
          "--method: unknown name 'bestt'; did you mean best?");
  refuses("palette build nowhere.exr", 1,
          "nowhere.exr: cannot be opened: no such file or directory; check the path");
  refuses("palette build s.exr -n 300 -o x.act", 2,
          "x.act: a palette of 300 colours, but format act holds at most 256; use fewer colours or "
          "another format");
  write("bad.hist", "tristim histogram 1\nff00 3\n");
  const CommandResult result = run("palette build bad.hist");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err.find("tristim: bad.hist"), 0U) << result.err;
}

}  // namespace
}  // namespace tristim
