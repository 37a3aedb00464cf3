#include "tristim/pipeline/proof.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/pipeline/pictures.h"
#include "tristim/color/difference.h"
#include "tristim/color/lab.h"
#include "tristim/color/transfer.h"
#include "tristim/core/find.h"
#include "tristim/device/display_file.h"
#include "tristim/pipeline/chain.h"

namespace tristim {
namespace {

// Runs a picture with a proof and a measurement; returns the mean difference.
double proofed(const Display& display, const Image& picture, std::string_view dither,
               CodeCollector& codes, CodeCollector& proof, int threads = 1) {
  const int width = picture.view().width;
  Image copy(width, picture.view().height, 3);
  for (int y = 0; y < copy.view().height; ++y) {
    std::ranges::copy(picture.view().row(y), copy.view().row(y).begin());
  }
  ImageSource source(std::move(copy));
  const std::vector<Stage> stages{
      ConvertPrimaries{rgb_from_rgb(display.primaries, {}, Adaptation::kBradford)}, GamutMap{}};
  Settings settings;
  settings.dither = *find_by_name(dither_methods(), dither);
  const ReduceOptions options = reduce_options(display, settings);
  Reducer reducer(display, options, width);
  ProofObserver proof_observer(display, proof, seen_dots(display, options));
  DifferenceObserver difference(Primaries{}, Adaptation::kBradford, display, 0);
  BandObserver* const observers[] = {&proof_observer, &difference};
  run(source, stages, reducer, codes, observers, {threads, 5});
  proof_observer.finish();
  return difference.mean_ciede2000();
}

TEST(Proof, OfAnSrgbMonitorIsItsCodes) {
  CodeCollector codes;
  CodeCollector proof;
  const double difference =
      proofed(load_display("srgb"), test_picture(31, 17), "none", codes, proof);
  EXPECT_EQ(proof.codes, codes.codes);
  EXPECT_LT(difference, 0.3);  // half a code; .5 in the darks
  EXPECT_GT(difference, 0);
}

TEST(Proof, OfAPaletteIsMadeOfItsColours) {
  const Display vga = load_display("vga16");
  CodeCollector codes;
  CodeCollector proof;
  proofed(vga, test_picture(31, 17), "floyd-steinberg", codes, proof);
  const FrameInfo info = frame_info(vga, 31, 17);
  ASSERT_EQ(proof.codes.size(), 3 * codes.codes.size());
  for (std::size_t i = 0; i < codes.codes.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_EQ(proof.codes[3 * i + c], info.palette[codes.codes[i]].srgb[c]);
    }
  }
}

TEST(Proof, OfAGreyDeviceIsGrey) {
  CodeCollector codes;
  CodeCollector proof;
  proofed(load_display("epaper-4grey"), test_picture(31, 17), "bayer4", codes, proof);
  for (std::size_t i = 0; i < proof.codes.size(); i += 3) {
    EXPECT_EQ(proof.codes[i], proof.codes[i + 1]);
    EXPECT_EQ(proof.codes[i], proof.codes[i + 2]);
  }
}

// Mean light of a proof in its middle, where no edge is near.
Rgb proof_light(const CodeCollector& proof, int width) {
  const int height = static_cast<int>(proof.codes.size()) / 3 / width;
  Rgb sum;
  int count = 0;
  for (int y = height / 4; y < 3 * height / 4; ++y) {
    for (int x = width / 4; x < 3 * width / 4; ++x, ++count) {
      const std::uint16_t* p = &proof.codes[static_cast<std::size_t>(3 * (y * width + x))];
      sum.r += srgb_decode(p[0] / 255.0);
      sum.g += srgb_decode(p[1] / 255.0);
      sum.b += srgb_decode(p[2] / 255.0);
    }
  }
  return {sum.r / count, sum.g / count, sum.b / count};
}

// The dots are asked for less, and the proof shows the tone that they grow to.
TEST(Proof, ShowsTheToneOfDotsThatGain) {
  constexpr int kSide = 192;
  const DotGain gains[] = {MurrayDaviesGain{0.14}, YuleNielsenGain{1.8, 0.02},
                           MeasuredGain{{0, 0.4, 0.5, 1}, {0, 0.58, 0.7, 1}},
                           MeasuredGain{{0, 0.5, 1}, {0, 0.4, 1}}};  // dots that shrink
  Display laser = load_display("laser-300");
  double worst = 0;  // of L*
  for (const DotGain& gain : gains) {
    laser.dots->gain = gain;
    for (const char* dither : {"screen", "blue-noise", "floyd-steinberg"}) {
      SCOPED_TRACE(dither + (": " + describe(gain)));
      for (const float tone : {0.1F, 0.3F, 0.5F, 0.7F, 0.95F}) {
        CodeCollector codes;
        CodeCollector proof;
        proofed(laser, flat_picture(kSide, kSide, tone, tone, tone), dither, codes, proof);
        ASSERT_EQ(proof.codes.size(), std::size_t{3} * kSide * kSide);
        const double shown = lstar_from_luminance(proof_light(proof, kSide).g);
        worst = std::max(worst, std::fabs(shown - lstar_from_luminance(tone)));
      }
    }
  }
  // Largest measured: .53, of the screen, whose dots the middle of the picture cuts.
  EXPECT_LT(worst, 0.7) << worst;
}

// What is far from dots is as bare, or as solid, as without gain.
TEST(Proof, LeavesPaperAndSolidsAlone) {
  Display laser = load_display("laser-300");
  laser.dots->gain = MurrayDaviesGain{0.2};
  for (const float tone : {0.0F, 1.0F}) {
    CodeCollector codes;
    CodeCollector proof;
    proofed(laser, flat_picture(33, 9, tone, tone, tone), "clustered8", codes, proof);
    EXPECT_EQ(proof.codes, std::vector<std::uint16_t>(std::size_t{3} * 33 * 9,
                                                      static_cast<std::uint16_t>(tone * 255)));
  }
}

TEST(DifferenceObserver, IsZeroWhereTheDeviceShowsWhatWasAsked) {
  for (const BuiltInDisplay& built_in : built_in_displays()) {
    SCOPED_TRACE(built_in.name);
    CodeCollector codes;
    CodeCollector proof;
    const Display display = load_display(std::string(built_in.name));
    const double white = proofed(display, flat_picture(8, 8, 1, 1, 1), "none", codes, proof);
    EXPECT_LT(white, 1e-3);  // floats of the way through two matrices
  }
}

// Half of the light on a 1-bit device: black everywhere, or white, asked for L* 76.07.
TEST(DifferenceObserver, IsTheMeanOverThePixels) {
  CodeCollector codes;
  CodeCollector proof;
  const Display laser = load_display("laser-300");
  const double mean =
      proofed(laser, flat_picture(16, 16, 0.5F, 0.5F, 0.5F), "bayer2", codes, proof);
  const Lab asked{lstar_from_luminance(0.5), 0, 0};
  const double expected = (ciede2000(asked, {0, 0, 0}) + ciede2000(asked, {100, 0, 0})) / 2;
  EXPECT_NEAR(mean, expected, 1e-4);  // float light
}

TEST(DifferenceObserver, DoesNotDependOnThreads) {
  const Display display = load_display("epaper-7color");
  CodeCollector codes;
  CodeCollector proof;
  const double one = proofed(display, test_picture(31, 17), "floyd-steinberg", codes, proof, 1);
  CodeCollector codes_again;
  CodeCollector proof_again;
  const double seven =
      proofed(display, test_picture(31, 17), "floyd-steinberg", codes_again, proof_again, 7);
  EXPECT_EQ(one, seven);
  EXPECT_EQ(proof.codes, proof_again.codes);
}

TEST(DifferenceObserver, IsZeroBeforeTheFirstPixel) {
  EXPECT_EQ(DifferenceObserver({}, Adaptation::kNone, Display{}, 0).mean_ciede2000(), 0);
}

struct SharedSink : RowSink {
  explicit SharedSink(ImageSink& to) : sink(to) {}
  void write(ImageView<const float> rows) override { sink.write(rows); }
  void finish() override { sink.finish(); }
  ImageSink& sink;
};

// Dots of several screens fall on one another by chance only on the whole of a page.
constexpr double kPrintError = 0.01;

TEST(DecodingSink, WritesTheLightOfTheCodes) {
  const Display vga = load_display("vga16");
  ImageSink light(3, 2, 3);
  const auto sink = decoding_sink(vga, std::make_unique<SharedSink>(light));
  Raster<std::uint16_t> codes(3, 2, 1);
  codes.view().pixel(1, 0)[0] = 15;
  codes.view().pixel(2, 1)[0] = 6;
  sink->write(codes.view());
  sink->finish();
  const auto view = light.image().view();
  EXPECT_NEAR(view.pixel(1, 0)[0], 1, 1e-6);
  EXPECT_NEAR(view.pixel(2, 1)[0], 0.40198F, 1e-5);  // 170/255 of the sRGB curve
  EXPECT_NEAR(view.pixel(2, 1)[1], 0.09084F, 1e-5);  // 85/255
  EXPECT_NEAR(view.pixel(0, 1)[2], 0, 1e-6);
}

// Inks as light, where no code clips what sRGB has not.
TEST(DecodingSink, WritesTheLightOfInksThatGain) {
  constexpr int kSide = 384;
  const Display press = load_display("offset-cmyk");
  const Rgb black = darkest_print(*press.press);
  const ReduceOptions options = reduce_options(press, {});
  for (const Rgb& light : {Rgb{0.2, 0.2, 0.2}, Rgb{0.5, 0.4, 0.3}, Rgb{0.3, 0.5, 0.6}}) {
    Reducer reducer(press, options, kSide);
    ImageSink shown(kSide, kSide, 3);
    const auto sink =
        decoding_sink(press, std::make_unique<SharedSink>(shown), seen_dots(press, options));
    ImageSource source(flat_picture(kSide, kSide, static_cast<float>(light.r),
                                    static_cast<float>(light.g), static_cast<float>(light.b)));
    run(source, {}, reducer, *sink);
    sink->finish();
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const float* p = shown.image().view().pixel(x, y);
        mean += Eigen::Vector3d(p[0], p[1], p[2]) / (kSide * kSide);
      }
    }
    EXPECT_NEAR(mean[0], black.r + (1 - black.r) * light.r, kPrintError);
    EXPECT_NEAR(mean[1], black.g + (1 - black.g) * light.g, kPrintError);
    EXPECT_NEAR(mean[2], black.b + (1 - black.b) * light.b, kPrintError);
  }
}

}  // namespace
}  // namespace tristim
