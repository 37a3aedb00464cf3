#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/error_text.h"
#include "tests/support.h"
#include "tristim/core/find.h"
#include "tristim/palette/io/file.h"

namespace tristim {
namespace {

using std::string_literals::operator""s;

const PaletteFormat& format(std::string_view name) {
  return *find_by_name(palette_formats(), name);
}

std::string bytes_of(const Palette& palette, const PaletteFormat& format) {
  return palette_bytes(palette, format, "p." + std::string(format.extensions.substr(0, 3)));
}

Palette parsed(const std::string& bytes, const std::string& file) {
  return parse_palette(bytes, file);
}

std::string refusal(const std::string& bytes, const std::string& file) {
  return error_text([&] { parse_palette(bytes, file); });
}

/// Colours of all depths, with whatever an entry can have.
Palette test_palette(const PaletteFormat& format, std::size_t count) {
  std::mt19937 generator(static_cast<unsigned>(count));
  Palette palette{"A palette", {}};
  const int most = format.bits == 8 ? 255 : 65535;
  for (std::size_t i = 0; i < count; ++i) {
    const auto channel = [&] {
      const double code = static_cast<int>(generator() % 65536) % (most + 1);
      return format.bits == 0 ? std::sqrt(code / most) : code / most;
    };
    PaletteColor color{{channel(), channel(), channel()}};
    if (format.keeps_names) color.name = "colour " + std::to_string(i) + ", \u00e9";
    if (format.keeps_alpha && i % 3 == 1) color.alpha = static_cast<int>(generator() % 255) / 255.0;
    if (format.keeps_codes) color.code = static_cast<std::uint16_t>(count - i);
    palette.colors.push_back(color);
  }
  return palette;
}

TEST(PaletteFormats, ReadBackWhatTheyWrote) {
  for (const PaletteFormat& format : palette_formats()) {
    for (const std::size_t count : {1u, 2u, 7u, 16u, 255u, 256u}) {
      SCOPED_TRACE(std::string(format.name) + " with " + std::to_string(count));
      const Palette palette = test_palette(format, count);
      const std::string bytes = bytes_of(palette, format);
      EXPECT_EQ(parse_palette(bytes, "p", format.name).colors, palette.colors);
    }
  }
}

TEST(PaletteFormats, AreTold) {
  for (const PaletteFormat& format : palette_formats()) {
    SCOPED_TRACE(format.name);
    const Palette palette = test_palette(format, 5);
    const std::string bytes = bytes_of(palette, format);
    const std::string extension(format.extensions.substr(0, format.extensions.find(' ')));
    EXPECT_EQ(parsed(bytes, "p." + extension).colors, palette.colors);
    if (format.begins != nullptr) EXPECT_EQ(parsed(bytes, "p").colors, palette.colors);
    if (format.name != "riff") EXPECT_EQ(&palette_format_of("x." + extension), &format);
  }
  EXPECT_EQ(
      error_text([] { palette_format_of("x.jpg"); }),
      "2 x.jpg: has no extension that tells a palette's format; use one of: gpl hex txt act aco "
      "ase pal csv json toml png h hpp c inc");
  EXPECT_EQ(error_text([] { palette_format_of("x", "gpll"); }),
            "2 --format: unknown format 'gpll'; did you mean gpl?");
}

TEST(PaletteFormats, SayTheLimit) {
  const Palette palette = test_palette(format("act"), 300);
  for (const char* name : {"act", "png"}) {
    EXPECT_EQ(error_text([&] { palette_bytes(palette, format(name), "x"); }),
              "2 x: a palette of 300 colours, but format " + std::string(name) +
                  " holds at most 256; use fewer colours or another format");
  }
  EXPECT_EQ(error_text([&] { palette_bytes({}, format("gpl"), "x"); }),
            "2 x: the palette has no colours");
  EXPECT_EQ(refusal("JASC-PAL\n0100\n70000\n", "x.pal"),
            "3 x.pal, row 3: '70000' is no number of colours up to 65536");
}

TEST(PaletteFormats, TextsOfOthers) {
  const Palette gpl = parsed(
      "GIMP Palette\r\nName: Sea\r\nColumns: 2\r\n# c\r\n  0  10 255\tDeep one\r\n"
      "255 255 255 Untitled\r\n",
      "a.gpl");
  EXPECT_EQ(gpl.name, "Sea");
  ASSERT_EQ(gpl.colors.size(), 2u);
  EXPECT_EQ(gpl.colors[0].name, "Deep one");
  EXPECT_EQ(hex_text(gpl.colors[0].color), "#000aff");
  EXPECT_EQ(gpl.colors[1].name, "");

  const Palette hex = parsed("ff8000\n#00f # blue\nnavy, #11223380\n", "a.hex");
  ASSERT_EQ(hex.colors.size(), 4u);
  EXPECT_EQ(hex_text(hex.colors[0].color), "#ff8000");
  EXPECT_EQ(hex_text(hex.colors[1].color), "#0000ff");
  EXPECT_EQ(hex.colors[2].name, "navy");
  EXPECT_EQ(hex.colors[3].alpha, 128 / 255.0);

  const Palette jasc = parsed("JASC-PAL\r\n0100\r\n2\r\n1 2 3\r\n4 5 6\r\n", "a.pal");
  EXPECT_EQ(hex_text(jasc.colors[1].color), "#040506");

  const Palette bare = parsed("255,0,0,warm red\n0,0,255,\"blue, cold\"\n", "a.csv");
  EXPECT_EQ(bare.colors[0].name, "warm red");
  EXPECT_EQ(bare.colors[1].name, "blue, cold");
  EXPECT_EQ(hex_text(bare.colors[0].color), "#ff0000");
  const Palette units = parsed("name,r,g,b\nmid,0.5,0.5,1\n", "a.csv");
  EXPECT_EQ(units.colors[0].color, (EncodedRgb{0.5, 0.5, 1}));
  EXPECT_EQ(hex_text(parsed("#ff0000,warm\n", "a.csv").colors[0].color), "#ff0000");

  const Palette json =
      parsed(R"(["#ff0000", [0, 255, 0], [0.5, 0.5, 0.5, 0.25], {"hex": "teal"}])", "a");
  ASSERT_EQ(json.colors.size(), 4u);
  EXPECT_EQ(json.colors[2].color, (EncodedRgb{0.5, 0.5, 0.5}));
  EXPECT_EQ(json.colors[2].alpha, 0.25);
  EXPECT_EQ(hex_text(json.colors[3].color), "#008080");
}

TEST(PaletteFormats, SwatchesOfOtherModels) {
  const auto be16 = [](int v) {
    return std::string{static_cast<char>(v >> 8), static_cast<char>(v)};
  };
  const std::string aco = be16(1) + be16(4) +                                            //
                          be16(1) + be16(21845) + be16(65535) + be16(65535) + be16(0) +  // green
                          be16(2) + be16(0) + be16(65535) + be16(65535) + be16(65535) +  // cyan ink
                          be16(7) + be16(10000) + be16(0) + be16(0) + be16(0) +          // white
                          be16(8) + be16(5000) + be16(0) + be16(0) + be16(0);
  const Palette swatches = parsed(aco, "a.aco");
  ASSERT_EQ(swatches.colors.size(), 4u);
  EXPECT_EQ(hex_text(swatches.colors[0].color), "#00ff00");
  EXPECT_EQ(hex_text(swatches.colors[1].color), "#00ffff");
  EXPECT_EQ(hex_text(swatches.colors[2].color), "#ffffff");
  EXPECT_EQ(hex_text(swatches.colors[3].color), "#808080");

  const std::string grey = "\0\x01\0\0\0\x0e\0\x01\0\0Gray\x3f\0\0\0\0\x02"s;  // .5
  const std::string ase = "ASEF\0\x01\0\0\0\0\0\x01"s + grey;
  EXPECT_EQ(hex_text(parsed(ase, "a.ase").colors[0].color), "#808080");
  EXPECT_EQ(refusal("\0\x01\0\x01\0\x63\0\0\0\0\0\0\0\0"s, "a.aco"),
            "3 a.aco, byte 14: a colour of the unknown model 99; RGB, HSB, CMYK, Lab and grey are "
            "read");
}

TEST(PaletteFormats, DeviceFiles) {
  const std::string text =
      "name = \"Panel\"\n[frame_buffer]\npacking = \"index2\"\n[viewing]\nwhite = \"D50\"\n"
      "[[palette]]\ncode = 2\nlab = [100, 0, 0]\nname = \"paper\"\n[[palette]]\ncode = 1\n"
      "rgb = [255, 0, 0]\n";
  const Palette palette = parsed(text, "panel.toml");
  EXPECT_EQ(palette.name, "Panel");
  EXPECT_EQ(hex_text(palette.colors[0].color), "#ffffff");
  EXPECT_EQ(palette.colors[0].code, 2);
  EXPECT_EQ(palette.colors[1].color, (EncodedRgb{1, 0, 0}));
  EXPECT_EQ(refusal("[[palette]]\nrgb = [1, 2]\n", "p.toml"),
            "3 p.toml:2:7: rgb must have three numbers");
  EXPECT_EQ(refusal("[[palette]]\nrgb = [1, 2, 3]\ncolour = 1\n", "p.toml").substr(0, 12),
            "3 p.toml:3:1");
}

TEST(PaletteFormats, TellThePlace) {
  EXPECT_EQ(refusal("GIMP Palette\n0 0 0 black\n0 300 0 x\n", "a.gpl"),
            "3 a.gpl, row 3: '300' is no code from 0 to 255; write red green blue name");
  EXPECT_EQ(refusal("red\nredd\n", "a.hex"),
            "3 a.hex, row 2: 'redd' is no colour; did you mean red?");
  EXPECT_EQ(refusal("JASC-PAL\n0100\n2\n0 0 0\n", "a.pal"),
            "3 a.pal: says that it has 2 colours, but has 1; write or copy it again");
  EXPECT_EQ(refusal("hex,name\n#ff000,x\n", "a.csv"),
            "3 a.csv, row 2: '#ff000' is no colour; write #rrggbb");
  EXPECT_EQ(
      refusal("name,code\nx,1\n", "a.csv"),
      "3 a.csv, row 1: the heading has no column of colours; name red, green and blue, or hex");
  EXPECT_EQ(refusal("{\"colors\": [", "a.json"), "3 a.json, byte 13: is not valid JSON");
  EXPECT_EQ(refusal("[\"red\", 7]", "a.json"),
            "3 a.json, colour 1: is no colour; write \"#rrggbb\" or {\"rgb\": [r, g, b]}");
  EXPECT_EQ(refusal(std::string(700, 'a'), "a.act"),
            "3 a.act: is 700 bytes long, a colour table has 768 or 772; write or copy it again");
  EXPECT_EQ(refusal("ASEF\0\1\0\0"s, "a.ase"),
            "3 a.ase, byte 8: the file ends early; write or copy it again");
  EXPECT_EQ(refusal("RIFF\0\0\0\0WAVE"s, "a.pal"),
            "3 a.pal, byte 12: is a RIFF file, but not of a palette");
  EXPECT_EQ(refusal("  {1, 2, 300},\n", "a.h"),
            "3 a.h, row 1: is no colour; write {red, green, blue}, each 0 to 255");
  EXPECT_EQ(refusal("", "a.gpl"), "3 a.gpl: is empty; write or copy it again");
  EXPECT_EQ(refusal("GIMP Palette\n", "a.gpl"), "3 a.gpl: holds no colours");
  EXPECT_EQ(refusal("\x01\x02\x03", "a.xyz").substr(0, 46),
            "3 a.xyz: is no palette of a known format; give");
  EXPECT_EQ(error_text([] { read_palette("nowhere.gpl"); }),
            "1 nowhere.gpl: there is no such file; check the name");
}

// Damaged files are Errors of their content or palettes; nothing else, and not slowly.
TEST(PaletteFormats, SurviveDamage) {
  std::mt19937 generator(12);
  for (const PaletteFormat& format : palette_formats()) {
    SCOPED_TRACE(format.name);
    const std::string good = bytes_of(test_palette(format, 9), format);
    for (int i = 0; i < 2000; ++i) {
      std::string bad = good;
      if (i % 4 == 0) bad.resize(generator() % bad.size());
      if (i % 4 == 1) bad.insert(generator() % bad.size(), good.substr(generator() % good.size()));
      for (int k = 0; k < i % 5 && !bad.empty(); ++k) {
        bad[generator() % bad.size()] = static_cast<char>(generator());
      }
      try {
        const Palette palette = parse_palette(bad, "bad", format.name);
        EXPECT_FALSE(palette.colors.empty());
        (void)palette_bytes(palette, palette_formats()[9], "again.toml");
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::kContent) << error.what();
      }
    }
  }
}

TEST(Palette, RoundsCodes) {
  EXPECT_EQ(unit_code(0.5, 255), 128);
  EXPECT_EQ(unit_code(-1, 255), 0);
  EXPECT_EQ(unit_code(2, 65535), 65535);
  EXPECT_EQ(unit_code(std::nan(""), 255), 0);
  EXPECT_TRUE(is_8_bits({1 / 255.0, 1, 0}));
  EXPECT_FALSE(is_8_bits({0.5, 1, 0}));
}

}  // namespace
}  // namespace tristim
