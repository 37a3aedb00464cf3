#include "tristim/measure/figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "tristim/core/find.h"
#include "tristim/measure/pixels.h"
#include "tristim/measure/vision.h"

namespace tristim {
namespace {

using Light = std::function<float(int x, int y)>;

Image grey(int width, int height, const Light& light) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) std::fill_n(image.view().pixel(x, y), 3, light(x, y));
  }
  return image;
}

Light flat(float light) {
  return [light](int, int) { return light; };
}

// A number that looks random, of a pixel.
float noise(int x, int y) {
  std::uint32_t h =
      static_cast<std::uint32_t>(x) * 0x9e3779b1U ^ static_cast<std::uint32_t>(y) * 0x85ebca77U;
  for (int i = 0; i < 3; ++i) h = (h ^ h >> 15) * 0x2c1b3c6dU;
  return static_cast<float>(h >> 8) * 0x1p-24F;
}

double figure(const Figures& figures, std::string_view name) {
  const Figure* found = find_by_name(figures.list, name);
  return found != nullptr ? found->value : std::numeric_limits<double>::quiet_NaN();
}

TEST(Figures, OfEqualPicturesAreZero) {
  const Image image = grey(60, 40, noise);
  const Figures figures =
      all_figures({image.view(), image.view()}, {.texture = true, .patches = 3});
  for (const char* name :
       {"tone_rel", "tone_max", "de00_mean", "de00_max", "max_abs", "rms", "patch_dL_max"}) {
    EXPECT_EQ(figure(figures, name), 0) << name;
  }
  EXPECT_LT(figure(figures, "scielab_mean@40"), 1e-4);  // roundings to float
  for (const char* name : {"psnr", "hvs_snr@40", "hvs_snr_campbell@20"}) {
    EXPECT_EQ(figure(figures, name), HUGE_VAL) << name;
  }
}

TEST(Figures, RefuseOtherSizes) {
  const Image a = grey(8, 9, noise);
  const Image b = grey(9, 8, noise);
  EXPECT_THROW(all_figures({a.view(), b.view()}), std::invalid_argument);
  EXPECT_THROW(tone_figures(luminance(a.view()), luminance(b.view())), std::invalid_argument);
  EXPECT_THROW(scielab({a.view(), a.view()}, 0), std::invalid_argument);
}

TEST(Figures, WorkOnPicturesOfEverySmallSize) {
  for (int width = 1; width <= 12; ++width) {
    const Image a = grey(width, 13 - width, flat(0.5F));
    const Image b = grey(width, 13 - width, noise);
    const Figures figures = all_figures({a.view(), b.view()}, {.texture = true, .patches = 1});
    for (const Figure& f : figures.list) {
      if (f.name != "aniso_db") EXPECT_TRUE(std::isfinite(f.value)) << f.name << " " << width;
    }
  }
}

TEST(PixelFigures, AreOfEachPixel) {
  const Image a = grey(10, 10, flat(0.25F));
  const Image b = grey(10, 10, [](int x, int y) { return x + y == 0 ? 0.75F : 0.25F; });
  const PixelFigures figures = pixel_figures({a.view(), b.view()});
  EXPECT_NEAR(figures.max_abs, 0.5, 1e-7);
  EXPECT_NEAR(figures.rms, 0.05, 1e-7);
  EXPECT_EQ(figures.ciede2000_p95, 0);
  EXPECT_NEAR(figures.ciede2000_mean, figures.ciede2000_max / 100, 1e-7);
}

TEST(ToneFigures, TellWhatEachToneBecame) {
  const Image a = grey(340, 40, [](int x, int) { return static_cast<float>(x / 20) / 16; });
  const Image b = grey(340, 40, [](int x, int) { return static_cast<float>(x / 20) / 32; });
  const std::vector<TonePoint> points = patch_tones(luminance(a.view()), luminance(b.view()), 17);
  ASSERT_EQ(points.size(), 17U);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(points[i].reference, static_cast<double>(i) / 16, 1e-6);
    EXPECT_NEAR(points[i].result, static_cast<double>(i) / 32, 1e-6);
  }
  EXPECT_NEAR(lstar_difference(points[16]), 76.0693 - 100, 1e-4);  // L* of 1/2
  EXPECT_NEAR(tone_figures(luminance(a.view()), luminance(b.view())).relative, -0.5, 1e-6);
}

