// The rows of hit_rows.cpp in vectors, for each instruction set; the best one is chosen at run
// time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lib/render/hit_rows_simd.cpp"
// clang-format off: foreach_target.h comes before highway.h
#include <hwy/foreach_target.h>
// clang-format on
#include <hwy/highway.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "lib/core/exponent.h"
#include "lib/core/lanes_scalar.h"
#include "lib/render/hit_rows.h"

HWY_BEFORE_NAMESPACE();
namespace tristim::detail {
namespace HWY_NAMESPACE {

#include "lib/core/lanes-inl.h"
// clang-format off: builds on the one before
#include "lib/render/hit_lanes-inl.h"
// clang-format on

namespace hw = hwy::HWY_NAMESPACE;
using BlockTag = hw::CappedTag<float, kBlock>;
using IdTag = hw::RebindToUnsigned<BlockTag>;
using LanesOfBlock = hw::Vec<BlockTag>;

// The lanes of a run from lane `first` of a vector on, and how far each is from the run's start.
struct RunLanes {
  hw::Mask<BlockTag> inside;
  LanesOfBlock from_start;
};

HWY_INLINE RunLanes lanes_of_run(int first, std::uint32_t length) {
  const BlockTag d;
  const auto from_start = hw::Iota(d, 0) - hw::Set(d, static_cast<float>(first));
  const auto end = hw::Set(d, static_cast<float>(length));
  return {hw::And(from_start >= hw::Zero(d), from_start < end), from_start};
}

HWY_INLINE void put(const RunLanes& lanes, LanesOfBlock value, float* out) {
  hw::BlendedStore(value, lanes.inside, BlockTag(), out);
}

// The values of the four planes where a run starts.
HWY_INLINE std::array<float, 4> starts_of(const SurfacePlanes& planes, double across, double down) {
  std::array<float, 4> starts;
  for (std::size_t k = 0; k < 4; ++k) {
    starts[k] = static_cast<float>(planes.start[k] + (planes.dx[k] * across + planes.dy[k] * down));
  }
  return starts;
}

HWY_INLINE void add_run(const HitJob& job, const HitRun& run, std::size_t block, HitRows& rows) {
  const BlockTag d;
  const SurfacePlanes& planes = job.planes[run.triangle];
  const std::array<float, 4> starts =
      starts_of(planes, run.x + job.shift_x - planes.x0, run.y + job.shift_y - planes.y0);
  const std::array<float*, 4> out{rows.nearness.data() + block, rows.raw_x.data() + block,
                                  rows.raw_y.data() + block, rows.raw_z.data() + block};
  const auto x = hw::Set(d, static_cast<float>(run.x + job.shift_x));
  const auto y = hw::Set(d, static_cast<float>(run.y + job.shift_y));
  for (int lane = 0; lane < kBlock; lane += static_cast<int>(hw::Lanes(d))) {
    const auto lanes = lanes_of_run(static_cast<int>(run.pixel % kBlock) - lane, run.length);
    for (std::size_t k = 0; k < 4; ++k) {
      put(lanes, hw::Set(d, starts[k]) + hw::Set(d, planes.step[k]) * lanes.from_start,
          out[k] + lane);
    }
    put(lanes, x + lanes.from_start, rows.sample_x.data() + block + lane);
    put(lanes, y, rows.sample_y.data() + block + lane);
  }
}

HWY_INLINE void fill_block(HitRows& rows) {
  const BlockTag d;
  for (int lane = 0; lane < kBlock; lane += static_cast<int>(hw::Lanes(d))) {
    const std::size_t at = rows.size + static_cast<std::size_t>(lane);
    for (auto* row : {&rows.sample_x, &rows.sample_y, &rows.raw_x, &rows.raw_y}) {
      hw::StoreU(hw::Zero(d), d, row->data() + at);
    }
    for (auto* row : {&rows.nearness, &rows.raw_z}) hw::StoreU(hw::Set(d, 1), d, row->data() + at);
  }
  rows.size += kBlock;
}

// A bit for each pixel of a block that ends a run.
HWY_INLINE std::uint32_t ends_of(const std::uint32_t* id) {
  const IdTag d;
  std::uint32_t ends = 1U << (kBlock - 1);
  for (std::size_t i = 0; i < kBlock; i += hw::Lanes(d)) {
    std::uint8_t bytes[8] = {};
    hw::StoreMaskBits(d, hw::LoadU(d, id + i) != hw::LoadU(d, id + i + 1), bytes);
    ends |= (std::uint32_t{bytes[0]} | std::uint32_t{bytes[1]} << 8) << i;
  }
  return ends;
}

std::size_t runs_of(const VisibilityPlane& plane, std::vector<HitRun>& runs) {
  if (runs.size() < plane.id.size()) runs.resize(plane.id.size());
  HitRun* next = runs.data();
  const int width = plane.rect.width;
  for (int y = 0; y < plane.rect.height; ++y) {
    for (int block = 0; block < width; block += kBlock) {
      const auto pixel = static_cast<std::uint32_t>(y * width + block);
      const std::uint32_t* id = plane.id.data() + pixel;
      std::uint32_t first = 0;
      for (std::uint32_t ends = ends_of(id); ends != 0; ends &= ends - 1) {
        const auto last = static_cast<std::uint32_t>(std::countr_zero(ends));
        *next = {pixel + first, id[first], plane.rect.x0 + block + static_cast<int>(first),
                 plane.rect.y0 + y, last + 1 - first};
        next += id[first] == kNothing ? 0 : 1;
        first = last + 1;
      }
    }
  }
  return static_cast<std::size_t>(next - runs.data());
}

void gather(const HitJob& job, HitRows& rows) {
  rows.size = 0;
  HitBlock* block = rows.blocks.data() - 1;
  for (const HitRun& run : job.runs) {
    const std::uint32_t first = run.pixel % kBlock;
    if (rows.size == 0 || block->pixel != run.pixel - first) {
      *++block = {run.pixel - first, 0};
      fill_block(rows);
    }
    block->lanes |= ((1U << run.length) - 1) << first;
    add_run(job, run, rows.size - kBlock, rows);
  }
  const std::size_t step = VectorLanes::size();
  for (std::size_t i = 0; i < rows.size; i += step) {
    finish_at<VectorLanes>(job.rays, job.facing, rows, i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace tristim::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tristim::detail {

HWY_EXPORT(gather);
HWY_EXPORT(runs_of);

std::size_t find_runs(const VisibilityPlane& plane, std::vector<HitRun>& runs) {
  return HWY_DYNAMIC_DISPATCH(runs_of)(plane, runs);
}

void gather_hits(const HitJob& job, HitRows& rows) { HWY_DYNAMIC_DISPATCH(gather)(job, rows); }

}  // namespace tristim::detail
#endif
