#pragma once

#include <bit>
#include <cstdint>

namespace tristim::detail {

/// An exponent as power-inl.h reads it: 12 bits and what is left of it, so that `head` times a
/// whole number of 12 bits is exact in a float.
struct Exponent {
  float all = 0, head = 0, tail = 0;
};

inline Exponent exponent_of(double n) noexcept {
  const auto all = static_cast<float>(n);
  const auto head = std::bit_cast<float>(std::bit_cast<std::uint32_t>(all) & ~0xFFFU);
  return {all, head, static_cast<float>(n - head)};
}

}  // namespace tristim::detail
