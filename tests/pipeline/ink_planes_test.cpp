#include "lib/pipeline/ink_planes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/pipeline/pictures.h"
#include "tristim/color/lab.h"
#include "tristim/color/transfer.h"
#include "tristim/core/find.h"
#include "tristim/device/display_file.h"
#include "tristim/pipeline/chain.h"

namespace tristim {
namespace {

using detail::ToneBeforeGain;

const DotGain kGains[] = {NoGain{}, MurrayDaviesGain{0.2}, YuleNielsenGain{1.8, 0.03},
                          MeasuredGain{{0, 0.4, 0.5, 1}, {0, 0.58, 0.7, 1}}};

TEST(ToneBeforeGain, IsTheInverseOfTheGain) {
  for (const DotGain& gain : kGains) {
    SCOPED_TRACE(describe(gain));
    const ToneBeforeGain before(gain);
    for (int i = 0; i <= 1000; ++i) {
      const double tone = i / 1000.0;
      EXPECT_NEAR(before(static_cast<float>(tone)), 1 - asked_area(gain, 1 - tone), 3e-5);
    }
    EXPECT_NEAR(before(0), 0, 1e-7);
    EXPECT_NEAR(before(1), 1, 1e-7);
  }
}

// The area of each ink on a sheet of one colour.
std::vector<double> inked(const Display& display, const Settings& settings, const Rgb& light) {
  constexpr int kSide = 384;
  Reducer reducer(display, reduce_options(display, settings), kSide);
  Image rgb = flat_picture(kSide, kSide, static_cast<float>(light.r), static_cast<float>(light.g),
                           static_cast<float>(light.b));
  Raster<std::uint16_t> codes(kSide, kSide, 1);
  reducer.reduce({rgb.view(), 0}, codes.view());
  std::vector<double> areas(display.press->inks.size(), 0.0);
  for (int y = 0; y < kSide; ++y) {
    for (const std::uint16_t code : codes.view().row(y)) {
      for (std::size_t i = 0; i < areas.size(); ++i) areas[i] += code >> i & 1;
    }
  }
  for (double& area : areas) area /= kSide * kSide;
  return areas;
}

// The press as its own file models it: dots gain, inks fall on one another by chance.
Rgb printed(const Display& display, std::vector<double> areas) {
  for (double& area : areas) area = covered_area(display.dots->gain, area);
  return printed_light(display.press->inks, areas);
}

TEST(PressReducer, PrintsTheToneThatWasAskedFor) {
  double worst = 0;
  for (const char* dither : {"screen", "hybrid-screen"}) {
    for (const DotGain& gain : kGains) {
      SCOPED_TRACE(dither + (": " + describe(gain)));
      Display display = load_display("offset-cmyk");
      display.dots->gain = gain;
      display.press->black = {1, 4};
      Settings settings;
      settings.dither = *find_by_name(dither_methods(), dither);
      const double black = darkest_print(*display.press).g;
      for (int k = 0; k <= 16; ++k) {
        const double tone = srgb_decode(k / 16.0);
        const Rgb seen = printed(display, inked(display, settings, {tone, tone, tone}));
        const double wanted = black + (1 - black) * tone;
        worst =
            std::max(worst, std::fabs(lstar_from_luminance(seen.g) - lstar_from_luminance(wanted)));
      }
    }
  }
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LE(worst, 0.15);
}

TEST(PressReducer, TakesEveryDitherByInk) {
  Display display = load_display("offset-cmyk");
  display.press->black.replacement = 1;
  for (const NamedDither& dither : dither_methods()) {
    SCOPED_TRACE(dither.name);
    Settings settings;
    settings.dither = dither;
    const std::vector<double> bare = inked(display, settings, {1, 1, 1});
    EXPECT_EQ(bare, (std::vector<double>{0, 0, 0, 0}));
    EXPECT_EQ(inked(display, settings, {0, 0, 0})[3], 1);
  }
}

// Each by itself: a tone of each ink is kept by all that see the whole picture.
TEST(PressReducer, KeepsTheTonesOfInksOverWholePictures) {
  Display display = load_display("offset-cmyk");
  const Rgb light{0.35, 0.5, 0.25};
  std::vector<double> asked(4);
  Separation(*display.press).areas(light, asked);
  for (double& area : asked) area = asked_area(display.dots->gain, area);
  for (const WholePictureDither& dither : kWholePictureDithers) {
    SCOPED_TRACE(dither.name);
    Settings settings;
    settings.dither = *find_by_name(dither_methods(), dither.name);
    settings.dither_parameters.effort = 2;
    const std::vector<double> inks = inked(display, settings, light);
    for (std::size_t i = 0; i < inks.size(); ++i) EXPECT_NEAR(inks[i], asked[i], 0.004) << i;
  }
}

TEST(PressReducer, ScreensByDefaultAtTheDevicesAngles) {
  const Display display = load_display("offset-cmyk");
  EXPECT_EQ(default_dither(display).name, "screen");
  const ReduceOptions options = reduce_options(display, {});
  EXPECT_EQ(options.parameters.screen.dpi, 2400);
  EXPECT_EQ(options.parameters.screen.lpi, 150);
  EXPECT_EQ(options.parameters.screen.angles_deg, display.press->angles_deg);
}

TEST(ReduceOptions, ARulingAsksForAScreen) {
  Settings settings;
  settings.dither_parameters.screen.lpi = 60;
  const ReduceOptions options = reduce_options(load_display("laser-300"), settings);
  EXPECT_TRUE(std::holds_alternative<ScreenRecipe>(options.dither));
  EXPECT_EQ(options.parameters.screen.dpi, 300);
}

}  // namespace
}  // namespace tristim
