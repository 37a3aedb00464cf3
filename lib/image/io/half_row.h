#pragma once

#include <cstdint>
#include <span>

namespace tristim::detail {

/// IEEE 754 half to float: exact; NaN becomes quiet and keeps its payload.
float float_from_half(std::uint16_t half) noexcept;

/// IEEE 754 float to half: the nearest, ties to even; beyond the range an infinity; NaN becomes
/// quiet.
std::uint16_t half_from_float(float value) noexcept;

/// The same for a row, in the processor's own instructions where it has them; bit for bit as above.
/// The spans are of one size.
void float_from_half(std::span<const std::uint16_t> halves, std::span<float> values) noexcept;
void half_from_float(std::span<const float> values, std::span<std::uint16_t> halves) noexcept;

}  // namespace tristim::detail
