#include "tristim/palette/weights.h"

#include <algorithm>
#include <cstdlib>

namespace tristim {
namespace {

// Difference of codes from a neighbour at which a pixel counts half.
constexpr int kHalf = 16;

int difference(const std::uint16_t* a, const std::uint16_t* b) noexcept {
  int most = 0;
  for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(a[c] - b[c]));
  return most;
}

}  // namespace

void contrast_weights(ImageView<const std::uint16_t> codes, std::span<const std::uint16_t> above,
                      ImageView<std::uint16_t> weights) noexcept {
  for (int y = 0; y < codes.height; ++y) {
    const std::uint16_t* up = y > 0 ? codes.row(y - 1).data() : above.data();
    for (int x = 0; x < codes.width; ++x) {
      const std::uint16_t* pixel = codes.pixel(x, y);
      int activity = 0;
      if (x > 0) activity = std::max(activity, difference(pixel, pixel - 3));
      if (up != nullptr) activity = std::max(activity, difference(pixel, up + 3 * x));
      weights.pixel(x, y)[0] =
          static_cast<std::uint16_t>(std::max(kFlatWeight * kHalf / (kHalf + activity), 1));
    }
  }
}

}  // namespace tristim
