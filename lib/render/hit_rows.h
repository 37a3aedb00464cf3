#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/render/tile_draw.h"
#include "lib/render/triangle_planes.h"
#include "tristim/light/rows.h"

namespace tristim::detail {

/// Pixels of a row, one beside the other, that see the same triangle.
struct HitRun {
  std::uint32_t pixel = 0;     // of the first, in the plane
  std::uint32_t triangle = 0;  // place in the list of the tile
  std::int32_t x = 0, y = 0;   // of the first, in the picture
  std::uint32_t length = 0;
};

/// Runs are no longer: planes are in single precision from where a run starts.
inline constexpr int kLongestRun = 16;

/// The runs of a plane, row by row.
void find_runs(const VisibilityPlane& plane, std::vector<HitRun>& runs);

/// What samples see, a row for each coordinate. Places are relative to the eye.
struct HitRows {
  std::size_t size = 0;
  std::vector<std::uint32_t> pixel;                  // in the plane
  std::vector<float> sample_x, sample_y;             // in the picture
  std::vector<float> nearness, raw_x, raw_y, raw_z;  // as SurfacePlanes has them
  std::vector<float> x, y, z, nx, ny, nz;
  std::vector<float> distance;  // along the view axis

  void resize(std::size_t most);
  SurfaceRows surface() const noexcept;
};

/// Vectors are stored whole: so much is written behind the last hit.
inline constexpr std::size_t kHitPadding = 64;

/// The camera as finish_hits reads it: the way to what pixel (x, y) sees at distance 1 is
/// start + dx x + dy y.
struct HitRays {
  bool orthographic = false;
  float start[3] = {}, dx[3] = {}, dy[3] = {};
  float along[3] = {};  // where orthographic; then the former is where a ray starts
};

HitRays hit_rays(const View& view) noexcept;

/// The same one pixel after the other: what the fast version is tested against.
void find_runs_scalar(const VisibilityPlane& plane, std::vector<HitRun>& runs);

/// Appends the samples of a run at `shift_x`, `shift_y` in their pixels: pixel, sample_x, sample_y,
/// nearness and raw normals. `planes` are those of the run's triangle.
void add_run(const HitRun& run, const SurfacePlanes& planes, double shift_x, double shift_y,
             HitRows& rows);

/// Places and unit normals of all samples; with `facing` normals are turned to the eye.
void finish_hits(const HitRays& rays, bool facing, HitRows& rows);

/// add_run for each run, then finish_hits, in vectors: same bits. `planes` in the order of
/// `triangle`. hit_rows_simd.cpp
void gather_hits(std::span<const HitRun> runs, const SurfacePlanes* planes, double shift_x,
                 double shift_y, const HitRays& rays, bool facing, HitRows& rows);

}  // namespace tristim::detail
