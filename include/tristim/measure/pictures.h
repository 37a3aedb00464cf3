#pragma once

#include <cstddef>
#include <vector>

#include "tristim/image/view.h"

namespace tristim {

/// Two pictures to compare, of one size: three channels of linear light in sRGB's primaries, 1 the
/// white. Finite; the functions that take a pair throw std::invalid_argument where the sizes
/// differ, a picture is empty or has other channels.
struct PicturePair {
  ImageView<const float> reference;
  ImageView<const float> result;
};

/// Relative luminance of a picture, row by row.
struct LuminanceMap {
  int width = 0;
  int height = 0;
  std::vector<double> value;

  double at(int x, int y) const noexcept { return value[index(x, y)]; }
  std::size_t index(int x, int y) const noexcept {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

/// Luminance of a picture of three channels in sRGB's primaries; white is 1.
LuminanceMap luminance(ImageView<const float> picture);

}  // namespace tristim
