#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tristim::detail {

/// Bytes as deflate blocks [RFC1951] of literals and of long runs of one byte, no other matches:
/// what zlib calls Z_RLE, many times as fast, and smaller. Good for what a filter leaves of
/// pictures with noise.
///
/// The result ends at a byte: with the stream where `last` is set, else with an empty stored block,
/// so that blocks of anybody's may follow.
std::vector<std::uint8_t> run_length_deflated(std::span<const std::uint8_t> bytes, bool last);

}  // namespace tristim::detail
