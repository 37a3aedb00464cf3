#include "tristim/render/gouraud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "lib/core/double_double.h"
#include "lib/core/trigonometry.h"

namespace tristim {
namespace {

using Dd = detail::DoubleDouble;
using Eigen::Vector2d;

struct Point {
  Dd x, y;
};

struct Vertex {
  Point at;
  double intensity;
};

// Where the line meets an edge.
struct Crossing {
  Dd x, intensity;
};

struct Span {
  Crossing q, r;
};

// What is beyond every picture counts as its edge: the products of such numbers would overflow.
double usable(double value) noexcept { return std::clamp(value, -1e140, 1e140); }

Point precise(const Vector2d& v) noexcept { return {usable(v.x()), usable(v.y())}; }

Dd mix(Dd a, Dd b, Dd t) noexcept { return (1 - t) * a + t * b; }

std::optional<Crossing> crossing(const Vertex& a, const Vertex& b, Dd y) noexcept {
  const Dd height = b.at.y - a.at.y;
  if (height.hi == 0) return std::nullopt;  // its ends are those of other edges
  const Dd u = (y - a.at.y) / height;
  if (u.hi < 0 || (u - 1).hi > 0) return std::nullopt;
  return Crossing{mix(a.at.x, b.at.x, u), mix(a.intensity, b.intensity, u)};
}

std::optional<Span> span_of(std::span<const Vertex> polygon, Dd y) noexcept {
  std::optional<Span> span;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto met = crossing(polygon[i], polygon[(i + 1) % polygon.size()], y);
    if (!met) continue;
    if (!span) span = Span{*met, *met};
    if ((met->x - span->q.x).hi < 0) span->q = *met;
    if ((met->x - span->r.x).hi > 0) span->r = *met;
  }
  return span;
}

GouraudSpan rounded(const Span& span, Dd x) noexcept {
  const Dd width = span.r.x - span.q.x;
  const Dd t = width.hi > 0 ? (x - span.q.x) / width : Dd(0);
  return {span.q.x.hi,         span.r.x.hi, span.q.intensity.hi,
          span.r.intensity.hi, t.hi,        mix(span.q.intensity, span.r.intensity, t).hi};
}

GouraudSpan span_at(std::span<const Vertex> polygon, const Point& p) noexcept {
  const auto span = span_of(polygon, p.y);
  return span ? rounded(*span, p.x) : GouraudSpan{};
}

// Twice the area of a triangle, above 0 where it runs counter-clockwise.
Dd twice_area(const Point& a, const Point& b, const Point& c) noexcept {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

std::array<Dd, 3> parts_of(std::span<const GouraudVertex, 3> triangle, const Vector2d& p) noexcept {
  const Point a = precise(triangle[0].at);
  const Point b = precise(triangle[1].at);
  const Point c = precise(triangle[2].at);
  const Dd whole = twice_area(a, b, c);
  if (whole.hi == 0) return {};
  const Point at = precise(p);
  return {twice_area(at, b, c) / whole, twice_area(a, at, c) / whole, twice_area(a, b, at) / whole};
}

}  // namespace

GouraudSpan gouraud_span(std::span<const GouraudVertex> polygon, const Vector2d& p) {
  std::vector<Vertex> vertices;
  for (const GouraudVertex& v : polygon) vertices.push_back({precise(v.at), usable(v.intensity)});
  return span_at(vertices, precise(p));
}

Barycentric barycentric(std::span<const GouraudVertex, 3> triangle, const Vector2d& p) noexcept {
  const std::array<Dd, 3> parts = parts_of(triangle, p);
  return {parts[0].hi, parts[1].hi, parts[2].hi};
}

double perspective_intensity(std::span<const GouraudVertex, 3> triangle,
                             const Vector2d& p) noexcept {
  const std::array<Dd, 3> parts = parts_of(triangle, p);
  int exponent = 0;  // of the least w: only their ratios count, and 1/w of a tiny one overflows
  (void)std::frexp(
      std::min({std::fabs(triangle[0].w), std::fabs(triangle[1].w), std::fabs(triangle[2].w)}),
      &exponent);
  Dd above = 0;
  Dd below = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Dd part = parts[i] / usable(std::ldexp(triangle[i].w, -exponent));
    above = above + part * usable(triangle[i].intensity);
    below = below + part;
  }
  return below.hi == 0 ? 0 : (above / below).hi;
}

std::vector<double> gouraud_incremental(long long x_q, long long x_r, double i_q, double i_r) {
  std::vector<double> intensities;
  if (x_r < x_q) return intensities;
  const auto steps = static_cast<double>(x_r - x_q);
  const Dd step = steps > 0 ? (Dd(usable(i_r)) - usable(i_q)) / steps : Dd(0);
  Dd intensity = usable(i_q);
  for (long long x = x_q; x <= x_r; ++x) {
    intensities.push_back(intensity.hi);
    intensity = intensity + step;
  }
  return intensities;
}

double gouraud_turned(std::span<const GouraudVertex> polygon, const Vector2d& p, double angle_deg) {
  const detail::PreciseSineCosine angle = detail::precise_sine_cosine_deg(angle_deg);
  const auto turned = [&](const Vector2d& v) {
    const Point at = precise(v);
    return Point{angle.cosine * at.x - angle.sine * at.y, angle.sine * at.x + angle.cosine * at.y};
  };
  std::vector<Vertex> vertices;
  for (const GouraudVertex& v : polygon) vertices.push_back({turned(v.at), usable(v.intensity)});
  return span_at(vertices, turned(p)).i_p;
}

}  // namespace tristim
