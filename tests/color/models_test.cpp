#include "tristim/color/conversion.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/error_text.h"
#include "tristim/color/lab.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

Components convert(const std::string& from, const std::string& to, const Components& c,
                   Adaptation adaptation = Adaptation::kBradford) {
  return ColorConversion(parse_model(from, "--from"), parse_model(to, "--to"), adaptation)(c);
}

// A hue that both lack, or that is one modulo 360, is no difference. The tolerance is relative
// above 1: temperatures are thousands of kelvins.
void expect_near(const Components& a, const Components& b, double tolerance) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isnan(a[i]) && std::isnan(b[i])) continue;
    EXPECT_NEAR(std::remainder(a[i] - b[i], 360), 0, tolerance * std::fmax(1, std::fabs(b[i])))
        << a[i] << " and " << b[i];
  }
}

// Every model, with primaries or a white of its own where it takes them.
std::vector<std::string> references() {
  std::vector<std::string> all;
  for (const ColorModel& model : color_models()) {
    const std::string name(model.name);
    all.push_back(name);
    if (takes_primaries(model)) all.push_back(name + ":ntsc-1953");
    if (takes_primaries(model)) all.push_back(name + ":adobe-rgb");
    if (takes_white(model)) all.push_back(name + "@d50");
  }
  return all;
}

// Whether it and all that it comes from have edges up and down.
bool goes_both_ways(const ColorModel& model) {
  const ColorModel* base = base_of(model);
  return base == nullptr || (model.to_base != nullptr && model.from_base != nullptr &&
                             model.to_text == nullptr && goes_both_ways(*base));
}

TEST(ColorConversion, EveryOrderedPairComesBack) {
  const Components colors[] = {{0.2, 0.5, 0.7}, {0.9, 0.3, 0.1}, {0.25, 0.25, 0.2}};
  for (const std::string& from : references()) {
    for (const std::string& to : references()) {
      for (const Adaptation method : {Adaptation::kBradford, Adaptation::kNone}) {
        const ModelReference here = parse_model(from, "");
        const ModelReference there = parse_model(to, "");
        if (!goes_both_ways(*here.model) || !goes_both_ways(*there.model)) continue;
        SCOPED_TRACE(from + " to " + to);
        const ColorConversion start(parse_model("rgb:srgb", ""), here, Adaptation::kBradford);
        const ColorConversion out(here, there, method);
        const ColorConversion back(there, here, method);
        for (const Components& srgb : colors) {
          const Components c = start(srgb);
          if (std::isinf(c[0]) || std::isinf(out(c)[0])) continue;  // bluer than any temperature
          // 1e-15 of XYZ times 500 and the slopes of the curves; hues are up to 360, and Oklab's
          // 10-digit matrices amplify tenfold.
          expect_near(back(out(c)), c, 1e-10);
        }
      }
    }
  }
}

TEST(ColorConversion, GreysOfEverySetAreExactlyNeutral) {
  for (const NamedPrimaries& set : primaries_list()) {
    for (const char* from : {"rgb:", "linear:", "hsv:", "yiq:", "cmyk:"}) {
      const ModelReference source = parse_model(from + std::string(set.name), "");
      SCOPED_TRACE(from + std::string(set.name));
      const ColorConversion grey(parse_model("rgb:" + std::string(set.name), ""), source,
                                 Adaptation::kNone);
      for (const char* to : {"lab", "luv", "lab@d50", "luv@a"}) {
        const ColorConversion conversion(source, parse_model(to, ""), Adaptation::kBradford);
        const ColorConversion back(parse_model(to, ""), source, Adaptation::kBradford);
        for (int code = -15; code <= 300; code += 15) {
          const double v = code / 255.0;
          const Components lab = conversion(grey({v, v, v}));
          ASSERT_EQ(lab[1], 0) << to << " " << v;
          ASSERT_EQ(lab[2], 0) << to << " " << v;
          const ColorConversion to_rgb(source, parse_model("rgb", ""), Adaptation::kNone);
          const Components rgb = to_rgb(back(lab));
          ASSERT_EQ(rgb[0], rgb[1]);
          ASSERT_EQ(rgb[2], rgb[1]);
        }
      }
    }
  }
}

