#include "tristim/pipeline/reduce.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/error_text.h"
#include "tests/pipeline/pictures.h"
#include "tristim/core/find.h"
#include "tristim/device/display_file.h"
#include "tristim/dither/matrices.h"
#include "tristim/pipeline/chain.h"

namespace tristim {
namespace {

using Codes = std::vector<std::uint16_t>;

DitherMethod method(std::string_view name) { return find_by_name(dither_methods(), name)->method; }

Display with_packing(std::string_view name) {
  Display display;
  display.frame.packing = *find_by_name(kPackings, name);
  return display;
}

Codes reduced(const Display& display, const ReduceOptions& options, Image image) {
  const ImageView<float> light = image.view();
  Reducer reducer(display, options, light.width);
  Raster<std::uint16_t> codes(light.width, light.height, reducer.samples());
  reducer.reduce({light, 0}, codes.view());
  const auto view = codes.view();
  return {view.data, view.data + std::ptrdiff_t{view.stride} * view.height};
}

Codes pixel(const Display& display, const ReduceOptions& options, float r, float g, float b) {
  return reduced(display, options, flat_picture(1, 1, r, g, b));
}

double share_of(const Codes& codes, std::uint16_t code) {
  return static_cast<double>(std::ranges::count(codes, code)) / static_cast<double>(codes.size());
}

TEST(DitherMethods, AreNoneAndAllOfEveryKind) {
  EXPECT_EQ(dither_methods().size(), 1 + kMatrixRecipes.size() + kScreenRecipes.size() +
                                         kDiffusionKernels.size() + kWholePictureDithers.size());
  EXPECT_EQ(dither_methods()[0].name, "none");
  for (const MatrixRecipe& m : kMatrixRecipes) EXPECT_TRUE(find_by_name(dither_methods(), m.name));
}

TEST(DefaultDither, SuitsTheDevice) {
  const auto name = [](const char* device) { return default_dither(load_display(device)).name; };
  EXPECT_EQ(name("srgb"), "none");
  EXPECT_EQ(name("crt-p22"), "none");
  EXPECT_EQ(name("lcd-rgb565"), "floyd-steinberg");
  EXPECT_EQ(name("epaper-4grey"), "floyd-steinberg");
  EXPECT_EQ(name("vga16"), "floyd-steinberg");
  EXPECT_EQ(default_dither(with_palette(load_display("vga16"), {{0, 0, 0}, {255, 0, 0}})).name,
            "blue-diffusion");
  EXPECT_EQ(name("laser-300"), "clustered8");
  EXPECT_EQ(name("offset-cmyk"), "screen");
}

// Chosen in perception, mixed in light, on every kind of 1-bit device.
TEST(Reducer, LightsAsManyDotsAsThereIsLight) {
  for (const char* packing : {"mono1", "index1"}) {
    for (const Response& response : {Response{LinearResponse{}}, Response{GammaResponse{}}}) {
      Display display = with_packing(packing);
      display.response = response;
      if (display.frame.packing.indexed) {
        const Xyz white = white_xyz(kD65);
        display.palette = {{0, {}, ""}, {1, white, ""}};
      }
      for (const NamedDither& dither : dither_methods()) {
        if (display.frame.packing.indexed &&
            std::holds_alternative<WholePictureDither>(dither.method))
          continue;
        const auto* matrix = std::get_if<MatrixRecipe>(&dither.method);
        const auto* kernel = std::get_if<DiffusionKernel>(&dither.method);
        if (kernel != nullptr && passed_on(*kernel) < 1) continue;
        if (dither.name == "none" || (matrix != nullptr && matrix->size < 8)) continue;
        for (const bool serpentine : {false, true}) {
          const Codes codes =
              reduced(display, {.dither = dither.method, .parameters = {.serpentine = serpentine}},
                      flat_picture(256, 256, 0.2159F, 0.2159F, 0.2159F));
          EXPECT_NEAR(share_of(codes, 1), 0.2159, 0.005) << packing << " " << dither.name;
        }
      }
    }
  }
}

TEST(Reducer, KeepsTheLuminanceOfColoursThatAFlatPaletteCannotMix) {
  Display display = with_packing("index1");
  display.palette = {{0, {}, ""}, {1, white_xyz(kD65), ""}};
  for (const char* dither : {"bayer16", "floyd-steinberg"}) {
    const ReduceOptions options{.dither = method(dither),
                                .metric = *find_by_name(kMetrics, "oklab-toe")};
    for (const auto& [r, g, b] : std::vector<std::array<float, 3>>{
             {0.2159F, 0.2159F, 0.2159F}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.8F, 0.2F, 0.1F}}) {
      const Codes codes = reduced(display, options, flat_picture(256, 256, r, g, b));
      EXPECT_NEAR(share_of(codes, 1), 0.2126 * r + 0.7152 * g + 0.0722 * b, 0.005) << dither;
    }
  }
}

TEST(Reducer, EncodedMixLightsHalfOfTheDots) {
  for (const char* dither : {"bayer8", "bayer16", "clustered8", "floyd-steinberg"}) {
    const Codes codes =
        reduced(with_packing("mono1"), {.dither = method(dither), .mix = Mix::kEncoded},
                flat_picture(256, 256, 0.2159F, 0.2159F, 0.2159F));
    EXPECT_NEAR(share_of(codes, 1), 128 / 255.0, 0.005) << dither;
  }
}

TEST(Reducer, WithoutDitherTakesTheNearestCode) {
  const float half = 0.21586F;  // sRGB 128
  EXPECT_EQ(pixel(with_packing("rgb888"), {}, 0, half, 1), (Codes{0, 128, 255}));
  EXPECT_EQ(pixel(with_packing("rgb565"), {}, 0, half, 1), (Codes{0, 32, 31}));
  EXPECT_EQ(pixel(with_packing("gray8"), {}, half, half, half), (Codes{128}));
  EXPECT_EQ(pixel(with_packing("rgb888"), {}, -3, 0.5F, 40), (Codes{0, 188, 255}));
}

TEST(Reducer, WeighsGreysByTheLuminanceOfThePrimaries) {
  // .7152 of green, .0722 of blue [IEC61966], in 16 linear bits.
  Display display = with_packing("gray16");
  display.response = LinearResponse{};
  EXPECT_EQ(pixel(display, {}, 0, 1, 0)[0], 46869);  // .71516868 65535
  EXPECT_EQ(pixel(display, {}, 0, 0, 1)[0], 4731);
  EXPECT_EQ(pixel(display, {}, 1, 1, 1)[0], 65535);
}

TEST(Reducer, RefusesWholePictureMethodsForPalettes) {
  for (const WholePictureDither& dither : kWholePictureDithers) {
    EXPECT_THROW(Reducer(load_display("vga16"), {.dither = dither}, 8), std::invalid_argument);
  }
}

TEST(Reducer, MapsBlackAndWhiteToTheEndsOfEveryDevice) {
  for (const BuiltInDisplay& built_in : built_in_displays()) {
    const Display display = load_display(std::string(built_in.name));
    if (display.press) continue;  // its black is a share of each ink, which no single dot shows
    const Decoder decoder(display);
    for (const NamedDither& dither : dither_methods()) {
      if (display.frame.packing.indexed &&
          std::holds_alternative<WholePictureDither>(dither.method))
        continue;
      SCOPED_TRACE(testing::Message() << built_in.name << " " << dither.name);
      const Codes white = pixel(display, {.dither = dither.method}, 1, 1, 1);
      const Codes black = pixel(display, {.dither = dither.method}, 0, 0, 0);
      EXPECT_NEAR(decoder.light(white.data()).g, 1, 1e-6);
      EXPECT_LT(decoder.light(black.data()).g, 0.2);
      EXPECT_NE(white, black);
    }
  }
}

// Levels of light .25 and 1 on paper: half way in light is .625, in lightness less.
TEST(Reducer, ChoosesGreysOfAPaletteInTheMetric) {
  Display display = with_packing("mono1");
  const Xyz white = white_xyz(kD65);
  display.palette = {{0, white, "paper"}, {1, {}, "toner"}};
  const auto code = [&](std::string_view metric, float grey) {
    return pixel(display, {.metric = *find_by_name(kMetrics, metric)}, grey, grey, grey)[0];
  };
  EXPECT_EQ(code("linear", 0.49F), 1);
  EXPECT_EQ(code("linear", 0.51F), 0);
  EXPECT_EQ(code("lab", 0.183F), 1);  // L* 50 at .18419
  EXPECT_EQ(code("lab", 0.185F), 0);
  EXPECT_EQ(code("oklab", 0.124F), 1);  // L .5 at .125
  EXPECT_EQ(code("oklab", 0.126F), 0);
}

// Gain .2 at half tone: 50 % of ink looks like 70 %, so tone .3 asks for half of the dots.
TEST(Reducer, PrintsFewerDotsWhereTheyGain) {
  Display display = with_packing("mono1");
  display.response = LinearResponse{};
  display.dots = Dots{.gain = MurrayDaviesGain{0.2}};
  const Codes codes =
      reduced(display, {.dither = method("bayer16")}, flat_picture(64, 64, 0.3F, 0.3F, 0.3F));
  EXPECT_NEAR(share_of(codes, 1), 0.5, 1 / 256.0);
  EXPECT_EQ(pixel(display, {.dither = method("bayer16")}, 0, 0, 0), Codes{0});
  EXPECT_EQ(pixel(display, {.dither = method("bayer16")}, 1, 1, 1), Codes{1});
}

TEST(Reducer, NeedsAPaletteForIndices) {
  EXPECT_EQ(error_text([] { Reducer(with_packing("index4"), {}, 8); }),
            "invalid: display: an indexed packing needs a palette");
}

TEST(Reducer, ExplainsItsSteps) {
  for (const BuiltInDisplay& built_in : built_in_displays()) {
    const Display display = load_display(std::string(built_in.name));
    const std::vector<StepReport> steps =
        Reducer(display, {.dither = method("bayer8")}, 4).explain();
    ASSERT_EQ(steps.size(), 3U) << built_in.name;
    EXPECT_EQ(steps[0].name, "black and white");
    EXPECT_EQ(steps[1].name, display.press                   ? "inks"
                             : display.frame.packing.indexed ? "palette"
                                                             : "response");
    EXPECT_EQ(steps[2].name, "dither bayer8");
  }
}

}  // namespace
}  // namespace tristim
