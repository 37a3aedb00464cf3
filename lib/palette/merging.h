#pragma once

#include "lib/palette/places.h"

namespace tristim::detail {

/// Merges the two of `means` whose merging adds the least squares, over and over, until `wanted`
/// are left [Equitz89]; those of no weight go first. Of equal pairs the first. Time grows with the
/// square of their number.
Places merge_means(const Places& means, std::size_t wanted);

}  // namespace tristim::detail
