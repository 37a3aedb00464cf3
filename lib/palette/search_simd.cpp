#include <limits>

#include "lib/palette/search.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lib/palette/search_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace tristim::detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Numbers = hn::RebindToUnsigned<Floats>;
using FloatVec = hn::Vec<Floats>;
using NumberVec = hn::Vec<Numbers>;

// Points in lanes, kVectors of them at once, whose steps do not wait for each other.
template <int kAxes, std::size_t kVectors>
HWY_INLINE void nearest_of_vectors(const PlacePlanes& entries, const float* const* points,
                                   std::size_t at, std::uint32_t* index, float* distance2) {
  const Floats tag;
  const Numbers numbers;
  const std::size_t lanes = hn::Lanes(tag);
  FloatVec place[kVectors][kAxes];
  FloatVec least[kVectors];
  NumberVec best[kVectors];
  for (std::size_t v = 0; v < kVectors; ++v) {
    for (int a = 0; a < kAxes; ++a) place[v][a] = hn::LoadU(tag, points[a] + at + v * lanes);
    least[v] = hn::Set(tag, std::numeric_limits<float>::infinity());
    best[v] = hn::Zero(numbers);
  }
  NumberVec number = hn::Zero(numbers);
  const NumberVec one = hn::Set(numbers, 1);
  for (std::size_t k = 0; k < entries.size; ++k) {
    FloatVec entry[kAxes];
    for (int a = 0; a < kAxes; ++a) {
      entry[a] = hn::Set(tag, entries.axis[static_cast<std::size_t>(a)][k]);
    }
    for (std::size_t v = 0; v < kVectors; ++v) {
      FloatVec sum = hn::Zero(tag);
      for (int a = 0; a < kAxes; ++a) {
        const FloatVec d = hn::Sub(entry[a], place[v][a]);
        sum = hn::Add(sum, hn::Mul(d, d));
      }
      const auto nearer = hn::Lt(sum, least[v]);
      least[v] = hn::IfThenElse(nearer, sum, least[v]);
      best[v] = hn::IfThenElse(hn::RebindMask(numbers, nearer), number, best[v]);
    }
    number = hn::Add(number, one);
  }
  for (std::size_t v = 0; v < kVectors; ++v) {
    hn::StoreU(least[v], tag, distance2 + at + v * lanes);
    hn::StoreU(best[v], numbers, index + at + v * lanes);
  }
}

template <int kAxes>
HWY_INLINE void nearest_of_block(const PlacePlanes& entries, const float* const* points,
                                 std::size_t vectors, std::uint32_t* index, float* distance2) {
  const std::size_t lanes = hn::Lanes(Floats());
  std::size_t v = 0;
  for (; v + 3 < vectors; v += 4) {
    nearest_of_vectors<kAxes, 4>(entries, points, v * lanes, index, distance2);
  }
  for (; v < vectors; ++v) {
    nearest_of_vectors<kAxes, 1>(entries, points, v * lanes, index, distance2);
  }
}

template <int kAxes>
void nearest_of_all(const PlacePlanes& entries, const PlacePlanes& points, std::uint32_t* index,
                    float* distance2) {
  const std::size_t lanes = hn::Lanes(Floats());
  const std::size_t whole = points.size / lanes * lanes;
  const float* from[kAxes];
  for (int a = 0; a < kAxes; ++a) from[a] = points.axis[static_cast<std::size_t>(a)];
  nearest_of_block<kAxes>(entries, from, whole / lanes, index, distance2);
  if (whole == points.size) return;
  // The rest in a vector of its own, filled up with zeros.
  constexpr std::size_t kMost = HWY_MAX_BYTES / sizeof(float);
  float rest[kAxes][kMost] = {};
  std::uint32_t rest_index[kMost] = {};
  float rest_distance2[kMost] = {};
  const std::size_t count = points.size - whole;
  for (int a = 0; a < kAxes; ++a) {
    for (std::size_t i = 0; i < count; ++i) rest[a][i] = from[a][whole + i];
    from[a] = rest[a];
  }
  nearest_of_block<kAxes>(entries, from, 1, rest_index, rest_distance2);
  for (std::size_t i = 0; i < count; ++i) {
    index[whole + i] = rest_index[i];
    distance2[whole + i] = rest_distance2[i];
  }
}

void nearest(const PlacePlanes& entries, const PlacePlanes& points, int axes, std::uint32_t* index,
             float* distance2) {
  if (axes == 3) return nearest_of_all<3>(entries, points, index, distance2);
  nearest_of_all<4>(entries, points, index, distance2);
}

PlaceSearch search() { return {nearest}; }

}  // namespace tristim::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tristim::detail {

HWY_EXPORT(search);

PlaceSearch place_search() { return HWY_DYNAMIC_DISPATCH(search)(); }

}  // namespace tristim::detail
#endif
