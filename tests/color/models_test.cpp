#include "tristim/color/models.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <string>

#include "tests/error_text.h"
#include "tristim/color/lab.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

Components convert(const std::string& from, const std::string& to, const Components& c,
                   Adaptation adaptation = Adaptation::kBradford) {
  return ColorConversion(parse_model(from, "--from"), parse_model(to, "--to"), adaptation)(c);
}

void expect_near(const Components& a, const Components& b, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance);
}

// Every model, with primaries or a white of its own where it takes them.
std::vector<std::string> references() {
  std::vector<std::string> all;
  for (const ColorModel& model : color_models()) {
    all.emplace_back(model.name);
    if (model.has_primaries) all.push_back(std::string(model.name) + ":ntsc-1953");
    if (model.has_primaries) all.push_back(std::string(model.name) + ":adobe-rgb");
    if (!model.has_primaries && !model.fixed_white) all.push_back(std::string(model.name) + "@d50");
  }
  return all;
}

TEST(ColorConversion, EveryOrderedPairComesBack) {
  for (const std::string& from : references()) {
    for (const std::string& to : references()) {
      for (const AdaptationMethod& method : kAdaptations) {
        SCOPED_TRACE(from + " to " + to + ", " + std::string(method.name));
        for (const Components srgb : {Components{0.2, 0.5, 0.7}, Components{0.9, 0.3, 0.1},
                                      Components{0.6, 0.6, 0.6}, Components{1, 1, 1}}) {
          const Components c = convert("rgb", from, srgb);
          const Components there = convert(from, to, c, method.method);
          // 1e-15 of XYZ times 500 and the slopes of the curves; Lab is up to 100.
          expect_near(convert(to, from, there, method.method), c, 1e-11);
        }
      }
    }
  }
}

TEST(ColorConversion, GreysOfEverySetAreExactlyNeutralInLab) {
  for (const NamedPrimaries& set : primaries_list()) {
    for (const char* model : {"rgb:", "linear:"}) {
      SCOPED_TRACE(set.name);
      const ColorConversion to_lab(parse_model(model + std::string(set.name), ""),
                                   parse_model("lab", ""), Adaptation::kBradford);
      for (int code = 0; code <= 255; ++code) {
        const double v = code / 255.0;
        const Components lab = to_lab({v, v, v});
        ASSERT_EQ(lab[1], 0);
        ASSERT_EQ(lab[2], 0);
      }
    }
  }
}

TEST(ColorConversion, WhiteGoesToWhiteWhereItAdapts) {
  expect_near(convert("rgb:ntsc-1953", "lab@d50", {1, 1, 1}), {100, 0, 0}, 1e-12);
  expect_near(convert("lab@d50", "rgb:srgb", {100, 0, 0}), {1, 1, 1}, 1e-13);
  expect_near(convert("rgb:ntsc-1953", "oklab", {1, 1, 1}), {1, 0, 0}, 4e-8);  // as published
}

// Without adaptation the XYZ stay: the white of sRGB is bluish to an eye adapted to D50.
TEST(ColorConversion, WithoutAdaptationTheWhiteMoves) {
  const Lab expected = xyz_to_lab(white_xyz(kD65), white_xyz(kD50));
  ASSERT_LT(expected.b, -10);
  const Components asked = {expected.l, expected.a, expected.b};
  expect_near(convert("rgb:srgb", "lab@d50", {1, 1, 1}, Adaptation::kNone), asked, 1e-12);
  expect_near(convert("lab@d65", "lab@d50", {100, 0, 0}, Adaptation::kNone), asked, 1e-12);
  expect_near(convert("lab@d65", "lab@d50", {100, 0, 0}), {100, 0, 0}, 1e-12);
}

TEST(ColorConversion, TakesTheOtherSidesWhiteWhereOneHasNone) {
  expect_near(convert("rgb:ntsc-1953", "lab", {1, 1, 1}), {100, 0, 0}, 0);
  const Xyz c = white_xyz({0.31, 0.316});
  expect_near(convert("rgb:ntsc-1953", "xyz", {1, 1, 1}), {c.x, c.y, c.z}, 4e-15);
  expect_near(convert("lab", "xyz@d50", {100, 0, 0}), {white_xyz(kD50).x, 1, white_xyz(kD50).z},
              1e-15);
}