TEST(ColorConversion, GreysStayGreysFromSetToSet) {
  for (const NamedPrimaries& set : primaries_list()) {
    SCOPED_TRACE(set.name);
    const ColorConversion conversion(parse_model("rgb:" + std::string(set.name), ""),
                                     parse_model("hsv:srgb", ""), Adaptation::kBradford);
    const Components hsv = conversion({0.4, 0.4, 0.4});
    EXPECT_TRUE(std::isnan(hsv[0]));
    EXPECT_EQ(hsv[1], 0);
  }
}

TEST(ColorConversion, GoesNoFurtherUpThanItMust) {
  const auto way = [](const char* from, const char* to) {
    std::string text;
    const ColorConversion conversion(parse_model(from, ""), parse_model(to, ""),
                                     Adaptation::kBradford);
    for (const ConversionStep& step : conversion.steps()) {
      text += (text.empty() ? std::string(step.from->name) : "") + " " + std::string(step.to->name);
    }
    return text;
  };
  EXPECT_EQ(way("hsv", "rgb:srgb"), "hsv rgb");
  EXPECT_EQ(way("hsv:ntsc1953", "yiq:notes"), "hsv rgb yiq:notes");
  EXPECT_EQ(way("hsv:ntsc1953", "yiq:notes:ntsc1953"), "hsv rgb yiq:notes");
  EXPECT_EQ(way("hsv:ntsc1953", "hls:smpte-c"), "hsv rgb linear linear rgb hls");
  EXPECT_EQ(way("rgb:bt709", "rgb:srgb/gamma2.2"), "rgb linear rgb");
  EXPECT_EQ(way("rgb:srgb/gamma2.2", "oklch"), "rgb linear oklab oklch");
  EXPECT_EQ(way("lch", "luv@d50"), "lch lab xyz luv");
  EXPECT_EQ(way("lch@d65", "luv@d50"), "lch lab xyz xyz luv");
  EXPECT_EQ(way("hsv", "lchuv"), "hsv rgb linear luv lchuv");
  EXPECT_EQ(way("lchuv@d50", "hsv"), "lchuv luv linear rgb hsv");
  EXPECT_EQ(way("cmyk:gcr=0.5", "cmyk:gcr=1"), "cmyk:subtract cmy cmyk:subtract");
  EXPECT_EQ(way("cmyk", "cmyk"), "");
}

TEST(ColorConversion, TakesTheOtherSidesPrimaries) {
  // The HSV of NTSC RGB: nothing is converted but the model.
  expect_near(convert("rgb:ntsc1953", "hsv", {1, 0.5, 0}), {30, 1, 1}, 1e-14);
  expect_near(convert("hsv", "rgb:ntsc1953", {30, 1, 1}), {1, 0.5, 0}, 1e-15);
  EXPECT_NE(convert("rgb:ntsc1953", "hsv:srgb", {1, 0.5, 0})[0], 30);
  // Oklab is made of sRGB light, and names no primaries.
  EXPECT_EQ(convert("oklab", "rgb", {0.5, 0.1, 0.1}),
            convert("oklab", "rgb:srgb", {0.5, 0.1, 0.1}));
}

