#include <gtest/gtest.h>

#include <clocale>

#include "tests/error_text.h"
#include "tests/lut/io/tables.h"
#include "tests/support.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

const LutFormat& format(std::string_view name) { return *find_by_name(lut_formats(), name); }

/// How a table of the format is to be read where the bytes do not say it.
LutFileOptions options_of(const LutFormat& format, const Lut& lut) {
  LutFileOptions options;
  if (format.name == "raw") {
    options.cube = !lut.steps.empty() && std::holds_alternative<Lut3D>(lut.steps[0]);
  }
  return options;
}

bool is_xml(const LutFormat& format) { return format.name == "clf" || format.name == "ctf"; }

TEST(LutFormats, ReadBackEveryBitThatTheyWrote) {
  for (const LutFormat& format : lut_formats()) {
    for (const Lut& lut : test_luts(format)) {
      SCOPED_TRACE(std::string(format.name) + " with " + std::to_string(lut.steps.size()));
      ASSERT_TRUE(holds(format, lut));
      const LutFileOptions options = options_of(format, lut);
      const std::string bytes = lut_bytes(lut, format, "x", options);
      const Lut read = parse_lut(bytes, "x", format.name, options);
      if (is_xml(
              format)) {  // ranges become matrices; 6e-8 is half a bit of the largest float near 1
        EXPECT_LE(largest_difference(read, lut), 2e-7);
      } else {
        EXPECT_EQ(read.steps, lut.steps);
      }
    }
  }
}

TEST(LutFormats, AreTold) {
  for (const LutFormat& format : lut_formats()) {
    SCOPED_TRACE(format.name);
    const Lut lut = test_luts(format).front();
    const LutFileOptions options = options_of(format, lut);
    const std::string bytes = lut_bytes(lut, format, "x", options);
    const std::string extension(format.extensions.substr(0, format.extensions.find(' ')));
    EXPECT_EQ(parse_lut(bytes, "x." + extension, "", options).steps.size(), lut.steps.size());
    if (format.begins != nullptr) EXPECT_EQ(parse_lut(bytes, "x").steps, lut.steps);
    if (format.name != "resolve") EXPECT_EQ(&lut_format_of("x." + extension), &format);
  }
  EXPECT_EQ(error_text([] { lut_format_of("x.jpg"); }),
            "2 x.jpg: has no extension that tells a table's format; use one of: cube spi1d spi3d "
            "3dl csp clf ctf png icc icm ramp xrandr drm raw bin h c inc hpp hxx hh json csv");
  EXPECT_EQ(error_text([] { lut_format_of("x", "cub"); }),
            "2 --format: unknown format 'cub'; did you mean cube?");
  EXPECT_EQ(
      error_text([] { parse_lut("1", "x"); }),
      "3 x: is no table of a known format; give one of: cube, resolve, spi1d, spi3d, 3dl, csp, "
      "clf, ctf, hald, icc, ramp, xrandr, drm, raw, c, cpp, json, csv");
}

TEST(LutFormats, KeepTitles) {
  const Lut lut{"Sea & <sky> \"1\"", {test_cube(2, 0)}};
  const auto title = [&](const char* name) {
    return parse_lut(lut_bytes(lut, format(name), "x"), "x", name).title;
  };
  EXPECT_EQ(title("json"), lut.title);
  for (const char* name : {"cube", "csp", "clf", "ctf"}) {
    EXPECT_EQ(title(name), "Sea & <sky> '1'") << name;
  }
  EXPECT_EQ(parse_lut(lut_bytes({"", lut.steps}, format("cube"), "a/sea.cube"), "x", "cube").title,
            "sea");
}

