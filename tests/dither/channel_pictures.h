#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "tristim/dither/levels.h"

namespace tristim {

using Codes = std::vector<std::uint16_t>;

inline const MixLevels kBlackAndWhite{{0, 1}, {0, 1}};
inline const MixLevels kUneven{{0, 0.1F, 0.15F, 0.7F, 1}, {0, 1, 2, 3, 4}};

/// One channel of light.
struct Picture {
  int width, height;
  std::vector<float> light;
};

inline Picture flat(int width, int height, float light) {
  return {width, height, std::vector<float>(static_cast<std::size_t>(width * height), light)};
}

inline Picture noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Picture picture = flat(width, height, 0);
  for (float& v : picture.light) v = std::uniform_real_distribution(-0.2F, 1.2F)(random);
  return picture;
}

}  // namespace tristim