TEST(ColorConversion, WhiteGoesToWhiteWhereItAdapts) {
  expect_near(convert("rgb:ntsc-1953", "lab@d50", {1, 1, 1}), {100, 0, 0}, 1e-12);
  expect_near(convert("lab@d50", "rgb:srgb", {100, 0, 0}), {1, 1, 1}, 2e-16);  // the curve at 1
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
      const ModelReference here = parse_model(from, "");
      const ModelReference there = parse_model(to, "");
      if (!goes_both_ways(*here.model) || !goes_both_ways(*there.model)) continue;
      const ColorConversion conversion(here, there, Adaptation::kBradford);
      for (std::size_t i = 0; i < component_count(*here.model); ++i) {
        Components c{0.3, 0.3, 0.3, 0.3};
        c[i] = std::nan("");
        const Components out = conversion(c);
        EXPECT_TRUE(std::isnan(out[0]) || std::isnan(out[1]) || std::isnan(out[2]) ||
                    std::isnan(out[3]))
            << from << " " << to << " " << i;
      }
    }
  }
}

TEST(ColorConversion, ExplainsItsSteps) {
  const ColorConversion conversion(parse_model("rgb", ""), parse_model("lab@d50", ""),
                                   Adaptation::kBradford);
  const std::vector<std::string> lines = conversion.explain();
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_TRUE(
      lines[0].starts_with("rgb to linear: each component by the curve [IEC61966]; curve "
                           "srgb: E = 12.92 L"))
      << lines[0];
  EXPECT_TRUE(lines[1].starts_with("linear to lab: ")) << lines[1];
  EXPECT_NE(lines[1].find("; in it white d65 to d50: bradford [Lam85]"), std::string::npos);
  const std::vector<std::string> white =
      ColorConversion(parse_model("lab@d65", ""), parse_model("xyz@d50", ""), Adaptation::kBradford)
          .explain();
  ASSERT_EQ(white.size(), 2U);
  EXPECT_TRUE(white[1].starts_with("white d65 to d50: bradford [Lam85]; matrix 1.04")) << white[1];
}

TEST(ColorModels, MakeATreeWithOneRoot) {
  for (const ColorModel& model : color_models()) {
    SCOPED_TRACE(model.name);
    EXPECT_EQ(model.base.empty(), model.name == "xyz");
    if (!model.base.empty()) ASSERT_NE(base_of(model), nullptr);
    EXPECT_TRUE(model.base.empty() || base_of(model) < &model);
    EXPECT_LE(component_count(model), Components{}.size());
    EXPECT_LE(model.parameters.size(), ModelParameters{}.size());
    EXPECT_FALSE(model.ranges.empty() || model.formula.empty() || model.source.empty());
    EXPECT_EQ(parse_model(model.name, "").model, &model);
    if (!model.alias.empty()) EXPECT_EQ(parse_model(model.alias, "").model, &model);
  }
}

