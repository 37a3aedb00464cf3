#include "tests/tools/command_test.h"

namespace tristim {
namespace {

class ProcessOptions : public CommandTest {
 protected:
  /// A value of an option that must be refused, with the rest of the line behind "--option: ".
  void refuses_value(const std::string& option, const std::string& value,
                     const std::string& rest) const {
    refuses({"process", "s.exr", "-d", "srgb", "-o", "o.png", "--" + option, value}, 2,
            "--" + option + ": " + rest);
  }
};

TEST_F(ProcessOptions, NeedsPicturesAndADevice) {
  refuses("process", 2,
          "process: IN is missing; use: tristim process IN... -o OUT --device D [options]");
  refuses("process s.exr -o o.png", 2,
          "--device: is missing; give one of crt-p22, epaper-4grey, epaper-7color, laser-300, "
          "lcd-rgb565, offset-cmyk, srgb, vga16, or a file");
}

TEST_F(ProcessOptions, HintsAtTheNearestDevice) {
  const std::string rest = " (a file of your own: ./panel.toml; the list: tristim device list)";
  refuses("process s.exr -d srbg -o o.png", 2, "srbg: unknown device; did you mean srgb?" + rest);
  refuses("process s.exr -d laser -o o.png", 2,
          "laser: unknown device; did you mean laser-300?" + rest);
  refuses("process s.exr -d ./panel.toml -o o.png", 1,
          "./panel.toml: there is no such file; check the name");
}

TEST_F(ProcessOptions, RefusesNumbersThatAreNone) {
  const std::string stops = "give stops from -64 to 64, such as 1.5 or -2";
  for (const std::string value : {"nan", "abc", "inf", "65", "1,5", "", "0x10"}) {
    refuses_value("exposure", value, "'" + value + "' is no exposure; " + stops);
  }
  const std::string size = "give WIDTHxHEIGHT in pixels, or one of them: 800x480, 800x, x480";
  for (const std::string value : {"0x0", "-4x4", "4x4x4", "x", "99999999999999999999x4", "1.5x2"}) {
    refuses_value("size", value, "'" + value + "' is no size; " + size);
  }
  refuses_value("threads", "-1", "'-1' is out of range; give a whole number from 0 to 256");
  refuses_value("threads", "two", "'two' is no whole number; give a whole number from 0 to 256");
  refuses_value("png-level", "10", "'10' is out of range; give a whole number from 0 to 9");
  refuses_value("rotate", "45", "'45' is no rotation; give 0, 90, 180 or 270 degrees clockwise");
  refuses_value("tone-map", "reinhard:0",
                "'reinhard:0' is no tone map; give the luminance that becomes white, as in "
                "reinhard:8");
}

TEST_F(ProcessOptions, HintsAtTheNearestValue) {
  refuses_value("dither", "bayer9", "unknown dither 'bayer9'; did you mean bayer2?");
  refuses_value("dither", "floyd", "unknown dither 'floyd'; did you mean floyd-steinberg?");
  refuses_value("tone-map", "reinhardt", "unknown tone map 'reinhardt'; did you mean reinhard?");
  refuses_value("adapt", "bradfort", "unknown adaptation 'bradfort'; did you mean bradford?");
  refuses_value("gamut-map", "desat", "unknown gamut map 'desat'; did you mean desaturate?");
  refuses_value("metric", "oklap", "unknown metric 'oklap'; did you mean oklab?");
  refuses_value("mix", "lihgt", "unknown mix 'lihgt'; did you mean light?");
  refuses_value("mix", "x", "unknown mix 'x'; use one of: light, encoded");
  refuses_value("fit", "cotain", "unknown fit 'cotain'; did you mean contain?");
  refuses_value("filter", "lanczos3", "unknown filter 'lanczos3'; did you mean lanczos?");
  refuses_value("background", "redd", "'redd' is no colour; did you mean red?");
  refuses_value("palette", "median", "unknown palette 'median'; did you mean median-cut?");
}

TEST_F(ProcessOptions, RefusesPalettesThatTheDeviceCannotHold) {
  refuses("process s.exr -d srgb --palette median-cut:16 -o o.raw", 2,
          "--palette: packing rgb888 has no palette; choose a device with an indexed packing, or "
          "leave --palette out");
  refuses_value("palette", "median-cut:0",
                "'median-cut:0' is no palette; give the number of colours, 1 to 65536, as in "
                "best:16");
  refuses("process s.exr -d vga16 --palette median-cut:300 -o o.png", 2,
          "--palette: 300 colours do not fit packing index4; ask for 16 or less");
  refuses("process s.exr -d vga16 --palette fixed-332 -o o.png", 2,
          "--palette: 256 colours do not fit packing index4; ask for 16 or less");
}

TEST_F(ProcessOptions, RefusesLayersThatAreNotThere) {
  refuses("process s.exr -d srgb --layer diffuse -o o.png", 3,
          "s.exr: has no layer or channel called diffuse; it has B, G, R");
}

TEST_F(ProcessOptions, NamesIgnoreCaseUnderscoreAndHyphen) {
  good("process s.exr -d srgb --dither floyd-steinberg --tone-map reinhard -o a.png --quiet");
  good("process s.exr -d SRGB --dither FloydSteinberg --tone-map Rein_Hard -o b.png --quiet");
  EXPECT_EQ(read("a.png"), read("b.png"));
}

TEST_F(ProcessOptions, ReadsAPipelineFileThatOptionsOverride) {
  write("p.toml", "exposure = -2\ndither = \"bayer4\"\nserpentine = true\nsize = \"32x\"\n");
  good("process s.exr -d lcd-rgb565 --pipeline p.toml -o file.png --quiet");
  good(
      "process s.exr -d lcd-rgb565 --exposure -2 --dither bayer4 --size 32x -o options.png "
      "--quiet");
  EXPECT_EQ(read("file.png"), read("options.png"));
  good("process s.exr -d lcd-rgb565 --exposure 1 --pipeline p.toml -o over.png --quiet");
  good("process s.exr -d lcd-rgb565 --exposure 1 --dither bayer4 --size 32x -o one.png --quiet");
  EXPECT_EQ(read("over.png"), read("one.png"));
}

TEST_F(ProcessOptions, RefusesABadPipelineFileWithItsPlace) {
  const auto refuses_file = [&](const std::string& text, const std::string& line) {
    write("p.toml", text);
    refuses("process s.exr -d srgb --pipeline p.toml -o o.png", 3, line);
  };
  refuses_file("exposure = 1\ndihter = \"none\"\n",
               "p.toml:2:1: unknown key 'dihter'; did you mean dither?");
  refuses_file("dither = \"bayer9\"\n",
               "p.toml:1:10: unknown dither 'bayer9'; did you mean bayer2?");
  refuses_file("exposure = nan\n",
               "p.toml:1:12: 'nan' is no exposure; give stops from -64 to 64, such as 1.5 or -2");
  refuses("process s.exr -d srgb --pipeline no.toml -o o.png", 1,
          "no.toml: there is no such file; check the name");
}

}  // namespace
}  // namespace tristim