// Stripes two pixels wide, which go on where they are mirrored: one frequency, .25 a pixel.
TEST(HvsSnr, FallsWithTheDistance) {
  const Image a = grey(128, 128, flat(0.5F));
  const Image b = grey(128, 128, [](int x, int) { return (x + 1) / 2 % 2 == 0 ? 1.0F : 0.0F; });
  const Viewing viewings[] = {{&kNasanenFilter, 10}, {&kNasanenFilter, 40}, {&kNasanenFilter, 80}};
  const auto snr = hvs_snr(luminance(a.view()), luminance(b.view()), viewings);
  EXPECT_LT(snr[0], snr[1]);
  EXPECT_LT(snr[1], snr[2]);
  EXPECT_NEAR(snr[1], 20 * std::log10(std::exp(0.25 * 40 / 5.16889525)), 1e-6);
}

TEST(VisionFilters, PassLightAndFallOff) {
  for (const VisionFilter& filter : kVisionFilters) {
    SCOPED_TRACE(filter.name);
    EXPECT_EQ(filter.response(0, 0), 1);
    double last = 1;
    for (double f = 1; f < 60; ++f) {
      const double response = filter.response(f, 0);
      EXPECT_LE(response, last);
      EXPECT_EQ(response, filter.response(0, f));
      last = response;
    }
    EXPECT_LT(last, 0.02);
  }
  EXPECT_LT(campbell_response(20, 20), campbell_response(0, std::sqrt(800.0)));  // oblique
}

TEST(Scielab, BlursDitherAway) {
  const Image a = grey(96, 96, flat(0.5F));
  const Image b = grey(96, 96, [](int x, int y) { return (x + y) % 2 == 0 ? 1.0F : 0.0F; });
  EXPECT_GT(scielab({a.view(), b.view()}, 5).mean, 20);
  EXPECT_LT(scielab({a.view(), b.view()}, 120).mean, 0.5);
}

TEST(TextureFigures, OfACheckerboardAreOnePeak) {
  const Image image = grey(256, 256, [](int x, int y) { return (x + y) % 2 == 0 ? 1.0F : 0.0F; });
  const auto figures = texture_figures(luminance(image.view()));
  ASSERT_TRUE(figures);
  EXPECT_NEAR(figures->level, 0.5, 1e-9);
  EXPECT_EQ(figures->principal, 0.5);
  EXPECT_GT(figures->checker_share, 0.97);  // the window spreads it a little
  EXPECT_LT(figures->low_share, 1e-4);
  EXPECT_LT(figures->edge_bias, 1e-9);
  EXPECT_FALSE(figures->minority);
}

TEST(TextureFigures, OfWhiteNoiseAreFlatAndIsotropic) {
  const Image image = grey(512, 512, [](int x, int y) { return noise(x, y) < 0.1F ? 1.0F : 0.0F; });
  const auto figures = texture_figures(luminance(image.view()));
  ASSERT_TRUE(figures);
  EXPECT_EQ(figures->spectrum.segments, 49);
  EXPECT_NEAR(figures->low_share, figures->low_white, 0.1 * figures->low_white);
  EXPECT_NEAR(figures->anisotropy_db, -10 * std::log10(49.0 / 1.5), 1.5);  // segments overlap
  ASSERT_TRUE(figures->minority);
  EXPECT_NEAR(figures->minority->worm, 1, 0.05);
  // Poisson: half of the principal wavelength, spread .52; the grid keeps points apart
  EXPECT_NEAR(figures->minority->nearest_ratio, 0.5, 0.06);
}

TEST(TextureFigures, OfAFlatPictureAreNone) {
  const Image image = grey(64, 64, flat(0.3F));
  EXPECT_FALSE(texture_figures(luminance(image.view())));
  const Figures figures = all_figures({image.view(), image.view()}, {.texture = true});
  EXPECT_EQ(figure(figures, "flat"), 1);
}

}  // namespace
}  // namespace tristim
