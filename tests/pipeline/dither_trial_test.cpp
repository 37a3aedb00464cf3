// How good every dither is, beside what is asked of it: docs/dither-quality.md.
// TRISTIM_WRITE_DITHER_QUALITY=1 writes the page anew.

#include "tristim/pipeline/dither_trial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "lib/core/parallel.h"
#include "tests/support.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/device/display_file.h"
#include "tristim/image/memory.h"
#include "tristim/pipeline/reduce.h"
#include "tristim/plot/svg.h"
#include "tristim/render/spheres.h"

namespace tristim {
namespace {

constexpr double kToneBound = 0.15;  // of L*

Image spheres() {
  const SpheresOptions options{.width = 480, .height = 270, .samples = 4};
  ImageSink sink(options.width, options.height, 3);
  render_spheres(default_scene(), options, sink);
  sink.finish();
  Image copy(options.width, options.height, 3);
  for (int y = 0; y < options.height; ++y) {
    const auto row = sink.image().view().row(y);
    std::transform(row.begin(), row.end(), copy.view().row(y).begin(),
                   [](float light) { return std::clamp(light, 0.0F, 1.0F); });
  }
  return copy;
}

Display two_bit_display() {
  Display display = one_bit_display();
  display.frame.packing = *find_by_name(kPackings, "gray2");
  display.response = SrgbResponse{};
  return display;
}

// Whether the tones of a method can be as fine as the bound: a matrix has as many tones as entries,
// and Atkinson's kernel loses a quarter of the error by design.
bool keeps_tone(const NamedDither& dither) {
  if (std::holds_alternative<NoDither>(dither.method) || dither.name == "atkinson") return false;
  for (const ThresholdMatrix& matrix : dither_matrices(dither.method, {}, 1)) {
    if (matrix.ranks < 64 * 64) return false;
  }
  return true;
}

std::string cell(const std::string& text) { return " " + text + " |"; }

std::string texture_cells(const std::optional<TextureFigures>& texture) {
  if (!texture) return cell("flat") + cell("") + cell("");
  return cell(fixed_text(texture->anisotropy_db, 1)) + cell(fixed_text(texture->peak_share, 5)) +
         cell(fixed_text(texture->edge_bias, 3));
}

std::string row_of(const NamedDither& dither, ImageView<const float> picture,
                   const Display& palette) {
  const Display one_bit = one_bit_display();
  const DitherTrial trial{one_bit, dither};
  const DitherFigures figures = judge_dither(picture, dither_picture(picture, trial), trial);
  const Display two_bits = two_bit_display();
  const double tone_two_bits = dither_tone({two_bits, dither});
  const double tone_palette = dither_tone({palette, dither});
  if (keeps_tone(dither)) {
    EXPECT_LE(figures.tone_lstar, kToneBound) << dither.name;
    EXPECT_LE(tone_two_bits, kToneBound) << dither.name << ", 2 bits";
    EXPECT_LE(tone_palette, kToneBound) << dither.name << ", palette";
  }
  return "| " + dither.name + " |" + cell(fixed_text(figures.tone_lstar, 2)) +
         cell(fixed_text(tone_two_bits, 2)) + cell(fixed_text(tone_palette, 2)) +
         cell(fixed_text(figures.hvs_snr_db, 2)) + cell(fixed_text(figures.scielab_mean, 2)) +
         texture_cells(dither_texture(trial)) + "\n";
}

std::string page() {
  std::string text =
      "# How good the dithers are\n\n"
      "*tone* is the largest |dL*| over 17 patches, sRGB k/16, of 256 x 256 pixels side by side, "
      "on "
      "a display of 1 bit, of 2 bits behind\nthe sRGB curve, and on the palette of `epaper-4grey`; "
      "a "
      "test holds every method that can to .15 (a matrix of n entries has n + 1\ntones, Atkinson's "
      "kernel loses error by design). *HVS-SNR* in dB and *S-CIELAB* are of the spheres, 480x270, "
      "in "
      "1 bit, at 40 samples per\ndegree. Texture is of a grey of 1/16 of the light in 1 bit: "
      "*anisotropy* in dB, the share of the strongest frequency (*peak*) and the bias of "
      "the\nfirst "
      "rows (*edge*). Wanted are at most -10, .0005 and .1 at once.\n\n"
      "`tests/pipeline/dither_trial_test.cpp` measures, compares this page and, with "
      "`TRISTIM_WRITE_DITHER_QUALITY=1`, writes it;\n`tristim halftone gallery` does the same for "
      "a "
      "picture of yours.\n\n"
      "| dither | tone, 1 bit | 2 bits | palette | HVS-SNR | S-CIELAB | anisotropy | peak | edge "
      "|\n"
      "|---|---|---|---|---|---|---|---|---|\n";
  const Image picture = spheres();
  const Display palette = load_display("epaper-4grey");
  const std::vector<NamedDither>& dithers = dither_methods();
  std::vector<std::string> rows(dithers.size());
  detail::parallel_for_rows(static_cast<int>(dithers.size()), 0, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    rows[at] = row_of(dithers[at], picture.view(), palette);
  });
  for (const std::string& row : rows) text += row;
  return text;
}

TEST(DitherTrial, IsAsGoodAsThePageSays) {
  const std::string measured = page();
  const std::filesystem::path path = source_file("docs/dither-quality.md");
  if (std::getenv("TRISTIM_WRITE_DITHER_QUALITY") != nullptr) write_bytes(path, measured);
  EXPECT_EQ(read_bytes(path), measured) << "write it anew: TRISTIM_WRITE_DITHER_QUALITY=1";
}

// One method that an eye takes for even grey, and that starts at the edge as it goes on.
TEST(DitherTrial, DefaultHasAnEvenTexture) {
  const Display display = one_bit_display();
  const auto texture = dither_texture({display, default_dither(display)});
  ASSERT_TRUE(texture);
  EXPECT_LE(texture->anisotropy_db, -10);
  EXPECT_LE(texture->peak_share, 0.0005);
  EXPECT_LE(texture->edge_bias, 0.1);
}

// Smaller dots that grow on paper have the tone of those that do not.
TEST(DitherTrial, SeesDotsWithTheirGain) {
  Display laser = load_display("laser-300");
  laser.dots->gain = MurrayDaviesGain{0.2};
  const NamedDither& blue = *find_by_name(dither_methods(), "blue-noise");
  EXPECT_LE(dither_tone({laser, blue}), kToneBound);  // measured: .04
  // Four inks of which the sum is black; they meet by chance.
  const Display press = load_display("offset-cmyk");
  EXPECT_LE(dither_tone({press, blue}), 0.5);  // measured: .34
}

TEST(TakesDither, MethodsForWholePicturesTakeNoPalette) {
  const NamedDither& search = *find_by_name(dither_methods(), "direct-search");
  const NamedDither& kernel = *find_by_name(dither_methods(), "floyd-steinberg");
  for (const char* device : {"vga16", "offset-cmyk", "laser-300", "lcd-rgb565"}) {
    SCOPED_TRACE(device);
    const Display display = load_display(device);
    EXPECT_EQ(takes_dither(display, search.method), std::string_view(device) != "vga16");
    EXPECT_TRUE(takes_dither(display, kernel.method));
  }
}

TEST(DitherTrial, ShowsCodesAsLight) {
  const Display display = one_bit_display();
  const Image ramp = grey_ramp(64, 8);
  const DitheredPicture result =
      dither_picture(ramp.view(), {display, *find_by_name(dither_methods(), "bayer8")});
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 64; ++x) {
      const float light = *result.codes.view().pixel(x, y) == 0 ? 0.0F : 1.0F;
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(result.light.view().pixel(x, y)[i], light, 1e-6F);
    }
  }
  EXPECT_EQ(*ramp.view().pixel(0, 0), 0);
  EXPECT_EQ(*ramp.view().pixel(63, 7), 1);
}

}  // namespace
}  // namespace tristim
