#include <gtest/gtest.h>

#include "tristim/core/find.h"
#include "tristim/dither/matrices.h"
#include "tristim/dither/palette.h"

namespace tristim {
namespace {

using Indices = std::vector<std::uint16_t>;

const Metric& toe() { return *find_by_name(kMetrics, "oklab-toe"); }

// The mean of a field of a colour is as near as plans are: half a sixteenth of a step that the
// palette's entries are apart, and what the nearest in the metric leaves.
TEST(PaletteOrdered, KeepsTheMeanOfGreys) {
  const std::vector<Rgb> entries{{0, 0, 0}, {1, 1, 1}, {0.5, 0.5, 0.5}};
  const MixPalette palette(entries, toe(), Mix::kLight);
  const PaletteOrdered dither(palette, make_matrix(*find_by_name(kMatrixRecipes, "blue-noise")));
  for (float light = 0.02F; light < 1; light += 0.037F) {
    const std::vector<float> rgb(3 * 128, light);
    Indices indices(128);
    double sum = 0;
    for (int y = 0; y < 128; ++y) {
      dither.row(y, rgb, indices);
      for (const std::uint16_t i : indices) sum += entries[i].r;
    }
    EXPECT_NEAR(sum / (128 * 128), light, 1 / 32.0) << light;
  }
}

}  // namespace
}  // namespace tristim
