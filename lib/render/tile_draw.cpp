#include "lib/render/tile_draw.h"

#include <limits>

namespace tristim::detail {
namespace {

constexpr float kFarthest = -std::numeric_limits<float>::infinity();

bool inside(const std::array<PixelEdge, 3>& edges, std::int64_t across, std::int64_t down) {
  return std::ranges::all_of(edges, [&](const PixelEdge& edge) {
    return edge.start + edge.dx * across + edge.dy * down >= 0;
  });
}

void draw(const DeviceTriangle& triangle, std::uint32_t id, int bits, const SampleOffset& offset,
          VisibilityPlane& plane) {
  const TileRect& rect = plane.rect;
  const std::array<PixelEdge, 3> edges{pixel_edge(triangle, 0, bits, offset, rect.x0, rect.y0),
                                       pixel_edge(triangle, 1, bits, offset, rect.x0, rect.y0),
                                       pixel_edge(triangle, 2, bits, offset, rect.x0, rect.y0)};
  const NearnessPlane nearness = nearness_plane(triangle, bits);
  const double pixel = 1.0 / static_cast<double>(std::int64_t{1} << bits);
  for (int y = 0; y < rect.height; ++y) {
    for (int x = 0; x < rect.width; ++x) {
      if (!inside(edges, x, y)) continue;
      const int block = x - x % kBlock;
      const auto start = static_cast<float>(
          nearness.at(rect.x0 + block + offset.x * pixel, rect.y0 + y + offset.y * pixel));
      const float unbounded =
          start + static_cast<float>(nearness.dx) * static_cast<float>(x - block);
      const float near = std::min(std::max(unbounded, nearness.least), nearness.most);
      const auto i = static_cast<std::size_t>(y * rect.width + x);
      if (!(near > plane.nearness[i])) continue;
      plane.nearness[i] = near;
      plane.id[i] = id;
    }
  }
}

}  // namespace

void VisibilityPlane::clear(const TileRect& to) {
  rect = to;
  const auto size = static_cast<std::size_t>(to.width) * static_cast<std::size_t>(to.height);
  nearness.assign(size, kFarthest);
  id.assign(size + 1, kNothing);
}

void draw_triangles_scalar(std::span<const DeviceTriangle> triangles,
                           std::span<const std::uint32_t> list, int bits,
                           const SampleOffset& offset, VisibilityPlane& plane) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    draw(triangles[list[i]], static_cast<std::uint32_t>(i), bits, offset, plane);
  }
}

}  // namespace tristim::detail
