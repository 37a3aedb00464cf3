#include "tristim/color/cns.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "tests/color/srgb_munsell.h"
#include "tests/example_rows.h"
#include "tests/support.h"

namespace tristim {
namespace {

std::string text_of(const std::optional<CnsName>& name) { return name ? cns_text(*name) : "none"; }

TEST(Cns, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/cns_grammar.csv")) {
    const auto name = parse_cns(row.text("name"));
    SCOPED_TRACE(row.text("name"));
    ASSERT_EQ(name.has_value(), row.text("verdict") == "valid");
    if (!name || !name->hue) continue;
    EXPECT_EQ(kCnsLightness[name->lightness], row.text("lightness"));
    EXPECT_EQ(kCnsSaturation[name->saturation], row.text("saturation"));
    EXPECT_EQ(cns_hues()[static_cast<std::size_t>(*name->hue)].name, row.text("hue"));
  }
}

TEST(Cns, Has627NamesThatReadBack) {
  std::set<std::string> texts;
  for (const CnsName& name : cns_names()) {
    const std::string text = cns_text(name);
    EXPECT_EQ(parse_cns(text), name) << text;
    texts.insert(text);
  }
  EXPECT_EQ(texts.size(), 627U);
}

TEST(Cns, NamesSurviveTheirColors) {
  for (const CnsName& name : cns_names()) {
    EXPECT_EQ(cns_name(cns_color(name)), name) << cns_text(name);
  }
}

// 8 bits of sRGB are enough for that, too.
TEST(Cns, NamesSurviveSrgbCodes) {
  const Eigen::Matrix3d matrix =
      (adaptation_matrix(kD65, kMunsellWhite, Adaptation::kBradford) * xyz_from_rgb(Primaries{}))
          .inverse();
  for (const CnsName& name : cns_names()) {
    SCOPED_TRACE(cns_text(name));
    const Xyz xyz = xyy_to_xyz(munsell_to_xyy(cns_color(name)));
    const Eigen::Vector3d light = matrix * Eigen::Vector3d(xyz.x, xyz.y, xyz.z);
    ASSERT_GE(light.minCoeff(), -1e-9);
    ASSERT_LE(light.maxCoeff(), 1 + 1e-9);
    const auto code = [](double x) { return static_cast<int>(srgb_encode(x) * 255 + 0.5); };
    EXPECT_EQ(cns_name(srgb_munsell(code(light.x()), code(light.y()), code(light.z()))), name);
  }
}

TEST(ParseCns, ReadsWhatTheGrammarAllows) {
  const struct {
    const char *text, *name;
  } rows[] = {
      {"red", "vivid red"},
      {"light purple-red", "light vivid purple-red"},
      {"Light VIVID purplish  red", "light vivid purplish red"},
      {"orange-red", "vivid red-orange"},
      {"yellowish-green", "vivid yellowish green"},
      {"brown-yellow", "vivid yellow-brown"},
      {"very dark greyish blue", "very dark grayish blue"},
      {"medium Grey", "gray"},
      {"very light gray", "very light gray"},
      {"black", "black"},
      {"WHITE", "white"},
  };
  for (const auto& row : rows) EXPECT_EQ(text_of(parse_cns(row.text)), row.name) << row.text;
}

TEST(ParseCns, RefusesTheRest) {
  for (const char* text : {"",
                           " ",
                           "#ff0000",
                           "red-green",
                           "brown-orange",
                           "orangish brown",
                           "reddish red",
                           "red-red",
                           "blue green",
                           "dark white",
                           "medium black",
                           "vivid gray",
                           "vivid dark red",
                           "very red",
                           "light light red",
                           "-red",
                           "red-",
                           "ish red",
                           "-",
                           "very",
                           "red blue",
                           "pink",
                           "reddish orange-brown",
                           "\xff\xfe"}) {
    EXPECT_FALSE(parse_cns(text)) << text;
    EXPECT_FALSE(cns_hint(text).empty());
  }
  EXPECT_EQ(cns_hint("dark vivid bleu"), "did you mean dark vivid blue?");
}

// What the anchors were chosen for: words mean on a display what they say.
TEST(CnsName, NamesTheColorsOfDisplays) {
  const struct {
    int red, green, blue;
    const char* name;
  } rows[] = {
      {255, 0, 0, "vivid red"},
      {255, 140, 0, "vivid orange"},
      {255, 255, 0, "very light vivid yellow"},
      {0, 128, 0, "vivid green"},
      {0, 255, 255, "very light vivid green-blue"},
      {0, 0, 255, "dark vivid blue"},
      {128, 0, 128, "dark vivid purple"},
      {139, 69, 19, "vivid brown"},
      {128, 0, 0, "vivid red-brown"},
      {255, 192, 203, "very light vivid purple-red"},
      {240, 248, 255, "very light grayish greenish blue"},
      {128, 128, 128, "gray"},
      {0, 0, 0, "black"},
      {255, 255, 255, "white"},
  };
  for (const auto& row : rows) {
    EXPECT_EQ(text_of(cns_name(srgb_munsell(row.red, row.green, row.blue))), row.name);
  }
}

TEST(CnsName, NamesAllOfSrgbAndNoColorNot) {
  for (int red = 0; red < 256; red += 17) {
    for (int green = 0; green < 256; green += 17) {
      for (int blue = 0; blue < 256; blue += 17) {
        const auto name = cns_name(srgb_munsell(red, green, blue));
        ASSERT_TRUE(name);
        ASSERT_EQ(parse_cns(cns_text(*name)), name);
      }
    }
  }
  const double nan = std::nan("");
  for (const Munsell m : {Munsell{nan, nan, nan}, {5, 11, 2}, {5, 5, -1}, {nan, 5, 4}}) {
    EXPECT_FALSE(cns_name(m));
  }
}

}  // namespace
}  // namespace tristim
