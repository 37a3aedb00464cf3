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

#include "lib/dither/level_guess-inl.h"
#include "lib/dither/step_table-inl.h"

struct LookedUp {
  const StepTable* table;
  HWY_INLINE hn::Vec<Words> operator()(const float* in) const {
    return step_counts(*table, hn::LoadU(Floats(), in));
  }
};

#if TRISTIM_GUESSES
template <bool kOctaves>
struct GuessedFirst {
  const StepTable* table;
  GuessedCounts<kOctaves, false> guess{*table->guess};
  HWY_INLINE hn::Vec<Words> operator()(const float* in) const {
    const Floats f;
    const auto held = hn::Max(hn::LoadU(f, in), hn::Zero(f));  // NaN: 0
    hn::Vec<Words> found;
    const auto light = hn::Min(held, hn::Set(f, table->guess->highest));
    return HWY_LIKELY(guess(light, found)) ? found : step_counts(*table, held);
  }
};
#endif

template <bool kCodesCount, class Find>
HWY_INLINE void codes_of_row(const StepTable& table, Find find, const float* in, std::size_t count,
                             std::uint16_t* out) {
  const std::size_t lanes = hn::Lanes(Floats());
  const auto first = hn::Set(Codes(), static_cast<std::uint16_t>(table.codes[0]));
  const auto last_bits = [](hn::Vec<Words> word) {
    return hn::TruncateTo(Codes(), hn::BitCast(Bits(), word));
  };
  std::size_t x = 0;
  for (; x + lanes <= count; x += lanes) {
    const auto found = find(in + x);
    const auto low = hn::And(found, hn::Set(Words(), 0xFFFF));
    const auto code = kCodesCount ? last_bits(found) + first
                                  : last_bits(hn::GatherIndex(Words(), table.codes.data(), low));
    hn::StoreU(code, Codes(), out + x);
  }
  for (; x < count; ++x) out[x] = table(in[x]);
}

template <class Find>
void row_by(const StepTable& table, Find find, const float* in, std::size_t count,
            std::uint16_t* out) {
  if (table.codes_count) return codes_of_row<true>(table, find, in, count, out);
  codes_of_row<false>(table, find, in, count, out);
}

void row(const StepTable& table, const float* in, std::size_t count, std::uint16_t* out) {
#if TRISTIM_GUESSES
  if (table.guess) {
    if (table.guess->octaves()) return row_by(table, GuessedFirst<true>{&table}, in, count, out);
    return row_by(table, GuessedFirst<false>{&table}, in, count, out);
  }
#endif
  row_by(table, LookedUp{&table}, in, count, out);
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