TEST(ParseModel, NamesWhatItDoesNotKnow) {
  const auto text = [](const char* model) {
    return error_text([&] { parse_model(model, "--from"); });
  };
  EXPECT_EQ(text("linera"), "2 --from: unknown model 'linera'; did you mean linear?");
  EXPECT_TRUE(text("qwrt").starts_with("2 --from: unknown model 'qwrt'; use one of: xyz, linear, "))
      << text("qwrt");
  EXPECT_EQ(text("rgb:ntsc1935"),
            "2 --from: unknown primaries 'ntsc1935'; did you mean ntsc-1953?");
  EXPECT_EQ(text("yiq:fcc1935"), "2 --from: unknown variant 'fcc1935'; did you mean fcc1953?");
  EXPECT_EQ(text("yiq:fcc1953:strgb"), "2 --from: unknown primaries 'strgb'; did you mean srgb?");
  EXPECT_EQ(text("lab@d56"), "2 --from: unknown white 'd56'; did you mean d50?");
  EXPECT_EQ(text("lab@0.3,0.9"),
            "2 --from: '0.3,0.9' is no chromaticity; give x,y such as 0.3127,0.329");
  EXPECT_EQ(text("lab:srgb"),
            "2 --from: 'srgb' does not go with lab; a white can be named: lab@d50");
  EXPECT_EQ(text("oklab:srgb"), "2 --from: 'srgb' does not go with oklab; leave it out");
  EXPECT_EQ(text("rgb@d50"), "2 --from: rgb has a white of its own; leave out '@d50'");
  EXPECT_EQ(text("oklab@d50"), "2 --from: oklab has a white of its own; leave out '@d50'");
  EXPECT_EQ(text("rgb:srgb/srbg"), "2 --from: unknown curve 'srbg'; did you mean srgb?");
  EXPECT_EQ(text("linear:srgb/srgb"), "2 --from: linear has no curve; leave out '/srgb'");
  EXPECT_EQ(text("rgb:1,2,3"),
            "2 --from: 3 numbers are no primaries; give x,y of red, green, blue and the white, or "
            "of the three and Yr,Yg,Yb");
  EXPECT_EQ(text("rgb:a,b").substr(0, 40), "2 --from: 'a,b' are no numbers; give x,y");
  EXPECT_EQ(text("rgb:0.1,0.1,0.2,0.2,0.3,0.3,0.3,0.3").substr(0, 60),
            "2 --from: primaries: the three chromaticities lie on a line;");
  EXPECT_EQ(text("cmyk:grc=1"), "2 --from: unknown parameter 'grc'; use one of: gcr, limit");
  EXPECT_EQ(text("cmyk:gcr=2"), "2 --from: gcr cannot be '2'; give a number from 0 to 1");
  EXPECT_EQ(text("lab:gcr=1"), "2 --from: unknown parameter 'gcr'; lab has none");
  EXPECT_NE(text("rgb:"), "");
  EXPECT_NE(text("rgb:srgb:srgb"), "");
  EXPECT_NE(text(""), "");
}

// Pieces of names, marks and numbers in any order: a model, or an error of one line.
RC_GTEST_PROP(ParseModel, TakesHostileText, ()) {
  const auto pieces = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
      "rgb", "yiq", "cmyk", "lab", "ictcp", ":", ":", "@", "/", "=", ",", "srgb", "fcc1953", "pq",
      "gcr", "limit", "0.3", "1e999", "nan", "-", "\n", "d50", "gamma", "563/256", " "));
  std::string text;
  for (const std::string& piece : pieces) text += piece;
  try {
    RC_ASSERT(parse_model(text, "--from").model != nullptr);
  } catch (const Error& error) {
    const std::string line = error.what();
    RC_ASSERT(line.starts_with("--from: "));
    RC_ASSERT(line.find('\n') == std::string::npos);
  }
}

TEST(ParseModel, FoldsNamesAndFixesWhites) {
  EXPECT_EQ(parse_model("RGB:NTSC_1953", "").primaries,
            find_by_name(primaries_list(), "ntsc-1953")->primaries);
  EXPECT_EQ(parse_model("LAB@D50", "").white, kD50);
  EXPECT_EQ(parse_model("lab@0.31,0.33", "").white, (Chromaticity{0.31, 0.33}));
  EXPECT_FALSE(parse_model("xyz", "").white);
  EXPECT_FALSE(parse_model("rgb", "").primaries);
  EXPECT_EQ(parse_model("yiq", "").model->name, "yiq:smpte170m");
  EXPECT_EQ(parse_model("cmyk:normalised:gcr=0.5:limit=3", "").parameters,
            (ModelParameters{0.5, 3}));
}

TEST(ParseModel, TakesPrimariesAsNumbers) {
  EXPECT_EQ(parse_model("rgb:0.64,0.33,0.3,0.6,0.15,0.06,0.3127,0.329", "").primaries, Primaries{});
  // The luminances of sRGB make its white.
  const auto white =
      parse_model(
          "rgb:0.64,0.33,0.3,0.6,0.15,0.06,0.21263900587151,0.71516867876776,0.07219231536073", "")
          .primaries->white;
  EXPECT_NEAR(white.x, kD65.x, 1e-13);
  EXPECT_NEAR(white.y, kD65.y, 1e-13);
}

}  // namespace
}  // namespace tristim
