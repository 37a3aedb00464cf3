// The rows of hit_rows.cpp in vectors, for each instruction set; the best one is chosen at run
// time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lib/render/hit_rows_simd.cpp"
// clang-format off: foreach_target.h comes before highway.h
#include <hwy/foreach_target.h>
// clang-format on
#include <hwy/highway.h>

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
using Floats16 = hw::CappedTag<float, kLongestRun>;
using Ids16 = hw::RebindToUnsigned<Floats16>;

HWY_INLINE void store_plane(const Plane& plane, double across, double down, std::size_t length,
                            float* out) {
  const Floats16 d;
  const auto start = hw::Set(d, static_cast<float>(plane.at(across, down)));
  const auto step = hw::Set(d, static_cast<float>(plane.dx));
  for (std::size_t i = 0; i < length; i += hw::Lanes(d)) {
    hw::StoreU(start + step * hw::Iota(d, static_cast<float>(i)), d, out + i);
  }
}

HWY_INLINE void add(const HitRun& run, const SurfacePlanes& planes, double shift_x, double shift_y,
                    HitRows& rows) {
  const Floats16 d;
  const Ids16 ids;
  const double across = run.x + shift_x - planes.x0;
  const double down = run.y + shift_y - planes.y0;
  store_plane(planes.nearness, across, down, run.length, rows.nearness.data() + rows.size);
  store_plane(planes.nx, across, down, run.length, rows.raw_x.data() + rows.size);
  store_plane(planes.ny, across, down, run.length, rows.raw_y.data() + rows.size);
  store_plane(planes.nz, across, down, run.length, rows.raw_z.data() + rows.size);
  const auto x = hw::Set(d, static_cast<float>(run.x + shift_x));
  const auto y = hw::Set(d, static_cast<float>(run.y + shift_y));
  for (std::size_t i = 0; i < run.length; i += hw::Lanes(d)) {
    const std::size_t at = rows.size + i;
    hw::StoreU(x + hw::Iota(d, static_cast<float>(i)), d, rows.sample_x.data() + at);
    hw::StoreU(y, d, rows.sample_y.data() + at);
    hw::StoreU(hw::Iota(ids, static_cast<std::uint32_t>(run.pixel + i)), ids,
               rows.pixel.data() + at);
  }
  rows.size += run.length;
}

// A bit for each pixel of a block that ends a run.
HWY_INLINE std::uint32_t ends_of(const std::uint32_t* id) {
  const Ids16 d;
  std::uint32_t ends = 1U << (kLongestRun - 1);
  for (std::size_t i = 0; i < kLongestRun; i += hw::Lanes(d)) {
    std::uint8_t bytes[8] = {};
    hw::StoreMaskBits(d, hw::LoadU(d, id + i) != hw::LoadU(d, id + i + 1), bytes);
    ends |= (std::uint32_t{bytes[0]} | std::uint32_t{bytes[1]} << 8) << i;
  }
  return ends;
}

void runs_of(const VisibilityPlane& plane, std::vector<HitRun>& runs) {
  runs.resize(plane.id.size());
  HitRun* next = runs.data();
  const int width = plane.rect.width;
  for (int y = 0; y < plane.rect.height; ++y) {
    for (int block = 0; block < width; block += kLongestRun) {
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
  runs.resize(static_cast<std::size_t>(next - runs.data()));
}

void gather(const HitRun* runs, std::size_t count, const SurfacePlanes* planes, double shift_x,
            double shift_y, const HitRays& rays, bool facing, HitRows& rows) {
  for (std::size_t i = 0; i < count; ++i) {
    add(runs[i], planes[runs[i].triangle], shift_x, shift_y, rows);
  }
  const std::size_t step = VectorLanes::size();
  for (std::size_t i = 0; i < rows.size; i += step) {
    finish_at<VectorLanes>(rays, facing, rows, i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace tristim::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tristim::detail {

HWY_EXPORT(gather);
HWY_EXPORT(runs_of);

void find_runs(const VisibilityPlane& plane, std::vector<HitRun>& runs) {
  HWY_DYNAMIC_DISPATCH(runs_of)(plane, runs);
}

void gather_hits(std::span<const HitRun> runs, const SurfacePlanes* planes, double shift_x,
                 double shift_y, const HitRays& rays, bool facing, HitRows& rows) {
  HWY_DYNAMIC_DISPATCH(gather)
  (runs.data(), runs.size(), planes, shift_x, shift_y, rays, facing, rows);
}

}  // namespace tristim::detail
#endif
