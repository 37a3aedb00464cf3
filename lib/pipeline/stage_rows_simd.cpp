// The rows of stage_rows.cpp in vectors, for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lib/pipeline/stage_rows_simd.cpp"
// clang-format off: foreach_target.h comes before highway.h
#include <hwy/foreach_target.h>
// clang-format on
#include <hwy/highway.h>

#include "lib/core/every_target.h"
#include "lib/pipeline/stage_rows.h"

HWY_BEFORE_NAMESPACE();
namespace tristim::detail::stages::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

StageKernels vector_kernels() { return scalar_stage_kernels(); }

#else

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Float = hn::Vec<Floats>;

void multiply(const float (&m)[3][3], float* rgb, std::size_t pixels) {
  const Floats f;
  const std::size_t lanes = hn::Lanes(f);
  std::size_t i = 0;
  for (; i + lanes <= pixels; i += lanes) {
    Float r, g, b;
    hn::LoadInterleaved3(f, rgb + 3 * i, r, g, b);
    const auto row = [&](int k) {
      return hn::Set(f, m[k][0]) * r + hn::Set(f, m[k][1]) * g + hn::Set(f, m[k][2]) * b;
    };
    hn::StoreInterleaved3(row(0), row(1), row(2), f, rgb + 3 * i);
  }
  scalar_stage_kernels().multiply(m, rgb + 3 * i, pixels - i);
}

StageCounts clip(float* rgb, std::size_t pixels) {
  const Floats f;
  const std::size_t lanes = hn::Lanes(f);
  const Float zero = hn::Zero(f);
  const Float one = hn::Set(f, 1.0F);
  // as the scalar code's comparisons, which NaN fails
  const auto held = [&](Float v) {
    const Float positive = hn::IfThenElseZero(v > zero, v);
    return hn::IfThenElse(positive > one, one, positive);
  };
  StageCounts counts;
  std::size_t i = 0;
  for (; i + lanes <= pixels; i += lanes) {
    Float r, g, b;
    hn::LoadInterleaved3(f, rgb + 3 * i, r, g, b);
    const auto below = hn::Or(hn::Or(r < zero, g < zero), b < zero);
    const auto above = hn::Or(hn::Or(r > one, g > one), b > one);
    counts.out_of_gamut += hn::CountTrue(f, below);
    counts.clipped += hn::CountTrue(f, above);
    hn::StoreInterleaved3(held(r), held(g), held(b), f, rgb + 3 * i);
  }
  const StageCounts rest = scalar_stage_kernels().clip(rgb + 3 * i, pixels - i);
  return {counts.out_of_gamut + rest.out_of_gamut, counts.clipped + rest.clipped};
}

StageKernels vector_kernels() { return {hwy::TargetName(HWY_TARGET), multiply, clip}; }

#endif

}  // namespace tristim::detail::stages::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tristim::detail {
namespace stages {
namespace {

HWY_EXPORT(vector_kernels);

}  // namespace
}  // namespace stages

std::span<const StageKernels> simd_stage_kernels() {
  static const std::vector<StageKernels> kernels =
      of_every_target(stages::HWY_DISPATCH_TABLE(vector_kernels));
  return kernels;
}

}  // namespace tristim::detail
#endif
