#include "tristim/frame/pack.h"

#include <algorithm>

namespace tristim {
namespace {

/// Of the pixel in the frame buffer: 3-sample pixels below 24 bits fill a byte or a 16-bit word.
int stored_bits(const Packing& packing) noexcept {
  const int bits = packing.bits_per_pixel();
  if (packing.samples == 1 || bits > 16) return bits;
  return bits > 8 ? 16 : 8;
}

bool is_one_word(const Packing& packing) noexcept {
  return packing.samples == 3 && packing.bits_per_pixel() <= 16;
}

constexpr unsigned mask(int bits) noexcept { return (1u << bits) - 1; }

/// Where the high and the low byte of a 16-bit word are.
struct WordBytes {
  std::size_t high, low;
  explicit WordBytes(ByteOrder order) noexcept
      : high(order == ByteOrder::kBig ? 0 : 1), low(1 - high) {}
};

void put_word(unsigned word, WordBytes at, std::uint8_t* bytes) noexcept {
  bytes[at.high] = static_cast<std::uint8_t>(word >> 8);
  bytes[at.low] = static_cast<std::uint8_t>(word);
}

unsigned get_word(const std::uint8_t* bytes, WordBytes at) noexcept {
  return unsigned{bytes[at.high]} << 8 | bytes[at.low];
}

/// How far each sample of a one-word pixel is shifted up.
struct Shifts {
  int r, g, b;
  explicit Shifts(const Packing& packing) noexcept {
    const auto& bits = packing.bits;
    r = packing.blue_first ? 0 : bits[1] + bits[2];
    g = packing.blue_first ? bits[0] : bits[2];
    b = packing.blue_first ? bits[0] + bits[1] : 0;
  }
};

void pack_one_word(std::span<const std::uint16_t> codes, const FrameLayout& layout,
                   std::span<std::uint8_t> bytes) noexcept {
  const auto& bits = layout.packing.bits;
  const Shifts shift(layout.packing);
  const WordBytes at(layout.byte_order);
  const bool two_bytes = stored_bits(layout.packing) == 16;
  for (std::size_t pixel = 0; pixel < codes.size() / 3; ++pixel) {
    const std::uint16_t* rgb = &codes[pixel * 3];
    const unsigned word = (rgb[0] & mask(bits[0])) << shift.r |
                          (rgb[1] & mask(bits[1])) << shift.g | (rgb[2] & mask(bits[2])) << shift.b;
    if (two_bytes) {
      put_word(word, at, &bytes[pixel * 2]);
    } else {
      bytes[pixel] = static_cast<std::uint8_t>(word);
    }
  }
}

void unpack_one_word(std::span<const std::uint8_t> bytes, const FrameLayout& layout,
                     std::span<std::uint16_t> codes) noexcept {
  const auto& bits = layout.packing.bits;
  const Shifts shift(layout.packing);
  const WordBytes at(layout.byte_order);
  const bool two_bytes = stored_bits(layout.packing) == 16;
  for (std::size_t pixel = 0; pixel < codes.size() / 3; ++pixel) {
    const unsigned word = two_bytes ? get_word(&bytes[pixel * 2], at) : bytes[pixel];
    codes[pixel * 3] = static_cast<std::uint16_t>(word >> shift.r & mask(bits[0]));
    codes[pixel * 3 + 1] = static_cast<std::uint16_t>(word >> shift.g & mask(bits[1]));
    codes[pixel * 3 + 2] = static_cast<std::uint16_t>(word >> shift.b & mask(bits[2]));
  }
}

/// Several pixels in a byte.
void pack_parts(std::span<const std::uint16_t> codes, const FrameLayout& layout,
                std::span<std::uint8_t> bytes) noexcept {
  const int bits = layout.packing.bits[0];
  const std::size_t pixels_per_byte = 8u / static_cast<unsigned>(bits);
  const bool msb = layout.bit_order == BitOrder::kMsb;
  std::size_t i = 0;
  for (std::uint8_t& byte : bytes) {
    unsigned value = 0;
    int shift = msb ? 8 - bits : 0;
    const std::size_t end = std::min(i + pixels_per_byte, codes.size());
    for (; i < end; ++i) {
      value |= (codes[i] & mask(bits)) << shift;
      shift += msb ? -bits : bits;
    }
    byte = static_cast<std::uint8_t>(value);
  }
}

void unpack_parts(std::span<const std::uint8_t> bytes, const FrameLayout& layout,
                  std::span<std::uint16_t> codes) noexcept {
  const int bits = layout.packing.bits[0];
  const int pixels_per_byte = 8 / bits;
  const bool msb = layout.bit_order == BitOrder::kMsb;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const int place = static_cast<int>(i % static_cast<unsigned>(pixels_per_byte)) * bits;
    const unsigned byte = bytes[i / static_cast<unsigned>(pixels_per_byte)];
    codes[i] = static_cast<std::uint16_t>(byte >> (msb ? 8 - bits - place : place) & mask(bits));
  }
}

/// The sample that stands at place `i` of a row with whole bytes or words a sample.
std::size_t sample_at(std::size_t i, bool exchange) noexcept {
  return exchange ? i + 2 - 2 * (i % 3) : i;
}

}  // namespace

std::size_t packed_row_bytes(const Packing& packing, int width) noexcept {
  return (static_cast<std::size_t>(width) * static_cast<unsigned>(stored_bits(packing)) + 7) / 8;
}

void pack_row(std::span<const std::uint16_t> codes, const FrameLayout& layout,
              std::span<std::uint8_t> bytes) noexcept {
  const Packing& packing = layout.packing;
  if (is_one_word(packing)) return pack_one_word(codes, layout, bytes);
  if (packing.bits[0] < 8) return pack_parts(codes, layout, bytes);
  const bool exchange = packing.blue_first;
  if (packing.bits[0] == 8) {
    if (exchange) {
      for (std::size_t i = 0; i < codes.size(); ++i) {
        bytes[i] = static_cast<std::uint8_t>(codes[sample_at(i, true)]);
      }
    } else {
      for (std::size_t i = 0; i < codes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(codes[i]);
    }
    return;
  }
  const WordBytes at(layout.byte_order);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    put_word(codes[sample_at(i, exchange)], at, &bytes[i * 2]);
  }
}

void unpack_row(std::span<const std::uint8_t> bytes, const FrameLayout& layout,
                std::span<std::uint16_t> codes) noexcept {
  const Packing& packing = layout.packing;
  if (is_one_word(packing)) return unpack_one_word(bytes, layout, codes);
  if (packing.bits[0] < 8) return unpack_parts(bytes, layout, codes);
  const WordBytes at(layout.byte_order);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const std::size_t place = sample_at(i, packing.blue_first);
    codes[i] = packing.bits[0] == 8 ? bytes[place]
                                    : static_cast<std::uint16_t>(get_word(&bytes[place * 2], at));
  }
}

}  // namespace tristim
