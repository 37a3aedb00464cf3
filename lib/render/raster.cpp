#include "tristim/render/raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "lib/core/double_double.h"

namespace tristim {
namespace {

using Dd = detail::DoubleDouble;
using Eigen::Vector2d;

// The first pixel of a row whose centre is not left of where the edge crosses it; nothing to say of
// edges that do not reach the row.
struct RowCrossing {
  const Vector2d& low;
  const Vector2d& high;
  double y;

  bool reaches() const noexcept { return low.y() <= y && y < high.y(); }

  // Whether the crossing is at `x` or left of it, by the sign of a determinant.
  bool at_or_left_of(double x) const noexcept {
    const Dd along = (Dd(high.x()) - low.x()) * (Dd(y) - low.y());
    const Dd across = (Dd(x) - low.x()) * (Dd(high.y()) - low.y());
    return (across - along).hi >= 0;
  }

  int first_pixel(int width) const noexcept {
    int low_pixel = 0;
    int high_pixel = width;
    while (low_pixel < high_pixel) {
      const int middle = low_pixel + (high_pixel - low_pixel) / 2;
      if (at_or_left_of(middle + 0.5)) {
        high_pixel = middle;
      } else {
        low_pixel = middle + 1;
      }
    }
    return low_pixel;
  }
};

RowCrossing row_crossing(std::span<const Vector2d> polygon, std::size_t i, double y) noexcept {
  const Vector2d& a = polygon[i];
  const Vector2d& b = polygon[(i + 1) % polygon.size()];
  return a.y() <= b.y() ? RowCrossing{a, b, y} : RowCrossing{b, a, y};
}

std::vector<int> crossings_of_row(std::span<const Vector2d> polygon, double y, int width) {
  std::vector<int> first;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RowCrossing edge = row_crossing(polygon, i, y);
    if (edge.reaches()) first.push_back(edge.first_pixel(width));
  }
  std::sort(first.begin(), first.end());
  return first;
}

void add_run(std::vector<PixelRun>& runs, const PixelRun& run) {
  if (run.first == run.last) return;
  const bool touches = !runs.empty() && runs.back().y == run.y && runs.back().last == run.first;
  if (touches) {
    runs.back().last = run.last;
  } else {
    runs.push_back(run);
  }
}

}  // namespace

Eigen::Vector3d to_viewport(const Viewport& viewport, const Eigen::Vector3d& ndc) noexcept {
  return {viewport.width / 2 * (1 + ndc.x()) + viewport.left,
          viewport.height / 2 * (1 - ndc.y()) + viewport.top, (1 + ndc.z()) / 2};
}

std::vector<Pixel> midpoint_line(Pixel p0, Pixel p1) {
  const long long dx = p1.x - p0.x;
  const long long dy = p1.y - p0.y;
  const bool steep = std::llabs(dy) > std::llabs(dx);
  const long long longer = steep ? std::llabs(dy) : std::llabs(dx);
  const long long shorter = steep ? std::llabs(dx) : std::llabs(dy);
  const long long step_x = dx < 0 ? -1 : 1;
  const long long step_y = dy < 0 ? -1 : 1;
  std::vector<Pixel> pixels{p0};
  long long decision = 2 * shorter - longer;  // above 0: the line is past the midpoint
  for (long long i = 0; i < longer; ++i) {
    const bool both = decision > 0;
    if (both || !steep) p0.x += step_x;
    if (both || steep) p0.y += step_y;
    decision += 2 * shorter - (both ? 2 * longer : 0);
    pixels.push_back(p0);
  }
  return pixels;
}

std::vector<PixelRun> parity_fill(int width, int height, std::span<const Vector2d> polygon) {
  std::vector<PixelRun> runs;
  for (int y = 0; y < height; ++y) {
    const std::vector<int> first = crossings_of_row(polygon, y + 0.5, width);
    for (std::size_t i = 0; i + 1 < first.size(); i += 2)
      add_run(runs, {y, first[i], first[i + 1]});
  }
  return runs;
}

PixelBox bounding_box(int width, int height, std::span<const Vector2d> polygon) noexcept {
  if (polygon.empty()) return {};
  Vector2d least = polygon[0];
  Vector2d most = polygon[0];
  for (const Vector2d& corner : polygon) {
    least = least.cwiseMin(corner);
    most = most.cwiseMax(corner);
  }
  // The first pixel whose centre is not below `edge`.
  const auto first_from = [](double edge, int side) {
    return static_cast<int>(std::clamp(std::ceil(edge - 0.5), 0.0, double(side)));
  };
  const PixelBox box{first_from(least.x(), width), first_from(least.y(), height),
                     first_from(most.x(), width), first_from(most.y(), height)};
  return box.first_x < box.last_x && box.first_y < box.last_y ? box : PixelBox{};
}

bool is_inside(std::span<const Vector2d> polygon, const Vector2d& point) noexcept {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RowCrossing edge = row_crossing(polygon, i, point.y());
    if (edge.reaches() && edge.at_or_left_of(point.x())) inside = !inside;
  }
  return inside;
}

std::vector<PixelRun> bounding_box_fill(int width, int height, std::span<const Vector2d> polygon) {
  const PixelBox box = bounding_box(width, height, polygon);
  std::vector<PixelRun> runs;
  for (int y = box.first_y; y < box.last_y; ++y) {
    for (int x = box.first_x; x < box.last_x; ++x) {
      if (is_inside(polygon, {x + 0.5, y + 0.5})) add_run(runs, {y, x, x + 1});
    }
  }
  return runs;
}

std::vector<std::string> flood_fill(std::vector<std::string> rows, long long x, long long y,
                                    Connectivity connectivity) {
  constexpr std::array<Pixel, 8> kNeighbours{
      {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};
  const std::size_t count = connectivity == Connectivity::kFour ? 4 : 8;
  std::vector<Pixel> waiting{{x, y}};
  while (!waiting.empty()) {
    const Pixel at = waiting.back();
    waiting.pop_back();
    const auto row = static_cast<std::size_t>(at.y);
    const auto column = static_cast<std::size_t>(at.x);
    if (at.x < 0 || at.y < 0 || row >= rows.size() || column >= rows[row].size()) continue;
    if (rows[row][column] != '0') continue;
    rows[row][column] = '2';
    for (std::size_t i = 0; i < count; ++i) {
      waiting.push_back({at.x + kNeighbours[i].x, at.y + kNeighbours[i].y});
    }
  }
  return rows;
}

std::vector<std::string> outline_fill(int width, int height, std::span<const Pixel> corners,
                                      Pixel seed, Connectivity connectivity) {
  std::vector<std::string> rows(static_cast<std::size_t>(height),
                                std::string(static_cast<std::size_t>(width), '0'));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (const Pixel& p : midpoint_line(corners[i], corners[(i + 1) % corners.size()])) {
      const bool seen = p.x >= 0 && p.y >= 0 && p.x < width && p.y < height;
      if (seen) rows[static_cast<std::size_t>(p.y)][static_cast<std::size_t>(p.x)] = '1';
    }
  }
  return flood_fill(std::move(rows), seed.x, seed.y, connectivity);
}

}  // namespace tristim
