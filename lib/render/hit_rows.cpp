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

// What fills a block has a place and a normal as well.
void fill_block(HitRows& rows) {
  for (int i = 0; i < kBlock; ++i) {
    const std::size_t at = rows.size++;
    rows.sample_x[at] = rows.sample_y[at] = rows.raw_x[at] = rows.raw_y[at] = 0;
    rows.nearness[at] = rows.raw_z[at] = 1;
  }
}

void add_run(const HitJob& job, const HitRun& run, std::size_t at, HitRows& rows) {
  const SurfacePlanes& planes = job.planes[run.triangle];
  const double across = run.x + job.shift_x - planes.x0;
  const double down = run.y + job.shift_y - planes.y0;
  const auto add = [&](std::size_t k, std::vector<float>& row) {
    const auto start =
        static_cast<float>(planes.start[k] + (planes.dx[k] * across + planes.dy[k] * down));
    for (std::uint32_t i = 0; i < run.length; ++i) {
      row[at + i] = start + planes.step[k] * static_cast<float>(i);
    }
  };
  add(SurfacePlanes::kNearness, rows.nearness);
  add(SurfacePlanes::kX, rows.raw_x);
  add(SurfacePlanes::kY, rows.raw_y);
  add(SurfacePlanes::kZ, rows.raw_z);
  const auto x = static_cast<float>(run.x + job.shift_x);
  for (std::uint32_t i = 0; i < run.length; ++i) {
    rows.sample_x[at + i] = x + static_cast<float>(i);
    rows.sample_y[at + i] = static_cast<float>(run.y + job.shift_y);
  }
}

void set_axes(float (&out)[3], const Eigen::Vector3d& v) {
  for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(v[i]);
}

}  // namespace

std::size_t find_runs_scalar(const VisibilityPlane& plane, std::vector<HitRun>& runs) {
  runs.clear();
  const int width = plane.rect.width;
  for (int y = 0; y < plane.rect.height; ++y) {
    for (int x = 0; x < width;) {
      const int first = x;
      const auto pixel = static_cast<std::uint32_t>(y * width + first);
      const std::uint32_t* id = plane.id.data() + pixel - first;
      const int end = first - first % kBlock + kBlock;
      while (x < end && id[x] == id[first]) ++x;
      if (id[first] == kNothing) continue;
      runs.push_back({pixel, id[first], plane.rect.x0 + first, plane.rect.y0 + y,
                      static_cast<std::uint32_t>(x - first)});
    }
  }
  return runs.size();
}

void HitRows::resize(std::size_t most) {
  blocks.resize(most / kBlock + 1);
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

void gather_hits_scalar(const HitJob& job, HitRows& rows) {
  rows.size = 0;
  std::size_t blocks = 0;
  for (const HitRun& run : job.runs) {
    const std::uint32_t first = run.pixel % kBlock;
    if (blocks == 0 || rows.blocks[blocks - 1].pixel != run.pixel - first) {
      rows.blocks[blocks++] = {run.pixel - first, 0};
      fill_block(rows);
    }
    HitBlock& block = rows.blocks[blocks - 1];
    for (std::uint32_t i = 0; i < run.length; ++i) block.lanes |= 1U << (first + i);
    add_run(job, run, rows.size - kBlock + first, rows);
  }
  for (std::size_t i = 0; i < rows.size; ++i) {
    finish_at<ScalarLanes>(job.rays, job.facing, rows, i);
  }
}

}  // namespace tristim::detail
