#include "lib/palette/search.h"

#include <limits>

namespace tristim::detail {
namespace {

void nearest(const PlacePlanes& entries, const PlacePlanes& points, int axes, std::uint32_t* index,
             float* distance2) {
  for (std::size_t i = 0; i < points.size; ++i) {
    std::uint32_t best = 0;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t k = 0; k < entries.size; ++k) {
      float sum = 0;
      for (std::size_t a = 0; a < static_cast<std::size_t>(axes); ++a) {
        const float d = entries.axis[a][k] - points.axis[a][i];
        sum += d * d;
      }
      if (sum < least) {
        least = sum;
        best = static_cast<std::uint32_t>(k);
      }
    }
    index[i] = best;
    distance2[i] = least;
  }
}

}  // namespace

PlacePlanes planes_of(const Places& places, std::size_t first, std::size_t end) noexcept {
  PlacePlanes planes{{}, end - first};
  for (std::size_t a = 0; a < 4; ++a) planes.axis[a] = places.axis[a].data() + first;
  return planes;
}

PlacePlanes planes_of(const Places& places) noexcept { return planes_of(places, 0, places.size()); }

PlaceSearch scalar_place_search() noexcept { return {nearest}; }

}  // namespace tristim::detail
