#include <gtest/gtest.h>

#include "tests/error_text.h"
#include "tests/lut/io/tables.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

std::string refusal(const std::string& bytes, const std::string& file,
                    const LutFileOptions& options = {}) {
  return error_text([&] { parse_lut(bytes, file, "", options); });
}

/// Any bytes are a table or an Error of their content.
void expect_sane(const std::string& bytes, const LutFormat& format, const LutFileOptions& options) {
  try {
    check(parse_lut(bytes, "x", format.name, options));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kContent) << error.what();
  }
}

TEST(DamagedLuts, AreTablesOrRefused) {
  std::mt19937 generator(3);
  for (const LutFormat& format : lut_formats()) {
    SCOPED_TRACE(format.name);
    // OpenColorIO takes its time
    const int tries = format.name == "clf" || format.name == "ctf" ? 20 : 150;
    for (const bool cube : {false, true}) {
      if ((cube ? format.holds.cube : format.holds.curves) == 0) continue;
      const int size = !format.holds.sizes.empty() ? format.holds.sizes[0] : cube ? 3 : 16;
      const Lut lut{"t", {cube ? LutStep(test_cube(size, 0)) : LutStep(test_curves(size, 0))}};
      const LutFileOptions options{.cube = cube};
      const std::string good = lut_bytes(lut, format, "x", options);
      for (int i = 0; i < tries; ++i) {
        expect_sane(good.substr(0, generator() % good.size() + 1), format, options);
        std::string bad = good;
        for (int changes = 0; changes < 3; ++changes) {
          bad[generator() % bad.size()] = static_cast<char>(generator());
        }
        expect_sane(bad, format, options);
        bad = good;
        bad.insert(generator() % bad.size(), std::to_string(generator()));
        expect_sane(bad, format, options);
      }
    }
  }
}

TEST(DamagedLuts, PromisesOfATerabyteAreRefusedBeforeMemoryIsAskedFor) {
  EXPECT_EQ(
      refusal("LUT_3D_SIZE 256\n0 0 0\n", "x.cube"),
      "3 x.cube, row 2: promises 50331648 numbers, but only 6 bytes are there; write or copy it "
      "again");
  EXPECT_EQ(
      refusal("LUT_3D_SIZE 5000\n0 0 0\n", "x.cube"),
      "3 x.cube, row 1: '5000' is no number of points an edge; it is an integer from 2 to 256");
  EXPECT_EQ(
      refusal("Version 1\nFrom 0 1\nLength 1000000\nComponents 3\n{\n0 0 0\n}\n", "x.spi1d"),
      "3 x.spi1d, row 5: promises 3000000 numbers, but only 8 bytes are there; write or copy it "
      "again");
  EXPECT_EQ(
      refusal("SPILUT 1.0\n3 3\n9999 9999 9999\n", "x.spi3d"),
      "3 x.spi3d, row 3: '9999' is no number of points an edge; it is an integer from 2 to 256");
  EXPECT_EQ(
      refusal("SPILUT 1.0\n3 3\n250 250 250\n", "x.spi3d"),
      "3 x.spi3d, row 3: promises 93750000 numbers, but only 0 bytes are there; write or copy it "
      "again");
  EXPECT_EQ(
      refusal("CSPLUTV100\n1D\n2\n0 1\n0 1\n2\n0 1\n0 1\n2\n0 1\n0 1\n1000000\n0 0 0\n", "x.csp"),
      "3 x.csp, row 12: promises 3000000 numbers, but only 6 bytes are there; write or copy it "
      "again");
  EXPECT_EQ(
      refusal("x_size = 4000000,\nx_is_cube = 0,\nx_channels = 3,\nx_bits = 32, = {\n1,\n};\n",
              "x.h"),
      "3 x.h, byte 61: promises 12000000 numbers, but only 11 bytes follow");
  for (const char* size : {"100000 100000 100000 3", "4294967295 4294967295 2 3", "-1 -1 -1 3"}) {
    const std::string text =
        "<ProcessList id=\"x\" compCLFversion=\"3.0\"><LUT3D inBitDepth=\"32f\" "
        "outBitDepth=\"32f\"><Array dim=\"" +
        std::string(size) + "\">0 0 0</Array></LUT3D></ProcessList>";
    EXPECT_EQ(refusal(text, "x.clf").substr(0, 35), "3 x.clf: OpenColorIO cannot read it") << size;
  }
}

TEST(DamagedLuts, OddSizesAreRefused) {
  for (const char* size : {"0", "1", "-5", "1048576", "x", ""}) {
    EXPECT_EQ(refusal(std::string("LUT_3D_SIZE ") + size + "\n", "x.cube"),
              "3 x.cube, row 1: '" + std::string(size) +
                  "' is no number of points an edge; it is an integer from 2 to 256");
    EXPECT_EQ(refusal(std::string("LUT_1D_SIZE ") + size + "\n", "x.cube"),
              "3 x.cube, row 1: '" + std::string(size) +
                  "' is no number of entries; it is an integer from 2 to 65536");
  }
  EXPECT_EQ(refusal("0 0 0\n", "x.cube"),
            "3 x.cube, row 1: numbers come before a size; write LUT_3D_SIZE or LUT_1D_SIZE first");
  EXPECT_EQ(
      refusal(std::string(7, 'x'), "x.xrandr"),
      "3 x.xrandr: has 7 bytes, which is no gamma ramp; 256, 1024 and 4096 entries have 1536, "
      "6144, 24576 bytes");
  EXPECT_EQ(refusal(std::string(100, 'x'), "x.raw"),
            "3 x.raw: has 100 bytes, which is no table of 8 bits; curves have 3 bytes an entry");
  EXPECT_EQ(
      refusal(std::string(30, 'x'), "x.raw", {.cube = true}),
      "3 x.raw: has 30 bytes, which is no table of 8 bits; a cube has 3 bytes a colour, and 8, "
      "27, 64, ... colours");
}

