#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/render/device_triangles.h"

namespace tristim::detail {

/// Which triangles may reach each of a number of strips of equal size; in order.
class StripLists {
 public:
  /// `low` and `high` of each triangle in pixels, `margin` pixels count for a strip on both sides.
  template <class Extent>
  static StripLists of(std::size_t triangles, int strips, int size, int margin, Extent&& extent);

  std::span<const std::uint32_t> operator[](int strip) const noexcept {
    const auto s = static_cast<std::size_t>(strip);
    return {items_.data() + start_[s], start_[s + 1] - start_[s]};
  }

 private:
  std::vector<std::size_t> start_;
  std::vector<std::uint32_t> items_;
};

/// Pixels from `first` to `last`, both included; any of them may lie outside of the picture.
struct PixelExtent {
  int first = 0, last = 0;
};

inline PixelExtent rows_of(const DeviceTriangle& t, int bits) noexcept {
  return {std::min({t.at[0].y, t.at[1].y, t.at[2].y}) >> bits,
          std::max({t.at[0].y, t.at[1].y, t.at[2].y}) >> bits};
}
inline PixelExtent columns_of(const DeviceTriangle& t, int bits) noexcept {
  return {std::min({t.at[0].x, t.at[1].x, t.at[2].x}) >> bits,
          std::max({t.at[0].x, t.at[1].x, t.at[2].x}) >> bits};
}

template <class Extent>
StripLists StripLists::of(std::size_t triangles, int strips, int size, int margin,
                          Extent&& extent) {
  struct Range {
    int first, last;
  };
  const auto range = [&](std::size_t i) {
    const PixelExtent e = extent(i);
    return Range{std::max(e.first - margin, 0) / size,
                 e.last + margin < 0 ? -1 : std::min((e.last + margin) / size, strips - 1)};
  };
  StripLists lists;
  lists.start_.assign(static_cast<std::size_t>(strips) + 2, 0);
  for (std::size_t i = 0; i < triangles; ++i) {
    const Range r = range(i);
    for (int s = r.first; s <= r.last; ++s) ++lists.start_[static_cast<std::size_t>(s) + 2];
  }
  for (std::size_t s = 2; s < lists.start_.size(); ++s) lists.start_[s] += lists.start_[s - 1];
  lists.items_.resize(lists.start_.back());
  // start_[s + 1] is where the next item of strip s goes; at the end, where strip s + 1 starts.
  for (std::size_t i = 0; i < triangles; ++i) {
    const Range r = range(i);
    for (int s = r.first; s <= r.last; ++s) {
      lists.items_[lists.start_[static_cast<std::size_t>(s) + 1]++] = static_cast<std::uint32_t>(i);
    }
  }
  return lists;
}

}  // namespace tristim::detail
