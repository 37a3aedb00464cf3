#include <lcms2.h>

#include "tests/tools/command_test.h"
#include "tristim/core/find.h"
#include "tristim/image/io/read.h"
#include "tristim/image/memory.h"
#include "tristim/lut/io/file.h"

namespace tristim {
namespace {

class LutFilesCommand : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    write("c.cube", "LUT_1D_SIZE 3\n0 0 0\n0.2 0.25 0.3\n1 1 1\n");
    std::string cube = "LUT_3D_SIZE 2\n";
    for (const char* row :
         {"0 0 0", "1 0.1 0", "0 1 0", "1 1 0", "0 0 1", "1 0 1", "0 1 1", "1 1 1"}) {
      cube += std::string(row) + "\n";
    }
    write("k.cube", cube);
  }
  Lut table(const std::string& name) const { return read_lut(file(name)); }
};

TEST_F(LutFilesCommand, ConvertsIntoEveryFormatThatHoldsTheTable) {
  for (const LutFormat& format : lut_formats()) {
    SCOPED_TRACE(format.name);
    const std::string out =
        "o." + std::string(format.extensions.substr(0, format.extensions.find(' ')));
    for (const char* in : {"c.cube", "k.cube"}) {
      const Lut lut = table(in);
      if (!holds(format, lut)) continue;
      good(std::string("lut convert ") + in + " " + out + " --force --format " +
           std::string(format.name));
      LutFileOptions options;
      options.cube = in[0] == 'k';
      const Lut back = parse_lut(read(out), out, format.name, options);
      EXPECT_EQ(back.steps.size(), 1u);
      const double tolerance = format.holds.bits == 0 ? 0 : 0.5001 / ((1 << format.holds.bits) - 1);
      const Rgb a = evaluate(lut, {0.5, 0.5, 0.5});
      const Rgb b = evaluate(back, {0.5, 0.5, 0.5});
      EXPECT_NEAR(a.g, b.g, tolerance + 1e-7);
    }
  }
}

TEST_F(LutFilesCommand, SamplesWhereASizeIsGiven) {
  const CommandResult done = run("lut convert c.cube c.ramp --size 256");
  EXPECT_EQ(done.exit_code, 0);
  EXPECT_EQ(
      done.err,
      "tristim: c.ramp: note: sampled as curves of 256 entries, rounded to 16 bits; values differ "
      "by up to 0.0012\n");
  EXPECT_EQ(std::get<Lut1D>(table("c.ramp").steps[0]).size, 256);
  good("lut convert k.cube k.png --size 16");
  EXPECT_EQ(std::get<Lut3D>(table("k.png").steps[0]).size, 16);
  const nlohmann::json facts = parsed(good("lut convert k.cube k.3dl --size 17 --bits 16 --json"));
  EXPECT_EQ(facts["format"], "3dl");
  EXPECT_EQ(facts["stored"], "a cube of 17 points an edge");
  EXPECT_LT(facts["largest_difference"].get<double>(), 1e-5);
}

TEST_F(LutFilesCommand, SaysWhatAFormatHolds) {
  refuses("lut convert c.cube c.ramp", 2,
          "c.ramp: format ramp does not hold the table as it stands; it holds curves of 256, 1024, "
          "4096 "
          "entries over 0 to 1; sample the table with --size");
  refuses(
      "lut convert k.cube k.spi1d --size 9", 2,
      "k.spi1d: format spi1d has curves alone, and channels of the table depend on others; use a "
      "format that has cubes");
  refuses(
      "lut convert k.cube k.xyz", 2,
      "k.xyz: has no extension that tells a table's format; use one of: cube spi1d spi3d 3dl csp "
      "clf ctf png icc icm ramp xrandr drm raw bin h c inc hpp hxx hh json csv");
  refuses("lut convert k.cube k --format spi33d", 2,
          "--format: unknown format 'spi33d'; did you mean spi3d?");
  refuses("lut convert no.cube k.csp", 1,
          "no.cube: cannot be opened: no such file or directory; check the path");
  refuses("lut convert k.cube k.csp --bits 12", 2,
          "--bits: format csp has no choice of bits; leave it out");
  write("bad.cube", "LUT_3D_SIZE 256\n0 0 0\n");
  refuses(
      "lut convert bad.cube k.csp", 3,
      "bad.cube, row 2: promises 50331648 numbers, but only 6 bytes are there; write or copy it "
      "again");
}

TEST_F(LutFilesCommand, ReadsBytesAsToldAndStandardInput) {
  good("lut convert k.cube k.raw --bits 10");
  EXPECT_EQ(read("k.raw").size(), 48u);
  good("lut convert k.raw k.json --cube --from-bits 10");
  EXPECT_EQ(std::get<Lut3D>(table("k.json").steps[0]).rgb[3], 1);
  const std::string text =
      good("lut convert - - --from cube --format csv", {.input = read("c.cube")});
  EXPECT_EQ(text, "in,red,green,blue\n0,0,0,0\n0.5,0.2,0.25,0.3\n1,1,1,1\n");
}

