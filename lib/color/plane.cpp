#include "tristim/color/plane.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tristim {
namespace {

// Twice the area of the triangle a b p: above 0 where p is to the left of the way from a to b.
// Exactly 0 where p is a or b.
double left_of(PlanePoint a, PlanePoint b, PlanePoint p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

// Twice the area, above 0 where the corners turn left. From the first corner: small triangles far
// from the origin keep their digits.
double signed_area2(std::span<const PlanePoint> polygon) {
  double sum = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    sum += left_of(polygon[0], polygon[i - 1], polygon[i]);
  }
  return sum;
}

// Calls edge(a, b) for every edge, with the inside to its left.
template <typename Edge>
void for_each_edge(std::span<const PlanePoint> polygon, Edge&& edge) {
  const bool left = signed_area2(polygon) >= 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PlanePoint a = polygon[i];
    const PlanePoint b = polygon[(i + 1) % polygon.size()];
    left ? edge(a, b) : edge(b, a);
  }
}

// The part of a polygon to the left of the way from a to b.
Polygon left_part(const Polygon& polygon, PlanePoint a, PlanePoint b) {
  Polygon part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PlanePoint p = polygon[i];
    const PlanePoint q = polygon[(i + 1) % polygon.size()];
    const double at_p = left_of(a, b, p);
    const double at_q = left_of(a, b, q);
    if (at_p >= 0) part.push_back(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) {
      const double t = at_p / (at_p - at_q);
      part.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  return part;
}

double distance_to_segment(PlanePoint a, PlanePoint b, PlanePoint p) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length2 = dx * dx + dy * dy;
  const double along = length2 > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / length2 : 0;
  const double t = std::clamp(along, 0.0, 1.0);
  const double x = p.x - (a.x + t * dx);
  const double y = p.y - (a.y + t * dy);
  return std::sqrt(x * x + y * y);
}

}  // namespace

PlanePoint uv76_from_xy(Chromaticity c) noexcept {
  const double d = -2 * c.x + 12 * c.y + 3;
  return {4 * c.x / d, 9 * c.y / d};
}

Chromaticity xy_from_uv76(PlanePoint p) noexcept {
  const double d = 6 * p.x - 16 * p.y + 12;
  return {9 * p.x / d, 4 * p.y / d};
}

double polygon_area(std::span<const PlanePoint> polygon) noexcept {
  return std::fabs(signed_area2(polygon)) / 2;
}

bool convex_contains(std::span<const PlanePoint> polygon, PlanePoint point) noexcept {
  bool inside = !polygon.empty();
  for_each_edge(polygon, [&](PlanePoint a, PlanePoint b) {
    inside = inside && left_of(a, b, point) >= 0;  // NaN is not inside
  });
  return inside;
}

Polygon convex_intersection(std::span<const PlanePoint> subject,
                            std::span<const PlanePoint> window) {
  Polygon common(subject.begin(), subject.end());
  for_each_edge(window, [&](PlanePoint a, PlanePoint b) { common = left_part(common, a, b); });
  return common;
}

Polygon convex_hull(std::vector<PlanePoint> points) {
  std::sort(points.begin(), points.end(),
            [](PlanePoint a, PlanePoint b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Polygon hull;
  const auto add_chain = [&hull](auto from, auto to) {
    const std::size_t start = hull.size();
    for (auto p = from; p != to; ++p) {
      while (hull.size() >= start + 2 && left_of(hull.end()[-2], hull.back(), *p) <= 0) {
        hull.pop_back();
      }
      hull.push_back(*p);
    }
    hull.pop_back();  // the other chain begins with it
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

double distance_outside(std::span<const PlanePoint> polygon, PlanePoint point) noexcept {
  if (convex_contains(polygon, point)) return 0;
  double least = std::numeric_limits<double>::infinity();
  bool undefined = false;
  for_each_edge(polygon, [&](PlanePoint a, PlanePoint b) {
    const double distance = distance_to_segment(a, b, point);
    undefined = undefined || std::isnan(distance);
    least = std::min(least, distance);
  });
  return undefined ? std::numeric_limits<double>::quiet_NaN() : least;
}

}  // namespace tristim