TEST(DamagedLuts, SayTheRow) {
  EXPECT_EQ(refusal("LUT_1D_SIZE 2\n0 0 0\n\n1 nan 1\n", "x.cube"),
            "3 x.cube, row 4: 'nan' is no finite number");
  EXPECT_EQ(refusal("LUT_1D_SIZE 2\n0 0 0\n1 1e99 1\n", "x.cube"),
            "3 x.cube, row 3: '1e99' is no finite number");
  EXPECT_EQ(refusal("LUT_1D_SIZE 2\n0 0 0\n1 1\n", "x.cube"),
            "3 x.cube, row 3: a number is missing");
  EXPECT_EQ(refusal("LUT_1D_SIZE 2\n0 0 0\n1 1 1 1\n", "x.cube"),
            "3 x.cube, row 3: '1' is one thing too many");
  EXPECT_EQ(refusal("LUT_1D_SIZE 2\n0 0 0\n\n\n\n\n\n\n\n", "x.cube"),
            "3 x.cube, row 9: the file ends early; write or copy it again");
  EXPECT_EQ(refusal("LUT_1D_SIZE 2\n0 0 0\n1 1 1\n2 2 2\n", "x.cube"),
            "3 x.cube, row 4: there are more rows than the size says");
  EXPECT_EQ(refusal("LUT_1D_SIZE 2\nDOMAIN_MIN 1 0 0\n0 0 0\n1 1 1\n", "x.cube"),
            "3 x.cube: step 1: range 1 to 1; expected low < high");
  EXPECT_EQ(refusal("Lut_size 3\n", "x.cube"),
            "3 x.cube, row 1: 'Lut_size' is no keyword of a cube file; it has TITLE, LUT_1D_SIZE, "
            "LUT_3D_SIZE, DOMAIN_MIN, DOMAIN_MAX, LUT_1D_INPUT_RANGE and LUT_3D_INPUT_RANGE");
  EXPECT_EQ(refusal(std::string("SPILUT 1.0\n3 3\n2 2 2\n0 0 0 0 0 0\n0 0 0 1 1 1\n\n\n") +
                        std::string(99, ' '),
                    "x"),
            "3 x, row 5: the same place comes for the second time");
  EXPECT_EQ(refusal("Version 1\nFrom 0 1\nLength 3\nComponents 1\n{\n0\n1\n}\n", "x.spi1d"),
            "3 x.spi1d, row 8: there are fewer rows than Length says");
  EXPECT_EQ(
      refusal("0 1 2 3\n0 0 0\n1 1 1\n", "x.3dl"),
      "3 x.3dl, row 3: the file has 2 colours; a cube has 8, 27, 64, ... of them, 2 to 256 an "
      "edge");
  EXPECT_EQ(refusal("0 1 2 3\n0 0 70000\n", "x.3dl"),
            "3 x.3dl, row 2: '70000' is no code; it is an integer from 0 to 65535");
  EXPECT_EQ(refusal("CSPLUTV100\n3D\n3\n0 2 1\n0 1 1\n", "x"),
            "3 x, row 4: the points do not ascend");
  EXPECT_EQ(
      refusal("0 0 0\n1 2 65536\n", "x.ramp"),
      "3 x.ramp, row 2: '65536' is no code of a gamma ramp; it is an integer from 0 to 65535");
  const auto header = [](const char* channels, const char* bits) {
    return std::string("x_size = 2, x_is_cube = 0, x_channels = ") + channels +
           ", x_bits = " + bits + ",\nx[2] = {\n0,\n1,\n};\n";
  };
  EXPECT_EQ(refusal(header("1", "31"), "x.h"),
            "3 x.h, byte 44: has 31 bits; integers have 8 to 16, floats 32");
  EXPECT_EQ(refusal(header("2", "8"), "x.h"),
            "3 x.h, byte 44: has two channels; it is one or three");
  EXPECT_EQ(refusal(header("3", "8"), "x.h"),
            "3 x.h, byte 71: the array ends after 2 of 6 numbers");
  EXPECT_EQ(refusal("in,out\n0,0\n1\n", "x.csv"), "3 x.csv, row 3: has 1 cells; a row has 2 here");
  EXPECT_EQ(refusal("in,out\n0,0\n1,NaN\n", "x.csv"), "3 x.csv, row 3: 'NaN' is no finite number");
  EXPECT_EQ(refusal("a,b\n", "x.csv"),
            "3 x.csv, row 1: is no head of a table; write in,out or in,red,green,blue or "
            "red_in,red,green_in,green,blue_in,blue or red_in,green_in,blue_in,red,green,blue");
  EXPECT_EQ(refusal("{\"steps\": [{\"kind\": \"cube\", \"size\": 1e9}]}", "x.json"),
            "3 x.json, step 1: has no size; it is an integer from 2 to 256");
  EXPECT_EQ(refusal("{\"steps\": [{\"kind\": \"curves\", \"size\": 3, \"rgb\": [1]}]}", "x.json"),
            "3 x.json: step 1: has 1 numbers; expected 9");
  EXPECT_EQ(refusal("{\"steps\": ", "x.json"), "3 x.json, byte 11: is not valid JSON");
  EXPECT_EQ(refusal("x", "x.icc"), "3 x.icc: is no ICC profile, or damaged");
  EXPECT_EQ(refusal("", "x.cube"), "3 x.cube: is empty; write or copy it again");
  EXPECT_EQ(refusal("<ProcessList", "x.clf").substr(0, 35), "3 x.clf: OpenColorIO cannot read it");
}

}  // namespace
}  // namespace tristim