TEST(LutFormats, SayWhatTheyHold) {
  const Lut both{"", {test_shaper(8, 0), test_cube(2, 0)}};
  EXPECT_EQ(
      error_text([&] { lut_bytes(both, format("spi3d"), "x.spi3d"); }),
      "2 x.spi3d: format spi3d does not hold the table as it stands; it holds a cube of 2 to 256 "
      "points an edge over 0 to 1; sample the table with --size");
  const Lut curves{"", {test_curves(100, 0)}};
  EXPECT_EQ(
      error_text([&] { lut_bytes(curves, format("xrandr"), "x"); }),
      "2 x: format xrandr does not hold the table as it stands; it holds curves of 256, 1024, "
      "4096 entries over 0 to 1; sample the table with --size");
  EXPECT_EQ(error_text([&] { lut_bytes(curves, format("cube"), "x", {.bits = 12}); }),
            "2 --bits: format cube has no choice of bits; leave it out");
  EXPECT_EQ(error_text([&] { lut_bytes(curves, format("raw"), "x", {.bits = 7}); }),
            "2 --bits: 7 is out of range; give 8 to 16");
  EXPECT_EQ(error_text([&] { lut_bytes(curves, format("raw"), "x", {.one_curve = true}); }),
            "2 x: the channels differ, so one curve is not all of them; write all three");
}

TEST(LutFormats, IntegersOfAllBitsComeBack) {
  for (const char* name : {"raw", "3dl", "c", "cpp"}) {
    for (int bits = 8; bits <= 16; ++bits) {
      SCOPED_TRACE(name + std::to_string(bits));
      const Lut lut{"t", {test_cube(5, bits)}};
      const LutFileOptions options{.bits = bits, .cube = true};
      const std::string bytes = lut_bytes(lut, format(name), "x", options);
      const bool chooses = format(name).holds.bits != 0;
      EXPECT_EQ(parse_lut(bytes, "x", name, chooses ? options : LutFileOptions{}).steps, lut.steps);
    }
  }
  const Lut hald{"t", {test_cube(16, 8)}};
  const std::string bytes = lut_bytes(hald, format("hald"), "x", {.bits = 8});
  EXPECT_EQ(parse_lut(bytes, "x").steps, hald.steps);
}

TEST(LutFormats, ValuesBeyondIntegersAreClipped) {
  const Lut lut{"", {Lut1D{{}, 2, {-1, 0.5F, 2, 1, 0.25F, 0}}}};
  const Lut read = parse_lut(lut_bytes(lut, format("raw"), "x"), "x", "raw");
  const auto code = [](int c) { return static_cast<float>(c) / 255.0F; };
  EXPECT_EQ(std::get<Lut1D>(read.steps[0]).rgb,
            (std::vector<float>{0, code(128), 1, 1, code(64), 0}));
}

TEST(LutFormats, DoNotDependOnTheLocale) {
  std::vector<std::string> plain;
  for (const LutFormat& format : lut_formats()) {
    plain.push_back(lut_bytes(test_luts(format).back(), format, "x"));
  }
  const std::string before = std::setlocale(LC_ALL, nullptr);
  bool present = false;
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8"}) {
    present = present || std::setlocale(LC_ALL, name) != nullptr;
  }
  std::size_t i = 0;
  for (const LutFormat& format : lut_formats()) {
    const Lut lut = test_luts(format).back();
    const std::string bytes = lut_bytes(lut, format, "x");
    EXPECT_EQ(bytes, plain[i++]) << format.name;
    if (format.name == "raw") continue;
    EXPECT_EQ(parse_lut(bytes, "x", format.name).steps.size(), lut.steps.size()) << format.name;
  }
  std::setlocale(LC_ALL, before.c_str());
  if (!present) GTEST_SKIP() << "no locale with a decimal comma is installed";
}