TEST_F(LutFilesCommand, NumbersIgnoreTheLocale) {
  for (const char* name : {"c.spi1d", "c.csp", "c.json", "c.h", "c.csv"}) {
    good(std::string("lut convert c.cube ") + name + " --force");
    const std::string plain = read(name);
    good(std::string("lut convert c.cube ") + name + " --force",
         {.variables = {"LC_ALL=de_DE.UTF-8"}});
    EXPECT_EQ(read(name), plain);
    EXPECT_EQ(plain.find("0,2"), std::string::npos) << name;
  }
}

TEST_F(LutFilesCommand, HeadersCompileAndHoldTheNumbers) {
  good("lut convert c.cube lut8.h --size 256 --bits 8 --progmem");
  good("lut convert k.cube cube.hpp");
  write("a.c",
        "#include \"lut8.h\"\nint main(void) { return lut8[255][2] == 255 && lut8_size == 256 ? 0 "
        ": 1; }\n");
  write("b.cpp", "#include \"cube.hpp\"\nint main() { return cube[1][1] == 0.1f ? 0 : 1; }\n");
  const CommandResult c = shell("cc -std=c99 -Wall -Wextra -Werror a.c -o a && ./a");
  if (c.exit_code == 127) GTEST_SKIP() << "no C compiler";
  EXPECT_EQ(c.exit_code, 0) << c.err;
  const CommandResult cpp = shell("c++ -std=c++17 -Wall -Wextra -Werror b.cpp -o b && ./b");
  EXPECT_EQ(cpp.exit_code, 0) << cpp.err;
}

TEST_F(LutFilesCommand, ListsFormats) {
  const nlohmann::json all = parsed(good("lut formats --json"));
  ASSERT_EQ(all.size(), lut_formats().size());
  EXPECT_EQ(all[0]["name"], "cube");
  const std::string text = good("lut formats");
  for (const LutFormat& format : lut_formats()) {
    EXPECT_NE(text.find(std::string(format.name) + " (."), std::string::npos) << format.name;
  }
}

class OcioConfigCommand : public CommandTest {
 protected:
  bool has(const char* program) const {
    return shell(std::string("command -v ") + program).exit_code == 0;
  }
  Image picture(const std::string& name, bool codes) const {
    const auto source = open_picture(file(name), {.codes = codes});
    Image image(source->info().width, source->info().height, source->info().channels);
    source->read(image.view());
    return image;
  }
};

TEST_F(OcioConfigCommand, WritesEveryDevice) {
  const nlohmann::json facts = parsed(good("lut ocio-config -o config.ocio --json"));
  EXPECT_EQ(facts["displays"].size(), std::size(kDevices));
  for (const auto& name : facts["files"]) EXPECT_TRUE(exists(name.get<std::string>()));
  refuses("lut ocio-config -o config.ocio", 1,
          "config.ocio: exists already; give --force to replace it");
  refuses("lut ocio-config -o -", 2,
          "--output: a config has files beside it; give -o config.ocio, or another name");
  refuses("lut ocio-config srgb ./srgb.toml -o x.ocio", 2,
          "./srgb.toml: a display called srgb is there already; give the file another name");
  if (!has("ociocheck")) GTEST_SKIP() << "no ociocheck";
  EXPECT_EQ(shell("ociocheck --iconfig config.ocio").exit_code, 0);
}

// One code of 8 bits, and 1e-4 in floats, which are halfs in the file: 2.5e-4.
TEST_F(OcioConfigCommand, OcioconvertMakesWhatProcessMakes) {
  if (!has("ocioconvert")) GTEST_SKIP() << "no ocioconvert";
  good("lut ocio-config srgb crt-p22 -o config.ocio");
  for (const std::string device : {"srgb", "crt-p22"}) {
    SCOPED_TRACE(device);
    good("process s.exr -d " + device + " --dither none --force -o ours.png --quiet");
    const std::string space = " 'Linear sRGB' theirs.png '" + device + " Codes'";
    ASSERT_EQ(shell("OCIO=$PWD/config.ocio ocioconvert s.exr" + space).exit_code, 0);
    const Image ours = picture("ours.png", true);
    const Image theirs = picture("theirs.png", true);
    double most = 0;
    for (int y = 0; y < 36; ++y) {
      const auto a = ours.view().row(y);
      const auto b = theirs.view().row(y);
      for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max<double>(most, std::fabs(a[i] - b[i]));
    }
    EXPECT_LE(most * 255, 1.001);
  }
}

TEST_F(OcioConfigCommand, IsBakedByDisplayAndBySpaces) {
  good("lut ocio-config srgb crt-p22 -o config.ocio");
  const auto display = parsed(good("lut bake --ocio config.ocio --display srgb --json -o d.cube"));
  EXPECT_LE(display["ciede2000"]["largest"].get<double>(), 0.2);
  good({"lut", "bake", "--ocio", "config.ocio", "--from-space", "Linear sRGB", "--to-space",
        "srgb Codes", "-o", "s.cube"});
  EXPECT_EQ(read_lut(file("d.cube")).steps, read_lut(file("s.cube")).steps);
  const Rgb half = evaluate(read_lut(file("d.cube")), {0.2140411, 0.2140411, 0.2140411});
  EXPECT_NEAR(half.g, 0.5, 1e-3);
  refuses("lut bake --ocio config.ocio --display crt -o x.cube", 2,
          "--display: config.ocio has no 'crt'; did you mean crt-p22? It has srgb, crt-p22");
  EXPECT_FALSE(exists("x.cube"));
}

}  // namespace
}  // namespace tristim
