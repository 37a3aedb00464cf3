#include "tests/tools/command_test.h"
#include "tristim/image/io/read.h"
#include "tristim/pipeline/dither_trial.h"

namespace tristim {
namespace {

using HalftoneGallery = CommandTest;

TEST_F(HalftoneGallery, PutsEveryMethodOnOneSheet) {
  const std::string arguments = "halftone gallery s.exr --width 32 --dithers none,bayer8,atkinson ";
  const auto json = parsed(good(arguments + "-o sheet.png --json"));
  ASSERT_EQ(json["dithers"].size(), 3U);
  EXPECT_EQ(json["dithers"][1]["dither"], "bayer8");
  EXPECT_NEAR(json["dithers"][1]["tone_max"], 4.657, 0.001);
  EXPECT_GT(json["dithers"][1]["hvs_snr@40"], json["dithers"][0]["hvs_snr@40"]);
  const PictureInfo info = picture_facts(file("sheet.png")).info;
  EXPECT_GT(info.width, 3 * 32);
  EXPECT_EQ(good(arguments + "-o sheet.png --force --csv").substr(0, 42),
            "dither,tone_max,hvs_snr@40,scielab_mean@40");
  EXPECT_NE(good(arguments + "-o sheet.png --force").find("atkinson"), std::string::npos);
}

// What the list of methods has, the gallery has; small, since some of them search.
TEST_F(HalftoneGallery, WritesAFolderThatCompareAgreesWith) {
  std::string greys;
  for (int i = 0; i < 64 * 36; ++i) greys += static_cast<char>(i % 64 * 3 + i / 64);
  write("r.pgm", "P5\n64 36\n255\n" + greys);
  const std::string gallery = "halftone gallery r.pgm --width 64 -o results/ ";
  good(gallery + "--dithers floyd-steinberg,bayer16 --csv");
  EXPECT_TRUE(exists("results/floyd-steinberg.png"));
  const auto figures = parsed(good(gallery + "--dithers bayer16 --force --json"));
  const auto compared = parsed(good("compare r.pgm results/bayer16.png --json"));
  for (const char* name : {"hvs_snr@40", "scielab_mean@40"}) {
    const double value = figures["dithers"][0][name];
    EXPECT_NEAR(compared[name].get<double>(), value, 0.002 * value) << name;
  }
}

TEST_F(HalftoneGallery, TakesOtherDevices) {
  const auto json = parsed(
      good("halftone gallery s.exr --width 32 --dithers bayer16 -d epaper-4grey -o s.png --json"));
  EXPECT_LT(json["dithers"][0]["tone_max"], 0.5);
  const auto press = parsed(good(
      "halftone gallery s.exr --width 32 --dithers blue-noise -d offset-cmyk -o p.png --json"));
  EXPECT_LT(press["dithers"][0]["tone_max"], 0.5);
}

TEST_F(HalftoneGallery, TellsMistakes) {
  refuses("halftone gallery s.exr", 2,
          "--output: is missing; give -o gallery.png, or a folder for a picture each");
  refuses("halftone gallery s.exr -o g.svg", 2,
          "g.svg: does not end in .png or /; the sheet is a PNG; name a folder for a picture each");
  refuses("halftone gallery s.exr -o g.png --dithers bayer9", 2,
          "--dithers: unknown dither 'bayer9'; did you mean bayer2?");
  refuses("halftone gallery nothing.exr -o g.png", 1,
          "nothing.exr: cannot be opened: no such file or directory; check the path");
  refuses("halftone gallery s.exr -o s.exr/", 1,
          "s.exr/: is a file, not a folder; choose another name");
}

}  // namespace
}  // namespace tristim
