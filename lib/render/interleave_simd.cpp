// Four planes and four pixels at a time. Nothing is computed: it is as fast on any instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lib/render/interleave_simd.cpp"
// clang-format off: foreach_target.h comes before highway.h
#include <hwy/foreach_target.h>
// clang-format on
#include <hwy/highway.h>

#include "lib/render/interleave.h"

HWY_BEFORE_NAMESPACE();
namespace tristim::detail {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE void one_by_one(const float* const* planes, std::size_t channels, std::size_t stride,
                           std::size_t first, std::size_t count, float* pixels) {
  for (std::size_t i = first; i < count; ++i) {
    for (std::size_t c = 0; c < channels; ++c) pixels[i * stride + c] = planes[c][i];
  }
}

#if HWY_TARGET == HWY_SCALAR
HWY_INLINE std::size_t by_four(const float* const*, std::size_t, std::size_t, float*) { return 0; }
#else
// The number of pixels that were written.
HWY_INLINE std::size_t by_four(const float* const* planes, std::size_t stride, std::size_t count,
                               float* pixels) {
  const hn::FixedTag<float, 4> d;
  const hn::Repartition<double, decltype(d)> pairs;
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) {
    const auto a = hn::LoadU(d, planes[0] + i);
    const auto b = hn::LoadU(d, planes[1] + i);
    const auto c = hn::LoadU(d, planes[2] + i);
    const auto e = hn::LoadU(d, planes[3] + i);
    const auto ab_low = hn::BitCast(pairs, hn::InterleaveLower(d, a, b));
    const auto ce_low = hn::BitCast(pairs, hn::InterleaveLower(d, c, e));
    const auto ab_high = hn::BitCast(pairs, hn::InterleaveUpper(d, a, b));
    const auto ce_high = hn::BitCast(pairs, hn::InterleaveUpper(d, c, e));
    float* to = pixels + i * stride;
    hn::StoreU(hn::BitCast(d, hn::InterleaveLower(pairs, ab_low, ce_low)), d, to);
    hn::StoreU(hn::BitCast(d, hn::InterleaveUpper(pairs, ab_low, ce_low)), d, to + stride);
    hn::StoreU(hn::BitCast(d, hn::InterleaveLower(pairs, ab_high, ce_high)), d, to + 2 * stride);
    hn::StoreU(hn::BitCast(d, hn::InterleaveUpper(pairs, ab_high, ce_high)), d, to + 3 * stride);
  }
  return i;
}
#endif

void interleave(const float* const* planes, std::size_t channels, std::size_t count,
                float* pixels) {
  std::size_t c = 0;
  for (; c + 4 <= channels; c += 4) {
    const std::size_t done = by_four(planes + c, channels, count, pixels + c);
    one_by_one(planes + c, 4, channels, done, count, pixels + c);
  }
  one_by_one(planes + c, channels - c, channels, 0, count, pixels + c);
}

}  // namespace HWY_NAMESPACE
}  // namespace tristim::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tristim::detail {

HWY_EXPORT(interleave);

void interleave(std::span<const float* const> planes, std::size_t count, float* pixels) {
  HWY_DYNAMIC_DISPATCH(interleave)(planes.data(), planes.size(), count, pixels);
}

}  // namespace tristim::detail
#endif
