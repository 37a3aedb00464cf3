// The planes of tile_draw.cpp in vectors, for each instruction set; the best one is chosen at run
// time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lib/render/tile_draw_simd.cpp"
// clang-format off: foreach_target.h comes before highway.h
#include <hwy/foreach_target.h>
// clang-format on
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "lib/render/tile_draw.h"

HWY_BEFORE_NAMESPACE();
namespace tristim::detail {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using FloatTag = hn::CappedTag<float, kBlock>;
using IntTag = hn::RebindToSigned<FloatTag>;
using IdTag = hn::RebindToUnsigned<FloatTag>;
using Float = hn::Vec<FloatTag>;
using Int = hn::Vec<IntTag>;
using Mask = hn::Mask<FloatTag>;

// Where a triangle's pixels go.
struct Target {
  VisibilityPlane& plane;
  std::uint32_t id;
  NearnessPlane nearness;
  double shift_x, shift_y;  // of the sample, in pixels
};

// A triangle's depth along one block of a row.
struct BlockDepth {
  Float start, step, least, most;
};

HWY_INLINE BlockDepth block_depth(const Target& to, int x, int y) {
  const FloatTag d;
  const double start = to.nearness.at(x + to.shift_x, y + to.shift_y);
  return {hn::Set(d, static_cast<float>(start)), hn::Set(d, static_cast<float>(to.nearness.dx)),
          hn::Set(d, to.nearness.least), hn::Set(d, to.nearness.most)};
}

// Keeps what is nearer among the pixels of `inside`, from lane `first` of the block on.
HWY_INLINE void keep_nearer(const Target& to, const BlockDepth& depth, Mask inside, int first,
                            std::size_t at) {
  const FloatTag d;
  const IdTag ids;
  const Float lane = hn::Iota(d, static_cast<float>(first));
  const Float near = hn::Min(hn::Max(depth.start + depth.step * lane, depth.least), depth.most);
  float* nearness = to.plane.nearness.data() + at;
  const Float before = hn::LoadU(d, nearness);
  const Mask nearer = hn::And(inside, near > before);
  hn::StoreU(hn::IfThenElse(nearer, near, before), d, nearness);
  std::uint32_t* id = to.plane.id.data() + at;
  hn::StoreU(hn::IfThenElse(hn::RebindMask(ids, nearer), hn::Set(ids, to.id), hn::LoadU(ids, id)),
             ids, id);
}

HWY_INLINE std::size_t place(const TileRect& rect, int x, int y) {
  return static_cast<std::size_t>((y - rect.y0) * rect.width + (x - rect.x0));
}

constexpr int block_start(int x, int x0) { return x - (x - x0) % kBlock; }

// Edge functions of triangles up to kSmall pixels wide and high fit into 32 bits.
constexpr int kSmall = 48;

struct SmallEdge {
  Int along;  // of the lanes of a block
  std::int32_t dx, dy, start;
};

HWY_INLINE SmallEdge small_edge(const PixelEdge& edge) {
  const IntTag d;
  const auto dx = static_cast<std::int32_t>(edge.dx);
  return {hn::Iota(d, 0) * hn::Set(d, dx), dx, static_cast<std::int32_t>(edge.dy),
          static_cast<std::int32_t>(edge.start)};
}

HWY_INLINE Int edge_at(const SmallEdge& edge, int across, int down) {
  return edge.along + hn::Set(IntTag(), edge.start + edge.dx * across + edge.dy * down);
}

HWY_INLINE void draw_small(const Target& to, const std::array<PixelEdge, 3>& edges, int x0, int y0,
                           const PixelRange& columns, const PixelRange& rows) {
  const int step = static_cast<int>(hn::Lanes(FloatTag()));
  const SmallEdge a = small_edge(edges[0]);
  const SmallEdge b = small_edge(edges[1]);
  const SmallEdge c = small_edge(edges[2]);
  for (int y = rows.first; y < rows.last; ++y) {
    for (int block = x0; block < columns.last; block += kBlock) {
      for (int lane = 0; lane < kBlock; lane += step) {
        const int across = block + lane - x0;
        const Int outside = hn::Or(hn::Or(edge_at(a, across, y - y0), edge_at(b, across, y - y0)),
                                   edge_at(c, across, y - y0));
        const auto inside = hn::RebindMask(FloatTag(), outside > hn::Set(IntTag(), -1));
        if (hn::AllFalse(FloatTag(), inside)) continue;
        keep_nearer(to, block_depth(to, block, y), inside, lane,
                    place(to.plane.rect, block + lane, y));
      }
    }
  }
}

// Narrows columns to those where start + dx * (column - from) is not below 0.
void narrow_columns(PixelRange& columns, std::int64_t dx, std::int64_t start, int from) {
  if (dx == 0) {
    if (start < 0) columns.last = columns.first;
    return;
  }
  const std::int64_t width = columns.last - from;
  if (dx > 0) {
    const std::int64_t first = start >= 0 ? 0 : std::min((dx - 1 - start) / dx, width);
    columns.first = std::max(columns.first, from + static_cast<int>(first));
  } else {
    const std::int64_t last = start < 0 ? 0 : std::min(start / -dx + 1, width);
    columns.last = std::min(columns.last, from + static_cast<int>(last));
  }
}

void draw_span(const Target& to, const PixelRange& columns, int y) {
  const IntTag d;
  const int step = static_cast<int>(hn::Lanes(d));
  const TileRect& rect = to.plane.rect;
  for (int block = block_start(columns.first, rect.x0); block < columns.last; block += kBlock) {
    const BlockDepth depth = block_depth(to, block, y);
    for (int lane = 0; lane < kBlock; lane += step) {
      const Int x = hn::Iota(d, block + lane);
      const auto inside = hn::And(x > hn::Set(d, columns.first - 1), x < hn::Set(d, columns.last));
      keep_nearer(to, depth, hn::RebindMask(FloatTag(), inside), lane,
                  place(rect, block + lane, y));
    }
  }
}

void draw_large(const Target& to, const std::array<PixelEdge, 3>& edges, int x0, int y0,
                const PixelRange& columns, const PixelRange& rows) {
  for (int y = rows.first; y < rows.last; ++y) {
    PixelRange covered = columns;
    for (const PixelEdge& edge : edges) {
      narrow_columns(covered, edge.dx, edge.start + edge.dy * (y - y0), x0);
    }
    if (covered.first < covered.last) draw_span(to, covered, y);
  }
}

HWY_INLINE void draw_one(const DeviceTriangle& triangle, int bits, const SampleOffset& offset,
                         std::uint32_t id, VisibilityPlane& plane) {
  const auto& [a, b, c] = triangle.at;
  const TileRect& rect = plane.rect;
  const std::int32_t left = std::min({a.x, b.x, c.x});
  const std::int32_t right = std::max({a.x, b.x, c.x});
  const PixelRange columns = pixels_between(left, right, offset.x, bits, rect.x0, rect.width);
  if (columns.first >= columns.last) return;
  const std::int32_t top = std::min({a.y, b.y, c.y});
  const std::int32_t bottom = std::max({a.y, b.y, c.y});
  const PixelRange rows = pixels_between(top, bottom, offset.y, bits, rect.y0, rect.height);
  if (rows.first >= rows.last) return;
  const int x0 = block_start(columns.first, rect.x0);
  const int y0 = rows.first;
  const std::array<PixelEdge, 3> edges{pixel_edge(triangle, 0, bits, offset, x0, y0),
                                       pixel_edge(triangle, 1, bits, offset, x0, y0),
                                       pixel_edge(triangle, 2, bits, offset, x0, y0)};
  const double pixel = 1.0 / static_cast<double>(std::int64_t{1} << bits);
  const Target to{plane, id, nearness_plane(triangle, bits), offset.x * pixel, offset.y * pixel};
  const std::int64_t most = std::int64_t{kSmall} << bits;
  const bool small = std::int64_t{right} - left <= most && std::int64_t{bottom} - top <= most;
  if (small) {
    draw_small(to, edges, x0, y0, columns, rows);
  } else {
    draw_large(to, edges, x0, y0, columns, rows);
  }
}

void draw_list(const DeviceTriangle* triangles, const std::uint32_t* list, std::size_t size,
               int bits, const SampleOffset& offset, VisibilityPlane& plane) {
  for (std::size_t i = 0; i < size; ++i) {
    draw_one(triangles[list[i]], bits, offset, static_cast<std::uint32_t>(i), plane);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace tristim::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tristim::detail {

HWY_EXPORT(draw_list);

void draw_triangles(std::span<const DeviceTriangle> triangles, std::span<const std::uint32_t> list,
                    int bits, const SampleOffset& offset, VisibilityPlane& plane) {
  HWY_DYNAMIC_DISPATCH(draw_list)
  (triangles.data(), list.data(), list.size(), bits, offset, plane);
}

}  // namespace tristim::detail
#endif
