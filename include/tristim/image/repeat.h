#pragma once

#include <memory>

#include "tristim/image/picture.h"

namespace tristim {

/// `source` with a block of `across` x `down` equal pixels for each of its pixels; `source` itself
/// where both are 1. Memory is one row of it.
///
/// Throws std::invalid_argument where a factor is below 1, or the result is wider or higher than
/// 2^31 - 1.
std::unique_ptr<RowSource> repeat_pixels(std::unique_ptr<RowSource> source, int across, int down);

}  // namespace tristim
