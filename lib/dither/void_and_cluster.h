#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lib/dither/crowding.h"

namespace tristim::detail {

/// The cells of a torus in the order in which void-and-cluster lights them [Ulichney93]: every
/// beginning of the order is spread as evenly as it can be, in each slice and along time.
///
/// Whole numbers only: the same order on every processor.
std::vector<std::size_t> void_and_cluster(const Torus& torus, std::uint64_t seed);

}  // namespace tristim::detail
