#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace tristim::detail {

/// PNG's filter 4 of a row [PNG3 9.4]: each byte less what the bytes on its left, above and above
/// on the left make expected. `above` and `out` are as long as the row, `pixel_bytes` is the
/// distance to the left.
void filter_paeth(std::span<const std::uint8_t> row, std::span<const std::uint8_t> above,
                  std::size_t pixel_bytes, std::uint8_t* out) noexcept;

/// Its definition, byte by byte.
void filter_paeth_scalar(std::span<const std::uint8_t> row, std::span<const std::uint8_t> above,
                         std::size_t pixel_bytes, std::uint8_t* out) noexcept;

}  // namespace tristim::detail
