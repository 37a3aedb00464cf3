#pragma once

#include <stdexcept>
#include <string>

#include "tristim/measure/pictures.h"

namespace tristim::detail {

template <typename Picture>
std::string size_text(const Picture& picture) {
  return std::to_string(picture.width) + "x" + std::to_string(picture.height);
}

/// Throws std::invalid_argument where two pictures are no pair.
template <typename Picture>
void check_sizes(const Picture& reference, const Picture& result) {
  if (reference.width != result.width || reference.height != result.height) {
    throw std::invalid_argument("pictures to compare are " + size_text(reference) + " and " +
                                size_text(result) + ", not of one size");
  }
  if (reference.width < 1 || reference.height < 1) {
    throw std::invalid_argument("pictures to compare have no pixels");
  }
}

inline void check_pair(const PicturePair& pictures) {
  check_sizes(pictures.reference, pictures.result);
  if (pictures.reference.channels != 3 || pictures.result.channels != 3) {
    throw std::invalid_argument("pictures to compare have " +
                                std::to_string(pictures.reference.channels) + " and " +
                                std::to_string(pictures.result.channels) + " channels, not 3");
  }
}

/// A place on the endless mirrored continuation of 0..size-1, whose end pixels come twice.
inline int mirrored(int i, int size) noexcept {
  const int period = 2 * size;
  i %= period;
  if (i < 0) i += period;
  return i < size ? i : period - 1 - i;
}

}  // namespace tristim::detail
