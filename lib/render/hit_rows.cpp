#include "lib/render/hit_rows.h"

#include <hwy/base.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/core/exponent.h"
#include "lib/core/lanes_scalar.h"

namespace tristim::detail {
namespace {

#include "lib/render/hit_lanes-inl.h"

HitRun run_from(const VisibilityPlane& plane, std::size_t row, int x, int y, std::uint32_t id) {
  return {static_cast<std::uint32_t>(row + static_cast<std::size_t>(x)), id, plane.rect.x0 + x,
          plane.rect.y0 + y, 0};
}

void set_axes(float (&out)[3], const Eigen::Vector3d& v) {
  for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(v[i]);
}

}  // namespace

void find_runs_scalar(const VisibilityPlane& plane, std::vector<HitRun>& runs) {
  runs.clear();
  const int width = plane.rect.width;
  for (int y = 0; y < plane.rect.height; ++y) {
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    const std::uint32_t* id = plane.id.data() + row;
    for (int x = 0; x < width;) {
      const int first = x;
      const std::uint32_t seen = id[x];
      const int end = first - first % kLongestRun + kLongestRun;
      while (x < end && id[x] == seen) ++x;
      if (seen == kNothing) continue;
      runs.push_back(run_from(plane, row, first, y, seen));
      runs.back().length = static_cast<std::uint32_t>(x - first);
    }
  }
}

void HitRows::resize(std::size_t most) {
  pixel.resize(most + kHitPadding);
  for (auto* row : {&sample_x, &sample_y, &x, &y, &z, &nx, &ny, &nz, &distance, &nearness, &raw_x,
                    &raw_y, &raw_z}) {
    row->resize(most + kHitPadding);
  }
}

SurfaceRows HitRows::surface() const noexcept {
  const auto row = [&](const std::vector<float>& values) {
    return std::span<const float>(values.data(), size);
  };
  return {row(x), row(y), row(z), row(nx), row(ny), row(nz)};
}

HitRays hit_rays(const View& view) noexcept {
  HitRays rays;
  rays.orthographic = view.orthographic;
  const ViewRay corner = view_ray(view, 0, 0);
  const Eigen::Vector3d start = view.orthographic ? corner.from : corner.along;
  set_axes(rays.start, start);
  set_axes(rays.dx, view.right / view.scale);
  set_axes(rays.dy, -view.up / view.scale);
  set_axes(rays.along, corner.along);
  return rays;
}

void add_run(const HitRun& run, const SurfacePlanes& planes, double shift_x, double shift_y,
             HitRows& rows) {
  const double across = run.x + shift_x - planes.x0;
  const double down = run.y + shift_y - planes.y0;
  const auto add = [&](const Plane& plane, std::vector<float>& row) {
    const auto start = static_cast<float>(plane.at(across, down));
    for (std::uint32_t i = 0; i < run.length; ++i) {
      row[rows.size + i] = start + static_cast<float>(plane.dx) * static_cast<float>(i);
    }
  };
  add(planes.nearness, rows.nearness);
  add(planes.nx, rows.raw_x);
  add(planes.ny, rows.raw_y);
  add(planes.nz, rows.raw_z);
  const auto x = static_cast<float>(run.x + shift_x);
  for (std::uint32_t i = 0; i < run.length; ++i) {
    rows.pixel[rows.size + i] = run.pixel + i;
    rows.sample_x[rows.size + i] = x + static_cast<float>(i);
    rows.sample_y[rows.size + i] = static_cast<float>(run.y + shift_y);
  }
  rows.size += run.length;
}

void finish_hits(const HitRays& rays, bool facing, HitRows& rows) {
  for (std::size_t i = 0; i < rows.size; ++i) finish_at<ScalarLanes>(rays, facing, rows, i);
}

}  // namespace tristim::detail
