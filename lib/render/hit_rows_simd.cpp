// The rows of hit_rows.cpp in vectors, for each instruction set; the best one is chosen at run
// time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lib/render/hit_rows_simd.cpp"
// clang-format off: foreach_target.h comes before highway.h
#include <hwy/foreach_target.h>
// clang-format on
#include <hwy/highway.h>

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
using Doubles8 = hw::CappedTag<double, 8>;
using Floats8 = hw::Rebind<float, Doubles8>;
using Ids16 = hw::CappedTag<std::uint32_t, 16>;

HWY_INLINE void store_plane(const Plane& plane, hw::Vec<Doubles8> across, double down,
                            double* out) {
  const Doubles8 d;
  const auto down_part = hw::Set(d, plane.dy * down);
  hw::StoreU(hw::Set(d, plane.start) + (hw::Set(d, plane.dx) * across + down_part), d, out);
}

HWY_INLINE void add(const HitRun& run, const SurfacePlanes& planes, double shift_x, double shift_y,
                    HitRows& rows) {
  const Doubles8 d;
  const Floats8 f;
  const double down = run.y + shift_y - planes.y0;
  const auto row = hw::Set(f, static_cast<float>(run.y + shift_y));
  const std::size_t step = hw::Lanes(d);
  for (std::size_t i = 0; i < run.length; i += step) {
    const std::size_t at = rows.size + i;
    const auto x = (hw::Set(d, run.x) + hw::Iota(d, static_cast<double>(i))) + hw::Set(d, shift_x);
    const auto across = x - hw::Set(d, planes.x0);
    hw::StoreU(hw::DemoteTo(f, x), f, rows.sample_x.data() + at);
    hw::StoreU(row, f, rows.sample_y.data() + at);
    store_plane(planes.nearness, across, down, rows.nearness.data() + at);
    store_plane(planes.nx, across, down, rows.raw_x.data() + at);
    store_plane(planes.ny, across, down, rows.raw_y.data() + at);
    store_plane(planes.nz, across, down, rows.raw_z.data() + at);
  }
  const Ids16 ids;
  for (std::size_t i = 0; i < run.length; i += hw::Lanes(ids)) {
    hw::StoreU(hw::Iota(ids, static_cast<std::uint32_t>(run.pixel + i)), ids,
               rows.pixel.data() + rows.size + i);
  }
  rows.size += run.length;
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

void gather_hits(std::span<const HitRun> runs, const SurfacePlanes* planes, double shift_x,
                 double shift_y, const HitRays& rays, bool facing, HitRows& rows) {
  HWY_DYNAMIC_DISPATCH(gather)
  (runs.data(), runs.size(), planes, shift_x, shift_y, rays, facing, rows);
}

}  // namespace tristim::detail
#endif
