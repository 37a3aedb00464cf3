#include "tests/tools/command_test.h"
#include "tristim/dither/growth.h"
#include "tristim/image/io/read.h"

namespace tristim {
namespace {

using Json = nlohmann::json;

class HalftoneCommand : public CommandTest {
 protected:
  // Greys of the first channel of a picture, as stored where they are light.
  std::vector<std::vector<float>> pixels(const std::string& name) const {
    const auto source = open_picture(file(name));
    const PictureInfo& info = source->info();
    Image row(info.width, 1, info.channels);
    std::vector<std::vector<float>> all;
    for (int y = 0; y < info.height; ++y) {
      source->read(row.view());
      all.emplace_back();
      for (int x = 0; x < info.width; ++x) all.back().push_back(*row.view().pixel(x, 0));
    }
    return all;
  }
};

TEST_F(HalftoneCommand, PrintsMatrices) {
  EXPECT_EQ(good("halftone matrix d3"),
            "d3, 3 x 3, ranks 0 to 8, [Shoaff 2.1.2] D3 = [6 8 4; 1 0 3; 5 2 7]\n"
            "6 8 4\n1 0 3\n5 2 7\n");
  const Json json = Json::parse(good("halftone matrix magic4 --json"));
  EXPECT_EQ(json["ranks"], 16);
  EXPECT_EQ(json["rank"][0], Json({15, 1, 2, 12}));
}

TEST_F(HalftoneCommand, WritesMatricesThatReadBack) {
  for (const char* name : {"d2", "magic5", "clustered8", "blue-noise32"}) {
    const std::string printed = good(Words{"halftone", "matrix", name, "--json"});
    for (const char* out : {"m.csv", "m.png", "m.pgm"}) {
      SCOPED_TRACE(std::string(name) + " " + out);
      good(Words{"halftone", "matrix", name, "-o", out, "-f"});
      const std::string again = good(Words{"halftone", "matrix", out, "--json"});
      EXPECT_EQ(Json::parse(again)["rank"], Json::parse(printed)["rank"]);
    }
  }
  good("halftone matrix d2 -o d2.h");
  EXPECT_NE(read("d2.h").find("uint16_t d2[2][2]"), std::string::npos);
}

TEST_F(HalftoneCommand, JudgesMatricesAndLists) {
  const Json d3 = Json::parse(good("halftone judge d3 --json"));
  for (const auto& finding : d3["guidelines"]) EXPECT_EQ(finding["verdict"], "holds");
  EXPECT_EQ(d3["guidelines"].size(), growth_guidelines().size());
  write("list.txt", "00\n00\n\n10\n00\n\n01\n00\n");
  const Json list = Json::parse(good("halftone judge list.txt --json"));
  EXPECT_EQ(list["levels"], 3);
  EXPECT_EQ(list["guidelines"][0]["verdict"], "fails");
  EXPECT_NE(good("halftone judge bayer4").find("fails: level 2 is in 2 pieces"), std::string::npos);
}

TEST_F(HalftoneCommand, CountsLevelsAndColours) {
  EXPECT_TRUE(good("halftone levels --n 2 --bits 1")
                  .starts_with("2 x 2 cells, 1 bits: n^2 (2^m - 1) + 1 = 5 levels"));
  EXPECT_TRUE(good("halftone levels --n 2 --bits 1,1,1")
                  .starts_with("2 x 2 cells, 1, 1, 1 bits: 5 x 5 x 5 = 125 colours"));
  const Json json = Json::parse(good("halftone levels --n 3 --bits 3,3,2 --json"));
  EXPECT_EQ(json["count"], 64 * 64 * 28);
  EXPECT_EQ(json["channels"][2]["count"], 28);
  const Json level = json["channels"][0]["levels"][20];
  EXPECT_EQ(level["value"], 2);
  EXPECT_EQ(level["raised"], 2);
  EXPECT_DOUBLE_EQ(level["intensity"], 20.0 / 63);
  const Json colors = Json::parse(good("halftone levels --n 2 --bits 1,1,1 --colors --json"));
  EXPECT_EQ(colors["colors"].size(), 125U);
}

TEST_F(HalftoneCommand, DrawsPatterns) {
  good("halftone patterns d2 -o d2.svg");
  const std::string svg = read("d2.svg");
  for (int level = 0; level <= 4; ++level) {
    EXPECT_NE(svg.find(">" + std::to_string(level) + "</text>"), std::string::npos);
  }
  good("halftone patterns d3 -o d3.png --dot 8");
  const auto chart = pixels("d3.png");
  EXPECT_GT(chart.size(), 60U);
  EXPECT_EQ(run("halftone patterns bayer256 -o b.png").exit_code, 0);
}

// k div n^2 + [k mod n^2 > D], k = floor(I n^2 (2^m - 1) + 1/2).
TEST_F(HalftoneCommand, MakesACellForEachPixel) {
  write("i.pfm",
        std::string("Pf\n2 1\n-1.0\n") + std::string("\x00\x00\x80\x3e\x00\x00\x40\x3f", 8));
  good("halftone cells i.pfm --matrix d2 -o one.pgm");  // .25 and .75, lit is 1
  const auto one = pixels("one.pgm");
  ASSERT_EQ(one.size(), 2U);
  EXPECT_EQ(one[0], (std::vector<float>{1, 0, 1, 1}));
  EXPECT_EQ(one[1], (std::vector<float>{0, 0, 0, 1}));
  good("halftone cells i.pfm --matrix d3 --bits 2 -o two.png");  // k = 7 and 20 of 27
  const std::string raw = good("info two.png --json");
  EXPECT_EQ(Json::parse(raw)["width"], 6);
}

TEST_F(HalftoneCommand, ProcessTakesCellsAndOwnMatrices) {
  write("own.csv", "0 2\n3 1\n");
  good("process s.exr -d laser-300 --dither d2 --cells 2 -o named.png");
  good("process s.exr -d laser-300 --dither own.csv --cells 2 -o own.png");
  EXPECT_EQ(read("named.png"), read("own.png"));
  EXPECT_EQ(Json::parse(good("info own.png --json"))["width"], 128);
  EXPECT_EQ(
      run("process s.exr -d laser-300 --cells 3 --size 64x -o x.png").err,
      "tristim: --cells: a side of 64 pixels is no multiple of cells of 3; give another size, "
      "or cells that divide it\n");
}

TEST_F(HalftoneCommand, FramesChangeBlueNoiseAndNothingElse) {
  good("process s.exr -d laser-300 --dither blue-noise -o still.png");
  good("process s.exr -d laser-300 --dither blue-noise --mask-size 32 --frame 0 -o a.png");
  good("process s.exr -d laser-300 --dither blue-noise --mask-size 32 --frame 1 -o b.png");
  good("process s.exr -d laser-300 --dither blue-noise --mask-size 32 --frame 16 -o c.png");
  EXPECT_NE(read("a.png"), read("b.png"));
  EXPECT_EQ(read("a.png"), read("c.png"));
  for (const char* dither : {"bayer8", "floyd-steinberg", "none"}) {
    const CommandResult result = run(Words{"process", "s.exr", "-d", "laser-300", "--dither",
                                           dither, "--frame", "1", "-o", "no.png"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err, "tristim: frame: dither " + std::string(dither) +
                              " does not change with time; leave it out, or use blue-noise\n");
    EXPECT_FALSE(exists("no.png"));
  }
}

TEST_F(HalftoneCommand, TellsWhatIsWrong) {
  const auto wrong = [this](const Words& words) {
    const CommandResult result = run(words);
    EXPECT_NE(result.exit_code, 0);
    return result.err;
  };
  EXPECT_EQ(wrong("halftone matrix bayr8"),
            "tristim: bayr8: unknown matrix; did you mean bayer8?\n");
  EXPECT_EQ(wrong("halftone matrix magic2"),
            "tristim: size of a magic square: 2; expected 1 or 3 to 256, there is none of 2 a "
            "side\n");
  EXPECT_EQ(wrong("halftone draw"),
            "tristim: draw: is nothing that halftone does; use one of: matrix, patterns, judge, "
            "levels, cells, screen, gallery\n");
  write("m.csv", "0 2\n2 1\n");
  EXPECT_EQ(
      wrong("process s.exr -d laser-300 --dither m.csv -o x.png"),
      "tristim: m.csv: row 2, column 1 repeats the 2 of row 1, column 2, and 3 is missing; use "
      "each of 0 to 3 once\n");
  EXPECT_EQ(wrong("halftone matrix d2 --mask-size 4"),
            "tristim: size of d2: 4; it comes in 2 alone\n");
  EXPECT_EQ(
      wrong("halftone patterns d2 -o d2.gif"),
      "tristim: --output: 'd2.gif' is neither .png nor .svg; give -o chart.png or chart.svg\n");
}

}  // namespace
}  // namespace tristim
