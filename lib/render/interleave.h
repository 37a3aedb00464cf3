#pragma once

#include <cstddef>
#include <span>

namespace tristim::detail {

/// Writes `count` pixels of as many samples as there are planes: sample c of pixel i is
/// planes[c][i].
void interleave(std::span<const float* const> planes, std::size_t count, float* pixels);

}  // namespace tristim::detail
