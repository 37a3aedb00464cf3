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

/// Runs lie within blocks of a row.
static_assert(kBlock == 16);

/// The runs of a plane, row by row, into `runs`, which grows as needed; how many there are.
std::size_t find_runs(const VisibilityPlane& plane, std::vector<HitRun>& runs);

/// What samples see, a row for each coordinate, in blocks: `pixel` is a plane's first of a block,
/// bit i of `lanes` is set where the block's sample i is one. The others are there to fill it.
/// Places are relative to the eye.
struct HitBlock {
  std::uint32_t pixel = 0;
  std::uint32_t lanes = 0;
};
struct HitRows {
  std::size_t size = 0;  // samples, with those that fill blocks
  std::vector<HitBlock> blocks;
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

/// The samples at `shift_x`, `shift_y` in the pixels of runs: blocks, sample_x, sample_y, nearness
/// and raw normals, then places and unit normals; with `facing` these are turned to the eye.
/// `planes` are in the order of `triangle`.
struct HitJob {
  std::span<const HitRun> runs;
  const SurfacePlanes* planes = nullptr;
  double shift_x = 0, shift_y = 0;
  HitRays rays = {};
  bool facing = false;
};

/// In vectors. hit_rows_simd.cpp
void gather_hits(const HitJob& job, HitRows& rows);

/// One sample after the other: what the fast versions are tested against, same bits.
std::size_t find_runs_scalar(const VisibilityPlane& plane, std::vector<HitRun>& runs);
void gather_hits_scalar(const HitJob& job, HitRows& rows);

}  // namespace tristim::detail
