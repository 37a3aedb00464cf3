#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/render/device_triangles.h"

namespace tristim::detail {

/// Depth is computed from the start of each block of so many pixels of a row, counted from the
/// picture's left side, so that it does not depend on the tile.
inline constexpr int kBlock = 16;

/// Where in its pixel a sample lies, in steps of the grid.
using SampleOffset = FixedPoint;

/// Pixels of the picture, or around it: x0 and the width are whole blocks.
struct TileRect {
  int x0 = 0, y0 = 0, width = 0, height = 0;
};

/// No triangle is seen.
inline constexpr std::uint32_t kNothing = 0xFFFFFFFF;

/// One sample of each pixel of a tile: how near the nearest surface is, and which it is.
struct VisibilityPlane {
  TileRect rect;
  std::vector<float> nearness;
  std::vector<std::uint32_t> id;  // a position in the list of triangles drawn; and one more

  void clear(const TileRect& to);
};

/// The pixels first..last - 1 of a row or column.
struct PixelRange {
  int first = 0, last = 0;
};

/// Those of `first`..`first` + `count` - 1 whose sample at `offset` lies within low..high, both
/// included.
inline PixelRange pixels_between(std::int32_t low, std::int32_t high, std::int32_t offset, int bits,
                                 int first, int count) noexcept {
  const std::int64_t whole = (std::int64_t{1} << bits) - 1;
  const std::int64_t from = (std::int64_t{low} - offset + whole) >> bits;
  const std::int64_t to = ((std::int64_t{high} - offset) >> bits) + 1;
  return {static_cast<int>(std::clamp<std::int64_t>(from, first, first + count)),
          static_cast<int>(std::clamp<std::int64_t>(to, first, first + count))};
}

/// An edge function on the samples of pixels: dx times the pixel's column and dy times its row,
/// from the value at one pixel; not below 0 for samples inside. It is the exact one, divided by the
/// grid's step and rounded down.
struct PixelEdge {
  std::int64_t dx = 0, dy = 0;
  std::int64_t start = 0;
};

/// The edge from corner `i` of a triangle to the next one, starting at pixel (x, y). A sample on
/// the edge counts as inside of left edges and of horizontal edges above the triangle.
inline PixelEdge pixel_edge(const DeviceTriangle& triangle, std::size_t i, int bits,
                            const SampleOffset& offset, int x, int y) noexcept {
  const FixedPoint& p = triangle.at[i];
  const FixedPoint& q = triangle.at[i == 2 ? 0 : i + 1];
  PixelEdge edge;
  edge.dx = std::int64_t{q.y} - p.y;
  edge.dy = std::int64_t{p.x} - q.x;
  const bool top_left = edge.dx > 0 || (edge.dx == 0 && edge.dy > 0);
  const std::int64_t across = (std::int64_t{x} << bits) + offset.x - p.x;
  const std::int64_t down = (std::int64_t{y} << bits) + offset.y - p.y;
  edge.start = (edge.dx * across + edge.dy * down - (top_left ? 0 : 1)) >> bits;
  return edge;
}

/// Nearness as a plane over the picture; what rounding carries out of the triangle's own range is
/// brought back.
struct NearnessPlane {
  double at0 = 0, x0 = 0, y0 = 0;  // at a corner, in pixels
  double dx = 0, dy = 0;           // by a pixel
  float least = 0, most = 0;

  double at(double x, double y) const noexcept { return at0 + (dx * (x - x0) + dy * (y - y0)); }
};

inline NearnessPlane nearness_plane(const DeviceTriangle& triangle, int bits) noexcept {
  const double pixel = 1.0 / static_cast<double>(std::int64_t{1} << bits);
  const auto [a, b, c] = triangle.at;
  const auto [qa, qb, qc] = triangle.nearness;
  const auto apart = [&](std::int32_t p, std::int32_t q) {
    return static_cast<double>(std::int64_t{p} - q) * pixel;
  };
  const double bx = apart(b.x, a.x);
  const double by = apart(b.y, a.y);
  const double cx = apart(c.x, a.x);
  const double cy = apart(c.y, a.y);
  const double inverse = 1 / (bx * cy - cx * by);
  NearnessPlane plane;
  plane.at0 = qa;
  plane.x0 = static_cast<double>(a.x) * pixel;
  plane.y0 = static_cast<double>(a.y) * pixel;
  plane.dx = ((qb - qa) * cy - (qc - qa) * by) * inverse;
  plane.dy = ((qc - qa) * bx - (qb - qa) * cx) * inverse;
  plane.least = static_cast<float>(std::min({qa, qb, qc}));
  plane.most = static_cast<float>(std::max({qa, qb, qc}));
  return plane;
}

/// Draws triangles into a plane that holds a sample of each pixel: those of `list`, which are
/// numbers of `triangles`, one after the other; `id` becomes the place in the list. Of equally near
/// surfaces the first stays. The definition, one pixel after the other.
void draw_triangles_scalar(std::span<const DeviceTriangle> triangles,
                           std::span<const std::uint32_t> list, int bits,
                           const SampleOffset& offset, VisibilityPlane& plane);

/// The same in vectors, same bits. tile_draw_simd.cpp
void draw_triangles(std::span<const DeviceTriangle> triangles, std::span<const std::uint32_t> list,
                    int bits, const SampleOffset& offset, VisibilityPlane& plane);

}  // namespace tristim::detail
