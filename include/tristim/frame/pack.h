#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "tristim/frame/layout.h"

namespace tristim {

/// Bytes of a row of `width` pixels: rows start in a new byte.
std::size_t packed_row_bytes(const Packing& packing, int width) noexcept;

/// One row of codes (`packing.samples` of a pixel, interleaved) to the bytes of the frame buffer.
/// `bytes` has packed_row_bytes; bits behind the last pixel are 0. Bits of a code above its depth
/// are dropped.
void pack_row(std::span<const std::uint16_t> codes, const FrameLayout& layout,
              std::span<std::uint8_t> bytes) noexcept;

/// The inverse of pack_row.
void unpack_row(std::span<const std::uint8_t> bytes, const FrameLayout& layout,
                std::span<std::uint16_t> codes) noexcept;

}  // namespace tristim
