#pragma once

#include <cstdint>

namespace tristim::detail {

/// Chance by place, in [0, 1): the same for a pixel and a seed whoever asks and in whatever order,
/// so that bands and threads cannot change it. Rows above a picture have negative y.
inline float position_noise(int x, int y, std::uint32_t seed) noexcept {
  std::uint32_t h = (static_cast<std::uint32_t>(x) * 0x9E3779B1U) ^
                    (static_cast<std::uint32_t>(y) * 0x85EBCA77U + seed * 0xC2B2AE3DU);
  h = (h ^ (h >> 16)) * 0x7FEB352DU;
  h = (h ^ (h >> 15)) * 0x846CA68BU;
  h ^= h >> 16;
  return static_cast<float>(h >> 8) * 0x1p-24F;
}

/// A seed of 64 bits in 32.
inline std::uint32_t noise_seed(std::uint64_t seed) noexcept {
  return static_cast<std::uint32_t>(seed ^ (seed >> 32));
}

}  // namespace tristim::detail
