#include "tristim/dither/levels.h"

namespace tristim {

NearestLevel::NearestLevel(std::span<const float> threshold, std::span<const std::uint16_t> code)
    : search_(threshold), code_(code.begin(), code.end()) {}

void NearestLevel::row(ChannelRow<const float> in, ChannelRow<std::uint16_t> out) const noexcept {
  for (int x = 0; x < in.width; ++x) {
    out[x] = code_[static_cast<std::size_t>(search_.count_not_above(in[x]))];
  }
}

}  // namespace tristim