TEST(LutFormats, TextsOfOthers) {
  const Lut resolve = parse_lut(
      "# made elsewhere\r\nLUT_1D_SIZE 2\r\nLUT_1D_INPUT_RANGE -1 2\r\nLUT_3D_SIZE 2\r\n"
      "LUT_3D_INPUT_RANGE 0 1\r\n0 0 0\r\n1 1 1\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n1 1 0\r\n0 0 1\r\n"
      "1 0 1\r\n0 1 1\r\n1 1 1\r\n",
      "a.cube");
  ASSERT_EQ(resolve.steps.size(), 2u);
  EXPECT_EQ(std::get<Lut1D>(resolve.steps[0]).range, (LutRange{{-1, -1, -1}, {2, 2, 2}}));
  EXPECT_EQ(evaluate(resolve, {0.5, -1, 2}), (Rgb{0.5, 0, 1}));

  const Lut flame = parse_lut(
      "0 512 1023 1023\n0 0 0\n0 0 4095\n0 4095 0\n0 4095 4095\n4095 0 0\n"
      "4095 0 4095\n4095 4095 0\n4095 4095 4095\n",
      "a.3dl");
  ASSERT_EQ(flame.steps.size(), 2u) << "the curve bends";
  EXPECT_EQ(std::get<Lut3D>(flame.steps[1]).rgb[3], 1)
      << "red is slowest in the file, fastest here";

  const Lut two =
      parse_lut("Version 1\nFrom 0 2\nLength 2\nComponents 2\n{\n0 1\n1 0\n}\n", "a.spi1d");
  EXPECT_EQ(evaluate(two, {1, 0.5, 1}), (Rgb{0.5, 0.75, 0}));
}

// What the Common LUT Format has besides tables: ranges that clamp or do not, half floats as index.
TEST(LutFormats, ClfOfOthers) {
  const auto clf = [](const std::string& nodes) {
    return parse_lut("<?xml version=\"1.0\"?><ProcessList id=\"a\" compCLFversion=\"3.0\">\n" +
                         nodes + "\n</ProcessList>\n",
                     "x.clf");
  };
  const std::string depths = " inBitDepth=\"32f\" outBitDepth=\"32f\"";
  const std::string ends =
      "<minInValue>0.25</minInValue><maxInValue>0.75</maxInValue><minOutValue>0</minOutValue>"
      "<maxOutValue>2</maxOutValue></Range>";
  const Lut clamped = clf("<Range" + depths + ">" + ends);
  EXPECT_EQ(evaluate(clamped, {0, 0.5, 1}), (Rgb{0, 1, 2}));
  const Lut free = clf("<Range" + depths + " style=\"noClamp\">" + ends);
  EXPECT_EQ(evaluate(free, {0, 0.5, 1}), (Rgb{-1, 1, 3}));
  const Lut floor = clf("<Range" + depths +
                        "><minInValue>0.5</minInValue><minOutValue>0.5</minOutValue></Range>");
  const Rgb out = evaluate(floor, {0.25, 0.75, 1000});
  EXPECT_EQ(out.r, 0.5);
  EXPECT_NEAR(out.g, 0.75, 1e-6);
  EXPECT_NEAR(out.b, 1000, 1e-3);

  std::string table = "<LUT1D" + depths + " halfDomain=\"true\"><Array dim=\"65536 1\">";
  for (int i = 0; i < 65536; ++i)
    table += i < 0x7c00 ? " 0.5" : i > 0x8000 && i < 0xfc00 ? " -2" : " 0";
  const Lut halfs = clf(table + "</Array></LUT1D>");
  ASSERT_TRUE(std::holds_alternative<LutPoints>(halfs.steps[0]));
  const LutCurve& curve = std::get<LutPoints>(halfs.steps[0]).curves[0];
  EXPECT_EQ(curve.in.front(), -65504);
  EXPECT_EQ(curve.in.back(), 65504);
  EXPECT_EQ(evaluate(halfs, {-1, 1, 1e6}), (Rgb{-2, 0.5, 0.5}));

  EXPECT_EQ(error_text([&] { clf("<Log" + depths + " style=\"log2\"></Log>"); }),
            "3 x.clf: has a step that is no table, matrix or range; bake it: make it a view of a "
            "config, and tristim lut bake --ocio");
}

}  // namespace
}  // namespace tristim
