#include "tristim/palette/quantize.h"

namespace tristim {
namespace {

std::uint8_t level(int i, int last) {
  return static_cast<std::uint8_t>((i * 255 * 2 + last) / (2 * last));
}

}  // namespace

std::vector<Color8> fixed_332(const Histogram& /*histogram*/, int /*colors*/) {
  std::vector<Color8> palette;
  for (int i = 0; i < 256; ++i) {
    palette.push_back({level(i >> 5, 7), level(i >> 2 & 7, 7), level(i & 3, 3)});
  }
  return palette;
}

}  // namespace tristim