TEST(ColorConversion, SameModelIsTheIdentity) {
  for (const std::string& name : references()) {
    EXPECT_EQ(convert(name, name, {0.1, 0.2, 0.3}), (Components{0.1, 0.2, 0.3})) << name;
  }
}

// [IEC61966] sRGB red and [CSS4]: Lab under D65, printed with 2 decimals.
TEST(ColorConversion, HasKnownValues) {
  expect_near(convert("rgb", "lab", {1, 0, 0}), {53.24, 80.09, 67.20}, 0.01);
  expect_near(convert("rgb", "oklab", {1, 0, 0}), {0.62796, 0.22486, 0.12585}, 1e-5);  // [CSS4]
  expect_near(convert("rgb", "linear", {0.5, 0.5, 0.5}),
              {0.21404114048223255, 0.21404114048223255, 0.21404114048223255}, 1e-15);
  // The set's own exponent, 563/256.
  const double light = std::pow(0.5, 563.0 / 256);
  expect_near(convert("rgb:adobe-rgb", "linear:adobe-rgb", {0.5, 0.5, 0.5}), {light, light, light},
              1e-15);
}

TEST(ColorConversion, NanStaysNan) {
  for (const std::string& from : references()) {
    for (const std::string& to : references()) {
      const Components c = convert(from, to, {std::nan(""), 0.5, 0.5});
      EXPECT_TRUE(std::isnan(c[0]) || std::isnan(c[1]) || std::isnan(c[2])) << from << " " << to;
    }
  }
}

TEST(ColorConversion, ExplainsItsSteps) {
  const ColorConversion conversion(parse_model("rgb", ""), parse_model("lab@d50", ""),
                                   Adaptation::kBradford);
  const std::vector<std::string> lines = conversion.explain();
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_TRUE(lines[0].starts_with("rgb to xyz: ")) << lines[0];
  EXPECT_TRUE(lines[1].starts_with("white d65 to d50: bradford [Lam85]; matrix 1.04")) << lines[1];
  EXPECT_TRUE(lines[2].starts_with("xyz to lab: ")) << lines[2];
}

TEST(ParseModel, NamesWhatItDoesNotKnow) {
  const auto text = [](const char* model) {
    return error_text([&] { parse_model(model, "--from"); });
  };
  EXPECT_EQ(text("lba"),
            "2 --from: unknown model 'lba'; use one of: rgb, linear, xyz, xyy, lab, oklab");
  EXPECT_EQ(text("linera"), "2 --from: unknown model 'linera'; did you mean linear?");
  EXPECT_EQ(text("rgb:ntsc1935"),
            "2 --from: unknown primaries 'ntsc1935'; did you mean ntsc-1953?");
  EXPECT_EQ(text("lab@d56"), "2 --from: unknown white 'd56'; did you mean d50?");
  const std::string remedy =
      "; primaries go with rgb and linear (rgb:ntsc1953), whites with the others (lab@d50)";
  EXPECT_EQ(text("lab:srgb"), "2 --from: 'lab:srgb' is no model" + remedy);
  EXPECT_EQ(text("rgb@d50"), "2 --from: 'rgb@d50' is no model" + remedy);
  EXPECT_EQ(text("oklab@d50"), "2 --from: 'oklab@d50' is no model" + remedy);
  EXPECT_NE(text("rgb:"), "");
  EXPECT_NE(text(""), "");
}

TEST(ParseModel, FoldsNamesAndFixesWhites) {
  EXPECT_EQ(parse_model("RGB:NTSC_1953", "").primaries,
            find_by_name(primaries_list(), "ntsc-1953")->primaries);
  EXPECT_EQ(parse_model("LAB@D50", "").white, kD50);
  EXPECT_EQ(parse_model("oklab", "").white, kD65);
  EXPECT_EQ(parse_model("rgb", "").white, kD65);
  EXPECT_FALSE(parse_model("xyz", "").white);
}

}  // namespace
}  // namespace tristim
