#include "tristim/render/gouraud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "lib/core/double_double.h"
#include "lib/core/trigonometry.h"
#include "tristim/light/vector.h"

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
  Dd x, intensity, along;
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
  return Crossing{mix(a.at.x, b.at.x, u), mix(a.intensity, b.intensity, u), u};
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

Dd part_at(const Span& span, Dd x) noexcept {
  const Dd width = span.r.x - span.q.x;
  return width.hi > 0 ? (x - span.q.x) / width : Dd(0);
}

GouraudSpan rounded(const Span& span, Dd x) noexcept {
  const Dd t = part_at(span, x);
  return {.x_q = span.q.x.hi,
          .x_r = span.r.x.hi,
          .i_q = span.q.intensity.hi,
          .i_r = span.r.intensity.hi,
          .u = span.q.along.hi,
          .w = span.r.along.hi,
          .t = t.hi,
          .i_p = mix(span.q.intensity, span.r.intensity, t).hi};
}

GouraudSpan span_at(std::span<const Vertex> polygon, const Point& p) noexcept {
  const auto span = span_of(polygon, p.y);
  return span ? rounded(*span, p.x) : GouraudSpan{};
}

std::vector<Vertex> vertices_of(std::span<const GouraudVertex> polygon) {
  std::vector<Vertex> vertices;
  for (const GouraudVertex& v : polygon) vertices.push_back({precise(v.at), usable(v.intensity)});
  return vertices;
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
  return span_at(vertices_of(polygon), precise(p));
}

std::vector<double> gouraud_row(std::span<const GouraudVertex> polygon, const PixelRun& run) {
  std::vector<double> intensities(static_cast<std::size_t>(std::max(run.last - run.first, 0)));
  const auto span = span_of(vertices_of(polygon), run.y + 0.5);
  if (!span) return intensities;
  const Dd width = span->r.x - span->q.x;
  const Dd rise = span->r.intensity - span->q.intensity;
  const Dd step = width.hi > 0 ? rise / width : Dd(0);
  Dd intensity = mix(span->q.intensity, span->r.intensity, part_at(*span, run.first + 0.5));
  for (double& value : intensities) {
    value = intensity.hi;
    intensity = intensity + step;
  }
  return intensities;
}

Barycentric barycentric(std::span<const GouraudVertex, 3> triangle, const Vector2d& p) noexcept {
  const std::array<Dd, 3> parts = parts_of(triangle, p);
  return {parts[0].hi, parts[1].hi, parts[2].hi};
}

Barycentric barycentric_by_axes(std::span<const GouraudVertex, 3> triangle,
                                const Vector2d& p) noexcept {
  const Point a = precise(triangle[0].at);
  const Point to_b{precise(triangle[1].at).x - a.x, precise(triangle[1].at).y - a.y};
  const Point to_c{precise(triangle[2].at).x - a.x, precise(triangle[2].at).y - a.y};
  const Point to_p{precise(p).x - a.x, precise(p).y - a.y};
  const Dd determinant = to_b.x * to_c.y - to_c.x * to_b.y;
  if (determinant.hi == 0) return {};
  const Dd beta = (to_p.x * to_c.y - to_c.x * to_p.y) / determinant;
  const Dd gamma = (to_b.x * to_p.y - to_p.x * to_b.y) / determinant;
  return {(1 - beta - gamma).hi, beta.hi, gamma.hi};
}

bool is_convex(const Barycentric& parts) noexcept {
  const double least = std::min({parts.alpha, parts.beta, parts.gamma});
  return least >= 0 && parts.alpha + parts.beta + parts.gamma > 0;
}

Vector2d combination(std::span<const GouraudVertex, 3> triangle,
                     const Barycentric& parts) noexcept {
  const Point a = precise(triangle[0].at);
  const Point b = precise(triangle[1].at);
  const Point c = precise(triangle[2].at);
  return {(parts.alpha * a.x + parts.beta * b.x + parts.gamma * c.x).hi,
          (parts.alpha * a.y + parts.beta * b.y + parts.gamma * c.y).hi};
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

IncrementalDrift incremental_drift(long long x_q, long long x_r, double i_q, double i_r) {
  const std::vector<double> exact = gouraud_incremental(x_q, x_r, i_q, i_r);
  if (exact.size() < 2) return {};
  constexpr double kHalfUnit = 0x1p-24;
  const auto additions = static_cast<double>(exact.size() - 1);
  const auto step = static_cast<float>((i_r - i_q) / additions);
  IncrementalDrift drift;
  float sum = static_cast<float>(i_q);
  double most = 0;
  for (const double intensity : exact) {
    drift.largest = std::max(drift.largest, std::fabs(double{sum} - intensity));
    most = std::max({most, std::fabs(double{sum}), std::fabs(intensity)});
    sum += step;
  }
  // The start and the step are rounded once, the sums each.
  drift.bound = kHalfUnit * (additions * (std::fabs(double{step}) + most) + std::fabs(i_q));
  return drift;
}

std::vector<Eigen::Vector3d> normals_incremental(long long x_q, long long x_r,
                                                 const Eigen::Vector3d& n_q,
                                                 const Eigen::Vector3d& n_r) {
  std::array<std::vector<double>, 3> sums;
  for (int axis = 0; axis < 3; ++axis) {
    sums[static_cast<std::size_t>(axis)] = gouraud_incremental(x_q, x_r, n_q[axis], n_r[axis]);
  }
  std::vector<Eigen::Vector3d> normals;
  for (std::size_t i = 0; i < sums[0].size(); ++i) {
    normals.push_back(normalize(Eigen::Vector3d(sums[0][i], sums[1][i], sums[2][i])));
  }
  return normals;
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
