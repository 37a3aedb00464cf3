#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/palette/places.h"

namespace tristim::detail {

/// How sets of colours are cut in two until there are enough of them.
enum class CutRule {
  kWidestAxis,     ///< the set with the largest variance, along the axis where that is largest
  kPrincipalAxis,  ///< the set with the largest variance along a line, along that line
  kBestAxis,       ///< the set and axis whose cut lessens the sum of squares most
};

/// The set of each of `places`, fewer than `sets` where they coincide. Every cut is where it
/// lessens the sum of squares most; of equally good ones the first.
std::vector<std::uint32_t> cut_places(const Places& places, int sets, CutRule rule);

/// The weighted mean of the colours of each set, in codes, rounded; equal ones once. Alpha weighs
/// the colours.
std::vector<Color8> set_means(std::span<const Histogram::Entry> entries,
                              std::span<const std::uint32_t> set);

}  // namespace tristim::detail
