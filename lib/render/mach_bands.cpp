#include "tristim/render/mach_bands.h"

#include <cstddef>

namespace tristim {

void mach_bands(ImageView<const float> intensity, ImageView<float> bands) noexcept {
  for (int y = 0; y < intensity.height; ++y) {
    const bool inner_row = y > 0 && y + 1 < intensity.height;
    for (int x = 0; x < intensity.width; ++x) {
      const bool inner_column = x > 0 && x + 1 < intensity.width;
      const float* here = intensity.pixel(x, y);
      float* band = bands.pixel(x, y);
      for (int c = 0; c < intensity.channels; ++c) {
        const double centre = here[c];
        // Neighbours first: rounding then leaves nothing where the three are linear.
        double jump = 0;
        if (inner_column) {
          jump += (centre - here[c - intensity.channels]) - (here[c + intensity.channels] - centre);
        }
        if (inner_row) {
          jump += (centre - here[c - intensity.stride]) - (here[c + intensity.stride] - centre);
        }
        band[c] = static_cast<float>(jump);
      }
    }
  }
}

}  // namespace tristim
