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

struct Pixels {
  Float r, g, b;
};

HWY_INLINE Pixels load(const float* rgb) {
  Pixels p;
  hn::LoadInterleaved3(Floats(), rgb, p.r, p.g, p.b);
  return p;
}

HWY_INLINE void store(Pixels p, float* rgb) { hn::StoreInterleaved3(p.r, p.g, p.b, Floats(), rgb); }

template <bool kDiagonal>
HWY_INLINE Pixels multiplied(const RowMatrix& matrix, Pixels p) {
  const Floats f;
  const auto& m = matrix.m;
  if (kDiagonal) {
    return {hn::Set(f, m[0][0]) * p.r, hn::Set(f, m[1][1]) * p.g, hn::Set(f, m[2][2]) * p.b};
  }
  const auto row = [&](int k) {
    return hn::Set(f, m[k][0]) * p.r + hn::Set(f, m[k][1]) * p.g + hn::Set(f, m[k][2]) * p.b;
  };
  return {row(0), row(1), row(2)};
}

// As the scalar code's comparisons, which NaN fails.
HWY_INLINE Float held(Float v) {
  const Floats f;
#if HWY_ARCH_X86  // one instruction each
  return hn::Min(hn::Max(v, hn::Zero(f)), hn::Set(f, 1.0F));
#else
  const Float positive = hn::IfThenElseZero(v > hn::Zero(f), v);
  return hn::IfThenElse(positive > hn::Set(f, 1.0F), hn::Set(f, 1.0F), positive);
#endif
}

HWY_INLINE void count_outside(Pixels p, StageCounts& counts) {
  const Floats f;
  const Float zero = hn::Zero(f);
  const Float one = hn::Set(f, 1.0F);
  const auto below = hn::Or(hn::Or(p.r < zero, p.g < zero), p.b < zero);
  const auto above = hn::Or(hn::Or(p.r > one, p.g > one), p.b > one);
  counts.out_of_gamut += hn::CountTrue(f, below);
  counts.clipped += hn::CountTrue(f, above);
}

HWY_INLINE Pixels clipped(Pixels p, StageCounts& counts) {
  const Pixels inside{held(p.r), held(p.g), held(p.b)};
  const auto stays = hn::And(hn::And(inside.r == p.r, inside.g == p.g), inside.b == p.b);
  if (!hn::AllTrue(Floats(), stays)) count_outside(p, counts);
  return inside;
}

template <bool kDiagonal>
void multiply_row(const RowMatrix& matrix, float* rgb, std::size_t pixels) {
  const std::size_t lanes = hn::Lanes(Floats());
  std::size_t i = 0;
  for (; i + lanes <= pixels; i += lanes) {
    store(multiplied<kDiagonal>(matrix, load(rgb + 3 * i)), rgb + 3 * i);
  }
  scalar_stage_kernels().multiply(matrix, rgb + 3 * i, pixels - i);
}

void multiply(const RowMatrix& matrix, float* rgb, std::size_t pixels) {
  const auto kernel = matrix.diagonal ? multiply_row<true> : multiply_row<false>;
  kernel(matrix, rgb, pixels);
}

StageCounts clip(float* rgb, std::size_t pixels) {
  const std::size_t lanes = hn::Lanes(Floats());
  StageCounts counts;
  std::size_t i = 0;
  for (; i + lanes <= pixels; i += lanes) store(clipped(load(rgb + 3 * i), counts), rgb + 3 * i);
  counts += scalar_stage_kernels().clip(rgb + 3 * i, pixels - i);
  return counts;
}

StageCounts split(const RowMatrix* matrix, bool clips, const float* rgb, std::size_t pixels,
                  float* const (&planes)[3]) {
  const Floats f;
  const std::size_t lanes = hn::Lanes(f);
  StageCounts counts;
  std::size_t i = 0;
  for (; i + lanes <= pixels; i += lanes) {
    Pixels p = load(rgb + 3 * i);
    if (matrix != nullptr) {
      p = matrix->diagonal ? multiplied<true>(*matrix, p) : multiplied<false>(*matrix, p);
    }
    if (clips) p = clipped(p, counts);
    hn::StoreU(p.r, f, planes[0] + i);
    hn::StoreU(p.g, f, planes[1] + i);
    hn::StoreU(p.b, f, planes[2] + i);
  }
  float* const rest[3] = {planes[0] + i, planes[1] + i, planes[2] + i};
  counts += scalar_stage_kernels().split(matrix, clips, rgb + 3 * i, pixels - i, rest);
  return counts;
}

StageKernels vector_kernels() { return {hwy::TargetName(HWY_TARGET), multiply, clip, split}; }

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
