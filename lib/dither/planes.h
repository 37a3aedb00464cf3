#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace tristim::detail {

/// Interleaved pixels of three channels to a row for each.
void split_row(std::span<const float> rgb, const std::array<float*, 3>& planes) noexcept;

/// The way back.
void join_row(const std::array<const std::uint16_t*, 3>& planes,
              std::span<std::uint16_t> rgb) noexcept;

}  // namespace tristim::detail
