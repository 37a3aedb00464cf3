#include "tristim/device/display.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <string>

#include "tests/error_text.h"
#include "tristim/core/find.h"
#include "tristim/device/display_file.h"
#include "tristim/dither/levels.h"

namespace tristim {
namespace {

// A response and its inverse once more, in long double, from picture light (relative) to [0, 1].
struct Curve {
  const char* name;
  Response response;
  long double (*code)(long double light);
};

long double power(long double x, double gamma) { return std::pow(x, 1 / (long double){gamma}); }

const Curve kCurves[] = {
    {"srgb", SrgbResponse{},
     [](long double x) -> long double {
       return x <= 0.0031308 ? 12.92 * x : 1.055 * power(x, 2.4) - 0.055;
     }},
    {"linear", LinearResponse{}, [](long double x) { return x; }},
    {"gamma 1.8", GammaResponse{.gamma = 1.8}, [](long double x) { return power(x, 1.8); }},
    {"gamma 2.2", GammaResponse{.gamma = 2.2}, [](long double x) { return power(x, 2.2); }},
    {"gamma 2.4, i0", GammaResponse{.gamma = 2.4, .i0 = 0.02},
     [](long double x) { return power(x, 2.4); }},
    {"bt1886", Bt1886Response{0.01},
     [](long double x) {
       const long double root = power(0.01, 2.4);
       const long double gain = std::pow(1 - root, 2.4L);
       return power((0.01 + x * 0.99L) / gain, 2.4) - root / (1 - root);
     }},
};

// The long double curve's code of a float, rounded half up.
int rounded_code(const Curve& curve, float light, int code_max) {
  const long double x = std::min(std::max(light, 0.0F), 1.0F);
  return static_cast<int>(std::floor(code_max * curve.code(x) + 0.5L));
}

TEST(LevelScale, ThresholdsAreTheSmallestFloatsOfTheirCode) {
  for (const Curve& curve : kCurves) {
    for (const int bits : {1, 4, 8, 12}) {
      SCOPED_TRACE(testing::Message() << curve.name << ", " << bits << " bits");
      const int code_max = (1 << bits) - 1;
      const LevelScale scale =
          level_scale({.response = curve.response}, bits, BlackPoint::kRelative);
      ASSERT_EQ(scale.threshold.size(), static_cast<std::size_t>(code_max));
      for (int c = 1; c <= code_max; ++c) {
        const float threshold = scale.threshold[static_cast<std::size_t>(c - 1)];
        ASSERT_EQ(scale.nearest[static_cast<std::size_t>(c)], c);
        ASSERT_GE(rounded_code(curve, threshold, code_max), c);
        ASSERT_LT(rounded_code(curve, std::nextafter(threshold, -1.0F), code_max), c);
      }
    }
  }
}

TEST(LevelScale, NearestIsTheExactCurveRoundedHalfUp) {
  constexpr std::uint32_t kStep = 16411;  // a prime: all exponents, mantissas of all kinds
  constexpr auto kEnd = std::bit_cast<std::uint32_t>(1.5F);
  for (const Curve& curve : kCurves) {
    SCOPED_TRACE(curve.name);
    const LevelScale scale = level_scale({.response = curve.response}, 8, BlackPoint::kRelative);
    const NearestLevel nearest(scale.threshold, scale.nearest);
    for (std::uint32_t bits = 0; bits < kEnd; bits += kStep) {
      const auto light = std::bit_cast<float>(bits);
      std::uint16_t code = 0;
      nearest.row({&light, 1, 1}, {&code, 1, 1});
      ASSERT_EQ(code, rounded_code(curve, light, 255)) << light;
    }
  }
}

TEST(LevelScale, AbsoluteBlackLosesWhatIsBelowIt) {
  const Display display{.response = GammaResponse{.gamma = 2.2, .i0 = 0.02}};
  const LevelScale relative = level_scale(display, 8, BlackPoint::kRelative);
  const LevelScale absolute = level_scale(display, 8, BlackPoint::kAbsolute);
  EXPECT_EQ(relative.light.front(), 0);
  EXPECT_EQ(relative.light.back(), 1);
  EXPECT_EQ(absolute.light.front(), 0.02F);
  EXPECT_EQ(absolute.light.back(), 1);
  EXPECT_GT(absolute.threshold.front(), 0.02F);
  EXPECT_LT(relative.threshold.front(), 0.001F);
}

TEST(LevelScale, DecidesIntensityLevelsByTheNearestLevel) {
  const Display crt = load_display("crt-p22");
  const LevelTable& table = *crt.levels;
  const LevelScale scale = level_scale(crt, 8, BlackPoint::kRelative);
  const std::vector<int> codes = display_level_codes(crt, 8);
  const auto level = [&](float picture) {
    return nearest_level(table.i0 + double{picture} * (1 - table.i0), table).value();
  };
  ASSERT_EQ(scale.threshold.size(), static_cast<std::size_t>(table.n));
  for (int j = 1; j <= table.n; ++j) {
    const auto i = static_cast<std::size_t>(j);
    EXPECT_EQ(scale.nearest[i], codes[i]);
    EXPECT_GE(level(scale.threshold[i - 1]), j);
    EXPECT_LT(level(std::nextafter(scale.threshold[i - 1], -1.0F)), j);
  }
}

TEST(LevelScale, MixesDistinctLevelsOnly) {
  // Half of the intensities in 256 levels: neighbours share a code.
  const Display display{.response = GammaResponse{}, .levels = LevelTable{.n = 255, .i0 = 0.5}};
  const LevelScale scale = level_scale(display, 8, BlackPoint::kRelative);
  EXPECT_EQ(scale.light.size(), 256U - 186U);  // V_0 = floor(255 .5^(1/2.2) + .5) = 186
  EXPECT_EQ(scale.light.front(), 0);
  EXPECT_EQ(scale.light.back(), 1);
  EXPECT_EQ(scale.nearest.size(), 256U);
  for (std::size_t i = 1; i < scale.light.size(); ++i) {
    EXPECT_GT(scale.light[i], scale.light[i - 1]);
    EXPECT_GT(scale.code[i], scale.code[i - 1]);
  }
}

TEST(LevelScale, StoresIndicesWhereTheTableHoldsTheCodes) {
  Display display{.response = GammaResponse{}, .levels = LevelTable{.n = 15}};
  display.frame.store = Store::kIndex;
  const LevelScale scale = level_scale(display, 8, BlackPoint::kRelative);
  for (std::size_t j = 0; j <= 15; ++j) EXPECT_EQ(scale.nearest[j], j);
  // Decoded, index j shows V_j; indices without a level show the last.
  const std::vector<double> light = light_of_codes(display, 8);
  const std::vector<int> codes = display_level_codes(display, 8);
  ASSERT_EQ(light.size(), 256U);
  EXPECT_EQ(light[3], light_of_code(display.response, codes[3], 255));
  EXPECT_EQ(light[15], 1);
  EXPECT_EQ(light[200], 1);
}

TEST(ChannelResponses, TakeThePlaceOfTheCommonOne) {
  Display display{.response = LinearResponse{}};
  EXPECT_TRUE(has_one_response(display));
  display.channel_response[1] = GammaResponse{.gamma = 2};
  EXPECT_FALSE(has_one_response(display));
  EXPECT_EQ(light_of_codes(display, 8, 0)[51], 0.2);
  EXPECT_DOUBLE_EQ(light_of_codes(display, 8, 1)[51], 0.04);
  EXPECT_EQ(level_scale(display, 8, BlackPoint::kRelative, 2).light[51], 0.2F);
  EXPECT_EQ(level_scale(display, 8, BlackPoint::kRelative, 1).light[51], 0.04F);
  EXPECT_EQ(describe_responses(display),
            "red: linear: I = V / Vmax; green: gamma: I = i0 + (1 - i0) K V^gamma, gamma = 2, i0 = "
            "0, K = Vmax^-gamma; blue: linear: I = V / Vmax");
}

TEST(DisplayLevelCodes, NeedsLevels) {
  EXPECT_EQ(error_text([] { display_level_codes(Display{}, 8); }),
            "invalid: display: it has no intensity levels");
}

// V_0 = 255 .02^(1/2.3) = 46.54 and V_128 = 255 (.02^(127/255))^(1/2.3) = 109.31 by hand.
TEST(DisplayLevelCodes, AreTheDocumentsForTheCrt) {
  const std::vector<int> codes = display_level_codes(load_display("crt-p22"), 8);
  ASSERT_EQ(codes.size(), 256U);
  EXPECT_EQ(codes[0], 47);
  EXPECT_EQ(codes[128], 109);
  EXPECT_EQ(codes[255], 255);
}

TEST(PaletteLight, SpansBlackToWhite) {
  for (const BuiltInDisplay& built_in : built_in_displays()) {
    SCOPED_TRACE(built_in.name);
    const Display display = load_display(std::string(built_in.name));
    const std::vector<Rgb> relative = palette_light(display, BlackPoint::kRelative);
    const std::vector<Rgb> absolute = palette_light(display, BlackPoint::kAbsolute);
    ASSERT_EQ(relative.size(), display.palette.size());
    if (display.palette.empty()) continue;
    const auto luminance = [&](const CodeColor& c) { return c.appearance.y; };
    const auto [dark, bright] = std::ranges::minmax_element(display.palette, {}, luminance);
    const auto darkest = static_cast<std::size_t>(dark - display.palette.begin());
    const auto lightest = static_cast<std::size_t>(bright - display.palette.begin());
    for (const auto channel : {&Rgb::r, &Rgb::g, &Rgb::b}) {
      // Roundings of two 3 x 3 matrices.
      EXPECT_NEAR(relative[lightest].*channel, 1, 4e-15);
      EXPECT_EQ(relative[darkest].*channel, 0);
      EXPECT_NEAR(absolute[lightest].*channel, 1, 4e-15);
      EXPECT_GE(absolute[darkest].*channel, -1e-15);
    }
  }
}

TEST(PaletteLight, IsRelativeToTheViewingWhiteWithoutAWhiteOfItsOwn) {
  const Xyz white = white_xyz(kD65);
  Display display{.palette = {{0, {white.x / 4, white.y / 4, white.z / 4}, ""}},
                  .palette_has_white = false};
  const std::vector<Rgb> light = palette_light(display, BlackPoint::kRelative);
  ASSERT_EQ(light.size(), 1U);
  EXPECT_NEAR(light[0].r, 0.25, 1e-15);
  EXPECT_NEAR(light[0].b, 0.25, 1e-15);
}

TEST(IsMonochrome, IsOneSampleThatIsNoIndex) {
  for (const Packing& packing : kPackings) {
    Display display;
    display.frame.packing = packing;
    const bool grey = packing.name.starts_with("gray") || packing.name == "mono1";
    EXPECT_EQ(is_monochrome(display), grey) << packing.name;
  }
}

}  // namespace
}  // namespace tristim
