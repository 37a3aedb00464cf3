// The rows of step_table.cpp in vectors, for each instruction set.
// Nothing older than SSE4 has what these need: it takes the definition.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lib/dither/step_table_simd.cpp"
// clang-format off: foreach_target.h comes before highway.h
#include <hwy/foreach_target.h>
// clang-format on
#include <hwy/highway.h>

#include "lib/core/every_target.h"
#include "lib/dither/step_table.h"

HWY_BEFORE_NAMESPACE();
namespace tristim::detail::steps::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

StepKernel vector_kernel() { return scalar_step_kernel(); }

#else

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Words = hn::RebindToSigned<Floats>;
using Bits = hn::RebindToUnsigned<Floats>;
using Codes = hn::Rebind<std::uint16_t, Floats>;

HWY_INLINE hn::Vec<Words> counts(const StepTable& table, const float* in) {
  const Words w;
  const auto light = hn::LoadU(Floats(), in);
  const auto positive = hn::IfThenElseZero(light > hn::Zero(Floats()), light);
  const auto first = hn::Set(w, table.first);
  const auto bits = hn::Min(hn::Max(hn::BitCast(w, positive), first), hn::Set(w, table.last));
  const auto stretch = hn::ShiftRightSame(bits - first, table.shift);
  const auto entry =
      hn::GatherIndex(w, reinterpret_cast<const std::int32_t*>(table.entry.data()), stretch);
  const auto low = hn::And(bits, hn::Set(w, (std::int32_t{1} << table.shift) - 1));
  const auto sum = hn::BitCast(Bits(), entry + low);
  return hn::BitCast(w, hn::ShiftRightSame(sum, table.shift));
}

template <bool kCodesCount>
void codes_of_row(const StepTable& table, const float* in, std::size_t count, std::uint16_t* out) {
  const std::size_t lanes = hn::Lanes(Floats());
  const auto first = hn::Set(Words(), table.codes[0]);
  std::size_t x = 0;
  for (; x + lanes <= count; x += lanes) {
    const auto found = counts(table, in + x);
    const auto code =
        kCodesCount ? found + first : hn::GatherIndex(Words(), table.codes.data(), found);
    hn::StoreU(hn::DemoteTo(Codes(), code), Codes(), out + x);
  }
  for (; x < count; ++x) out[x] = table(in[x]);
}

void row(const StepTable& table, const float* in, std::size_t count, std::uint16_t* out) {
  const auto kernel = table.codes_count ? codes_of_row<true> : codes_of_row<false>;
  kernel(table, in, count, out);
}

StepKernel vector_kernel() { return {hwy::TargetName(HWY_TARGET), row}; }

#endif

}  // namespace tristim::detail::steps::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tristim::detail {
namespace steps {
namespace {

HWY_EXPORT(vector_kernel);

}  // namespace
}  // namespace steps

std::span<const StepKernel> simd_step_kernels() {
  static const std::vector<StepKernel> kernels =
      of_every_target(steps::HWY_DISPATCH_TABLE(vector_kernel));
  return kernels;
}

}  // namespace tristim::detail
#endif
