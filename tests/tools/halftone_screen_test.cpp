#include "tests/tools/command_test.h"

namespace tristim {
namespace {

class HalftoneScreen : public CommandTest {};

TEST_F(HalftoneScreen, SaysWhatIsReached) {
  const std::string text = good("halftone screen --dpi 600 --lpi 85 --angle 30 --spot round");
  EXPECT_NE(text.find("asked     85 lpi at 30 degrees, 600 dpi, spot round\n"), std::string::npos);
  const auto json = parsed(good("halftone screen --dpi 600 --lpi 85 --angle 30 --json"));
  const auto& screen = json["screens"][0];
  EXPECT_NEAR(screen["reached"]["angle_deg"].get<double>(), 30, 0.05);
  EXPECT_NEAR(screen["reached"]["lpi"].get<double>(), 85, 0.1);
  EXPECT_EQ(screen["cell_levels"].get<int>(),
            static_cast<int>(screen["cell_dots"].get<double>()) + 1);
  EXPECT_TRUE(json["beats"].empty());
}

TEST_F(HalftoneScreen, WarnsOfMoire) {
  const CommandResult bad = run("halftone screen --dpi 2400 --lpi 150 --angle 15,20,0,45");
  EXPECT_EQ(bad.exit_code, 0);
  EXPECT_EQ(bad.err,
            "tristim: warning: 1 of 6 pairs of screens make a visible moire; keep their angles 30 "
            "degrees apart\n");
  EXPECT_NE(bad.out.find("cyan + magenta"), std::string::npos);
  const CommandResult usual = run("halftone screen --device offset-cmyk --json");
  EXPECT_EQ(usual.err, "");
  const auto json = parsed(usual.out);
  ASSERT_EQ(json["beats"].size(), 6u);
  EXPECT_EQ(json["screens"][3]["ink"], "black");
  EXPECT_NEAR(json["beats"][0]["period_cells"].get<double>(), 1.93, 0.02);
}

TEST_F(HalftoneScreen, WritesChartsAndThresholds) {
  good("halftone screen --dpi 600 --lpi 85 --tones 0.2,0.8 -o chart.png");
  EXPECT_EQ(read("chart.png").substr(1, 3), "PNG");
  good("halftone screen --dpi 400 --lpi 100 --angle 0 --single-cell -o m.csv");
  const std::string csv = read("m.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), ','), 12);
  good("halftone screen --dpi 600 --lpi 85 --angle 15 -o m.json");
  const auto json = parsed(read("m.json"));
  EXPECT_EQ(json["rank"].size(),
            json["width"].get<std::size_t>() * json["height"].get<std::size_t>());
  refuses(
      "halftone screen --dpi 600 --lpi 85 -o m.txt", 2,
      "m.txt: does not end in .png, .json or .csv; give a chart or thresholds one of these names");
  refuses("halftone screen --dpi 600 --lpi 85 --angle 1,2 -o m.png", 2,
          "--output: takes one screen, not 2; give one --angle");
  refuses("halftone screen --tones 2 -o n.png", 2,
          "--tones: '2' is no tone; give numbers from 0 (black) to 1 (white): 0.1,0.5");
}

TEST_F(HalftoneScreen, RefusesWhatCannotBe) {
  refuses("halftone screen --dpi 600 --lpi 700", 2,
          "screen: 600 dpi cannot hold a ruling of 700 lpi; possible are 0.6 to 300 lpi, cells of "
          "1000 to 2 dots");
  refuses(
      "halftone screen --spot 1/x", 2,
      "--spot: spot '1/x' is inf at x = 0, y = -1, expected a number in all of the cell; give "
      "one of round, euclidean, ellipse, line, diamond, square, cosine, a picture, or a formula: "
      "'cos(pi*x) + cos(pi*y)'");
  refuses("halftone screen --spot rond", 2, "--spot: unknown spot 'rond'; did you mean round?");
  refuses("halftone screen --lpi -3", 2,
          "--lpi: '-3' is no ruling; give lines an inch, as in --lpi 85");
  refuses("halftone screen --angle 15,a", 2,
          "--angle: 'a' is no angle; give degrees, one or one for each channel: 45 or 15,75,0,45");
  refuses("halftone screen --kind fm", 2,
          "--kind: unknown kind 'fm'; use one of: screen, hybrid-screen");
}

TEST_F(HalftoneScreen, TakesAPictureAsSpot) {
  write("cell.pgm", "P2\n4 4\n9\n0 1 2 3  1 9 9 2  2 9 8 1  3 2 1 0\n");
  const std::string text = good("halftone screen --dpi 800 --lpi 100 --spot cell.pgm");
  EXPECT_NE(text.find("spot cell.pgm"), std::string::npos);
  good("process s.exr --device laser-300 --spot cell.pgm --lpi 30 -o page.png");
  write("flat.pgm", "P2\n2 2\n9\n4 4 4 4\n");
  refuses("halftone screen --spot flat.pgm", 3,
          "flat.pgm: is the same everywhere: no dot can grow; give a picture with light and dark "
          "places");
}

TEST_F(HalftoneScreen, SeparatesPicturesByInk) {
  good("process s.exr --device offset-cmyk -o page.tif");
  const std::vector<std::string> made{"page.black.tif", "page.cyan.tif", "page.magenta.tif",
                                      "page.yellow.tif", "s.exr"};
  EXPECT_EQ(files(), made);
  refuses("process s.exr --device offset-cmyk -o page.tif", 1,
          "page.cyan.tif: exists already; give --force to replace it");
  refuses(
      "process s.exr --device offset-cmyk -o - --format tiff", 2,
      "standard output: cannot take a file for each of 4 inks; give a name, such as -o page.tif, "
      "or --format png for all inks in one");
  good("process s.exr --device offset-cmyk -o all.png --proof proof.png");
}

// One matrix for all inks prints dots on dots, whatever the separation.
TEST_F(HalftoneScreen, SaysWhereInksShareAMatrix) {
  write("own.csv", "0,2\n3,1\n");
  for (const char* shared : {"bayer16", "clustered8", "own.csv"}) {
    const std::string command = "process s.exr -d offset-cmyk -f -o page.png --dither ";
    EXPECT_NE(run(command + shared).err.find("all inks share one matrix"), std::string::npos);
    EXPECT_EQ(run(command + shared + " --quiet").err, "");
  }
  for (const char* apart : {"screen", "blue-noise", "floyd-steinberg", "none"}) {
    const CommandResult result =
        run(std::string("process s.exr -d offset-cmyk -f -o page.png --dither ") + apart);
    EXPECT_EQ(result.err.find("all inks"), std::string::npos) << apart;
  }
}

}  // namespace
}  // namespace tristim
