#include "lib/render/device_triangles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace tristim::detail {
namespace {

// Signed distances to the planes of the clipped volume, above 0 inside.
constexpr int kPlanes = 6;

std::array<double, kPlanes> distances(const View& view, double guard,
                                      const DevicePoint& p) noexcept {
  return {p.distance - view.near, view.far - p.distance,
          p.x + guard * p.w,      (view.width + guard) * p.w - p.x,
          p.y + guard * p.w,      (view.height + guard) * p.w - p.y};
}

// To the nearest step, halves up. Places are within the guard band.
std::int32_t fixed(double value, int bits) noexcept {
  constexpr double kShift = 0x1p36;  // conversion to an integer cuts off, which rounds down above 0
  const double scaled = value * static_cast<double>(std::int64_t{1} << bits);
  return static_cast<std::int32_t>(static_cast<std::int64_t>(scaled + (kShift + 0.5)) -
                                   static_cast<std::int64_t>(kShift));
}

FixedPoint fixed(const FixedGrid& grid, const DevicePoint& p) noexcept {
  return {fixed(p.x / p.w, grid.bits), fixed(p.y / p.w, grid.bits)};
}

// What the pieces of a triangle have of it.
struct Source {
  std::uint32_t triangle;
  std::uint32_t material;
  bool two_sided;
};

struct Corner {
  DevicePoint point;
  FixedPoint at;
};

// Whether no pixel's centre lies between two coordinates.
bool between_centres(std::int32_t low, std::int32_t high, int bits) noexcept {
  const std::int64_t half = std::int64_t{1} << (bits - 1);
  return (high - half) >> bits < (low + half - 1) >> bits;
}

bool misses_centres(const FixedGrid& grid, const Corner& a, const Corner& b, const Corner& c) {
  const auto [left, right] = std::minmax({a.at.x, b.at.x, c.at.x});
  const auto [top, bottom] = std::minmax({a.at.y, b.at.y, c.at.y});
  return between_centres(left, right, grid.bits) || between_centres(top, bottom, grid.bits);
}

void add_triangle(const View& view, const FixedGrid& grid, const Corner& a, const Corner& b,
                  const Corner& c, const Source& source, std::vector<DeviceTriangle>& out) {
  const std::int64_t area = twice_area(a.at, b.at, c.at);
  if (area == 0 || (area < 0 && !source.two_sided)) return;
  if (grid.centres_only && misses_centres(grid, a, b, c)) return;
  DeviceTriangle drawn;
  drawn.triangle = source.triangle;
  drawn.material = source.material;
  drawn.back = area < 0;
  // Inside of the edges is on their left with y upwards, on their right with y downwards.
  drawn.at = {a.at, b.at, c.at};
  drawn.nearness = {nearness_of(view, a.point), nearness_of(view, b.point),
                    nearness_of(view, c.point)};
  if (drawn.back) {
    std::swap(drawn.at[1], drawn.at[2]);
    std::swap(drawn.nearness[1], drawn.nearness[2]);
  }
  out.push_back(drawn);
}

// At most one corner more for each plane.
struct Polygon {
  std::array<DevicePoint, 3 + kPlanes> at{};
  std::size_t size = 0;
  void add(const DevicePoint& p) noexcept { at[size++] = p; }
};

DevicePoint between(const DevicePoint& inside, const DevicePoint& outside, double t) noexcept {
  return {inside.x + t * (outside.x - inside.x), inside.y + t * (outside.y - inside.y),
          inside.w + t * (outside.w - inside.w),
          inside.distance + t * (outside.distance - inside.distance)};
}

// [Sutherland74]. The point on an edge is counted from its inner end, so that both triangles that
// share the edge find the same one.
Polygon clipped(const View& view, double guard, const Polygon& polygon, std::size_t plane) {
  Polygon left;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const DevicePoint& a = polygon.at[i];
    const DevicePoint& b = polygon.at[(i + 1) % polygon.size];
    const double da = distances(view, guard, a)[plane];
    const double db = distances(view, guard, b)[plane];
    if (da >= 0) left.add(a);
    if (da >= 0 && db < 0) left.add(between(a, b, da / (da - db)));
    if (da < 0 && db >= 0) left.add(between(b, a, db / (db - da)));
  }
  return left;
}

void add_clipped(const View& view, const FixedGrid& grid, Polygon polygon, std::uint32_t planes,
                 const Source& source, std::vector<DeviceTriangle>& out) {
  for (std::size_t plane = 0; plane < kPlanes; ++plane) {
    if ((planes >> plane & 1) != 0) polygon = clipped(view, grid.guard, polygon, plane);
  }
  const auto corner = [&](std::size_t i) {
    return Corner{polygon.at[i], fixed(grid, polygon.at[i])};
  };
  for (std::size_t i = 2; i < polygon.size; ++i) {
    add_triangle(view, grid, corner(0), corner(i - 1), corner(i), source, out);
  }
}

}  // namespace

FixedGrid fixed_grid(int width, int height, int samples) noexcept {
  // The guard band makes the range of places 2^31 steps: their differences multiply to 2^62.
  const int side = std::max(width, height);
  const int bits = side <= 16384 ? 16 : 14;
  const double range = static_cast<double>(std::int64_t{1} << (31 - bits));
  return {bits, std::floor((range - side) / 2) - 2, samples == 1};
}

DeviceVertex device_vertex(const View& view, const FixedGrid& grid,
                           const Eigen::Vector3d& world) noexcept {
  DeviceVertex vertex{.point = to_device(view, world), .at = {}};
  const auto away = distances(view, grid.guard, vertex.point);
  for (std::size_t plane = 0; plane < kPlanes; ++plane) {
    if (!(away[plane] >= 0)) vertex.outside |= 1U << plane;
  }
  if (vertex.outside == 0) vertex.at = fixed(grid, vertex.point);
  return vertex;
}

void add_device_triangles(const View& view, const FixedGrid& grid, const World& world,
                          std::span<const DeviceVertex> vertices,
                          std::span<const SceneMaterial> materials, std::uint32_t first,
                          std::uint32_t last, std::vector<DeviceTriangle>& out) {
  for (std::uint32_t i = first; i < last; ++i) {
    const WorldTriangle& triangle = world.triangles[i];
    const DeviceVertex& a = vertices[triangle.position[0]];
    const DeviceVertex& b = vertices[triangle.position[1]];
    const DeviceVertex& c = vertices[triangle.position[2]];
    if ((a.outside & b.outside & c.outside) != 0) continue;
    const std::uint32_t planes = a.outside | b.outside | c.outside;
    const Source source{i, triangle.material, materials[triangle.material].two_sided};
    if (planes == 0) {
      add_triangle(view, grid, {a.point, a.at}, {b.point, b.at}, {c.point, c.at}, source, out);
    } else {
      Polygon polygon;
      for (const DeviceVertex* vertex : {&a, &b, &c}) polygon.add(vertex->point);
      add_clipped(view, grid, polygon, planes, source, out);
    }
  }
}

}  // namespace tristim::detail
