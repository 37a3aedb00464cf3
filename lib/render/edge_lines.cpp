#include "lib/render/edge_lines.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "tristim/light/gooch.h"
#include "tristim/light/vector.h"

namespace tristim::detail {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

bool before(const Vector3d& a, const Vector3d& b) noexcept {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

// For each position the first one at the same place.
std::vector<std::uint32_t> joined_positions(const World& world) {
  const auto& at = world.positions;
  std::vector<std::uint32_t> order(at.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, [&](std::uint32_t i, std::uint32_t j) {
    return before(at[i], at[j]) || (at[i] == at[j] && i < j);
  });
  std::vector<std::uint32_t> joined(at.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && at[order[i]] == at[order[i - 1]];
    joined[order[i]] = same ? joined[order[i - 1]] : order[i];
  }
  return joined;
}

// An edge as one triangle has it, the lesser position first.
struct Side {
  std::uint32_t a, b, face;
  friend auto operator<=>(const Side&, const Side&) = default;
};

std::vector<Side> sides_of(const World& world) {
  const std::vector<std::uint32_t> joined = joined_positions(world);
  std::vector<Side> sides;
  for (std::uint32_t t = 0; t < world.triangles.size(); ++t) {
    const auto& corners = world.triangles[t].position;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(joined[corners[i]], joined[corners[(i + 1) % 3]]);
      sides.push_back({a, b, t});
    }
  }
  std::ranges::sort(sides);
  return sides;
}

// Where the line stands in the picture: both ends in front of the camera and near the picture.
struct Segment {
  DevicePoint a, b;
};

std::optional<Segment> clipped(const SeenWorld& seen, const DevicePoint& a, const DevicePoint& b,
                               double guard) {
  const View& view = seen.view;
  const auto distances = [&](const DevicePoint& p) {
    return std::array{p.distance - view.near, view.far - p.distance,
                      p.x + guard * p.w,      (view.width + guard) * p.w - p.x,
                      p.y + guard * p.w,      (view.height + guard) * p.w - p.y};
  };
  const auto da = distances(a);
  const auto db = distances(b);
  double first = 0;
  double last = 1;
  for (std::size_t i = 0; i < da.size(); ++i) {
    if (da[i] < 0 && db[i] < 0) return std::nullopt;
    if (da[i] < 0) first = std::max(first, da[i] / (da[i] - db[i]));
    if (db[i] < 0) last = std::min(last, da[i] / (da[i] - db[i]));
  }
  if (!(first < last)) return std::nullopt;
  const auto at = [&](double t) {
    return DevicePoint{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.w + t * (b.w - a.w),
                       a.distance + t * (b.distance - a.distance)};
  };
  return Segment{at(first), at(last)};
}

bool is_drawn(const SeenWorld& seen, const WorldEdge& edge, const EdgeLines& lines,
              double crease_cosine) {
  if (edge.other == kNoIndex) return lines.silhouettes;
  const World& world = seen.world;
  const Vector3d n0 = face_normal(world, world.triangles[edge.face]);
  const Vector3d n1 = face_normal(world, world.triangles[edge.other]);
  const Vector3d to_eye =
      seen.view.orthographic ? seen.view.back : Vector3d(seen.view.eye - world.positions[edge.a]);
  return (lines.silhouettes && is_silhouette(to_eye, n0, n1)) ||
         (lines.creases && is_crease(n0, n1, crease_cosine));
}

// How much nearer a stripe lies: as far as the triangle beside it rises across the stripe, but not
// through what stands in front.
double lift(const SeenWorld& seen, const WorldEdge& edge, double nearness, double width) {
  constexpr double kLeast = 1e-4;
  constexpr double kMost = 0.02;
  double rise = 0;
  for (const std::uint32_t face : {edge.face, edge.other}) {
    if (face == kNoIndex) continue;
    DeviceTriangle drawn;
    drawn.triangle = face;
    const SurfacePlanes planes = surface_planes(seen, drawn, false);
    const double slope = std::sqrt(planes.dx[0] * planes.dx[0] + planes.dy[0] * planes.dy[0]);
    if (std::isfinite(slope)) rise = std::max(rise, slope * (width / 2 + 1));
  }
  const double size = std::fabs(nearness);
  return nearness + std::clamp(rise, kLeast * size, kMost * size);
}

class Stripe {
 public:
  Stripe(const SeenWorld& seen, const Segment& segment, double width) : seen_(seen) {
    const Vector2d a(segment.a.x / segment.a.w, segment.a.y / segment.a.w);
    const Vector2d b(segment.b.x / segment.b.w, segment.b.y / segment.b.w);
    const Vector2d way = b - a;
    const double length = std::sqrt(way.x() * way.x() + way.y() * way.y());
    if (length == 0) return;
    // Square ends fill the gaps where lines meet.
    const Vector2d along = way * (width / 2 / length);
    const Vector2d across(-along.y(), along.x());
    corners_ = {fixed(a - along + across), fixed(a - along - across), fixed(b + along - across),
                fixed(b + along + across)};
  }

  void add(double nearness_a, double nearness_b, const DeviceTriangle& like,
           std::vector<DeviceTriangle>& out) const {
    const std::array<double, 4> nearness{nearness_a, nearness_a, nearness_b, nearness_b};
    for (const auto& [i, j, k] : {std::array{0U, 1U, 2U}, std::array{0U, 2U, 3U}}) {
      DeviceTriangle part = like;
      part.at = {corners_[i], corners_[j], corners_[k]};
      part.nearness = {nearness[i], nearness[j], nearness[k]};
      const std::int64_t area = twice_area(part.at[0], part.at[1], part.at[2]);
      if (area == 0) continue;
      if (area < 0) {
        std::swap(part.at[1], part.at[2]);
        std::swap(part.nearness[1], part.nearness[2]);
      }
      out.push_back(part);
    }
  }

 private:
  FixedPoint fixed(const Vector2d& p) const {
    const auto step = [&](double value) {
      return static_cast<std::int32_t>(
          std::floor(value * static_cast<double>(std::int64_t{1} << seen_.grid.bits) + 0.5));
    };
    return {step(p.x()), step(p.y())};
  }

  const SeenWorld& seen_;
  std::array<FixedPoint, 4> corners_{};
};

}  // namespace

std::vector<WorldEdge> edges_of(const World& world) {
  const std::vector<Side> sides = sides_of(world);
  std::vector<WorldEdge> edges;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Side& side = sides[i];
    edges.push_back({side.a, side.b, side.face});
    const bool shared =
        i + 1 < sides.size() && sides[i + 1].a == side.a && sides[i + 1].b == side.b;
    if (shared) edges.back().other = sides[++i].face;
  }
  return edges;
}

void add_edge_lines(const SeenWorld& seen, const std::vector<WorldEdge>& edges,
                    const EdgeLines& lines, std::uint32_t material,
                    std::vector<DeviceTriangle>& out) {
  const double crease_cosine = cosine_deg(lines.crease_deg);
  for (const WorldEdge& edge : edges) {
    if (!is_drawn(seen, edge, lines, crease_cosine)) continue;
    const auto segment = clipped(seen, seen.vertices[edge.a].point, seen.vertices[edge.b].point,
                                 seen.grid.guard - lines.width);
    if (!segment) continue;
    const DeviceTriangle like{.triangle = edge.face, .material = material};
    Stripe(seen, *segment, lines.width)
        .add(lift(seen, edge, nearness_of(seen.view, segment->a), lines.width),
             lift(seen, edge, nearness_of(seen.view, segment->b), lines.width), like, out);
  }
}

}  // namespace tristim::detail
