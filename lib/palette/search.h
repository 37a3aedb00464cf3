#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "lib/palette/places.h"

namespace tristim::detail {

/// Planes of places: x, y, z and, where there are `axes` = 4, alpha; see Places.
struct PlacePlanes {
  std::array<const float*, 4> axis{};
  std::size_t size = 0;
};

/// The places in [first, end).
PlacePlanes planes_of(const Places& places, std::size_t first, std::size_t end) noexcept;
PlacePlanes planes_of(const Places& places) noexcept;

/// For each of `points` the nearest of `entries`, of equally near ones the first, and the square of
/// its distance: sums of squares in float, x first. At least one entry; NaN finds entry 0 at +inf.
struct PlaceSearch {
  void (*nearest)(const PlacePlanes& entries, const PlacePlanes& points, int axes,
                  std::uint32_t* index, float* distance2) = nullptr;
};

/// The definition.
PlaceSearch scalar_place_search() noexcept;

/// For the processor at hand, the same bits.
PlaceSearch place_search();

}  // namespace tristim::detail
