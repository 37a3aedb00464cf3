#pragma once

#include <cstdint>
#include <span>

namespace tristim::detail {

/// The lengths in bits of a prefix code for symbols with these counts, none longer than `most`; 0
/// for a symbol that does not occur. One symbol alone gets 1 bit. At most 65535 symbols and no more
/// than 2^most that occur; `length` is as long as `count`.
///
/// Huffman's lengths [Huffman52]; leaves deeper than `most` are lifted, and others go down to make
/// room.
void code_lengths(std::span<const std::uint32_t> count, int most, std::span<std::uint8_t> length);

/// The canonical code of these lengths, as deflate orders it, its first bit lowest [RFC1951 3.2.2].
void canonical_code(std::span<const std::uint8_t> length, std::span<std::uint16_t> code);

}  // namespace tristim::detail
