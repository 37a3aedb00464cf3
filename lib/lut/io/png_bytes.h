#pragma once

#include <string>

namespace tristim::detail {

/// A PNG of RGB samples as they are, 8 or 16 bits (high byte first), without colour chunks.
std::string png_bytes(int width, int height, int bits, const std::string& samples);

}  // namespace tristim::detail
