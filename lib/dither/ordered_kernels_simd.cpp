// The rows of ordered_kernels.cpp in vectors, for each instruction set.
// Nothing older than SSE4 has what these need: it takes the emulation.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lib/dither/ordered_kernels_simd.cpp"
// clang-format off: foreach_target.h comes before highway.h
#include <hwy/foreach_target.h>
// clang-format on
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <vector>

#include "lib/core/every_target.h"
#include "lib/dither/ordered_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace tristim::detail::ordered::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

// Without vectors: the definition.
OrderedKernels vector_kernels() { return scalar_ordered_kernels(); }

#else

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Words = hn::RebindToSigned<Floats>;
using Bits = hn::RebindToUnsigned<Floats>;
using Codes = hn::Rebind<std::uint16_t, Floats>;
using HalfWords = hn::Half<Words>;
using Wide = hn::Repartition<std::int64_t, Words>;
using WideBits = hn::RebindToUnsigned<Wide>;
using Float = hn::Vec<Floats>;
using Word = hn::Vec<Words>;

// As the scalar code's comparisons: the second where one of them is NaN.
#if HWY_ARCH_X86  // one instruction
HWY_INLINE Float larger(Float a, Float b) { return hn::Max(a, b); }
HWY_INLINE Float smaller(Float a, Float b) { return hn::Min(a, b); }
#else
HWY_INLINE Float larger(Float a, Float b) { return hn::IfThenElse(a > b, a, b); }
HWY_INLINE Float smaller(Float a, Float b) { return hn::IfThenElse(a < b, a, b); }
#endif

#include "lib/dither/level_guess-inl.h"

struct Mixing {
  Word lower;
  Float steps;
};

struct WordPair {
  Word first, second;
};

// The two 32-bit members of the structures that `index` counts.
HWY_INLINE WordPair gather_pairs(const void* structures, Word index) {
  const auto* base = static_cast<const std::uint64_t*>(structures);
  const auto low =
      hn::GatherIndex(WideBits(), base, hn::PromoteTo(Wide(), hn::LowerHalf(HalfWords(), index)));
  const auto high =
      hn::GatherIndex(WideBits(), base, hn::PromoteTo(Wide(), hn::UpperHalf(HalfWords(), index)));
  const auto a = hn::BitCast(Words(), low);
  const auto b = hn::BitCast(Words(), high);
  return {hn::ConcatEven(Words(), b, a), hn::ConcatOdd(Words(), b, a)};
}

// The ways of ordered_kernels.cpp's mixing().

struct TwoLevels {
  const OrderedLevels* levels;
  HWY_INLINE Mixing operator()(Float light) const {
    const Float along = light - hn::Set(Floats(), levels->lowest);
    return {hn::Zero(Words()), along * hn::Set(Floats(), levels->ranks_per_light)};
  }
};

struct EvenLevels {
  const OrderedLevels* levels;
  HWY_INLINE Mixing operator()(Float light) const {
    const Floats f;
    const Float along = (light - hn::Set(f, levels->lowest)) * hn::Set(f, levels->levels_per_light);
    const Float held = smaller(larger(along, hn::Zero(f)), hn::Set(f, levels->last));
    const Word lower = hn::ConvertTo(Words(), held);
    return {lower, (held - hn::ConvertTo(f, lower)) * hn::Set(f, levels->ranks)};
  }
};

HWY_INLINE Float held_inside(const OrderedLevels& levels, Float light) {
  const Floats f;
  return smaller(larger(light, hn::Set(f, levels.lowest)), hn::Set(f, levels.highest));
}

struct FewLevels {
  const OrderedLevels* levels;
  HWY_INLINE Mixing operator()(Float light) const {
    const Floats f;
    const Float held = held_inside(*levels, light);
    Word lower = hn::Zero(Words());
    Float base = hn::Set(f, levels->levels[0].light);
    Float ranks_per_light = hn::Set(f, levels->levels[0].ranks_per_light);
    for (std::size_t i = 1; i < levels->levels.size(); ++i) {
      const OrderedLevels::Level& level = levels->levels[i];
      const auto above = held >= hn::Set(f, level.light);
      lower = lower - hn::VecFromMask(Words(), hn::RebindMask(Words(), above));
      base = hn::IfThenElse(above, hn::Set(f, level.light), base);
      ranks_per_light = hn::IfThenElse(above, hn::Set(f, level.ranks_per_light), ranks_per_light);
    }
    return {lower, (held - base) * ranks_per_light};
  }
};

struct LevelsInBins {
  const OrderedLevels* levels;
  HWY_INLINE Mixing operator()(Float light) const {
    const Floats f;
    const Words w;
    const Float held = held_inside(*levels, light);
    const Word bits = hn::ShiftRightSame(hn::BitCast(w, held), levels->shift);
    const Word bin = hn::Max(bits - hn::Set(w, levels->first_bin), hn::Zero(w));
    const WordPair found = gather_pairs(levels->bins.data(), bin);
    const auto above = hn::RebindMask(w, held >= hn::BitCast(f, found.first));
    const Word lower = found.second - hn::VecFromMask(w, above);  // a mask's lane is -1
    const WordPair level = gather_pairs(levels->levels.data(), lower);
    return {lower, (held - hn::BitCast(f, level.first)) * hn::BitCast(f, level.second)};
  }
};

// The level taken of the two that a light is mixed of.
template <class Find>
struct Mixed {
  Find find;
  const OrderedLevels* levels = find.levels;
  HWY_INLINE Word operator()(Float light, Float least) const {
    const Mixing mix = find(light);
    return mix.lower - hn::VecFromMask(Words(), hn::RebindMask(Words(), mix.steps >= least));
  }
};

#if TRISTIM_GUESSES
template <bool kOctaves>
struct GuessedFirst {
  const OrderedLevels* levels;
  Mixed<LevelsInBins> exact{{levels}};
  GuessedCounts<kOctaves, true> guess{*levels->guess};
  HWY_INLINE Word operator()(Float light, Float least) const {
    const Floats f;
    const Float held =
        smaller(larger(light, hn::Set(f, levels->lowest)), hn::Set(f, levels->guess->highest));
    Word level;
    const Float fraction = least * hn::Set(f, 1 / levels->ranks);
    return HWY_LIKELY(guess(held, level, fraction)) ? level : exact(light, least);
  }
};
#endif

// Goes round a row of the matrix.
class Leasts {
 public:
  explicit Leasts(const OrderedRow& row) : row_(&row), column_(row.column) {}

  HWY_INLINE Float next() {
    const auto least = hn::LoadU(Floats(), row_->least + column_);
    column_ += hn::Lanes(Floats());
    if (column_ >= row_->period) column_ -= row_->period;
    return least;
  }

 private:
  const OrderedRow* row_;
  std::size_t column_;
};

HWY_INLINE Float drawn_to_middle(Float least, Float middle, Float strength) {
  return middle + (least - middle) * strength;
}

// Of levels in the last 16 bits.
HWY_INLINE hn::Vec<Codes> codes_of(const OrderedLevels& levels, Word level) {
  const Words w;
  const auto last_bits = [](Word word) {
    return hn::TruncateTo(Codes(), hn::BitCast(Bits(), word));
  };
  const std::int32_t* codes = levels.codes.data();
  if (levels.codes_count) {
    return last_bits(level) + hn::Set(Codes(), static_cast<std::uint16_t>(codes[0]));
  }
  return last_bits(hn::GatherIndex(w, codes, hn::And(level, hn::Set(w, 0xFFFF))));
}

// One vector of pixels. `strength` may be null.
template <class Find>
HWY_INLINE void reduce(Find find, Leasts& leasts, const float* in, const float* strength,
                       std::uint16_t* out) {
  const Floats f;
  const OrderedLevels& levels = *find.levels;
  Float least = leasts.next();
  if (strength != nullptr) {
    least = drawn_to_middle(least, hn::Set(f, levels.ranks * 0.5F), hn::LoadU(f, strength));
  }
  hn::StoreU(codes_of(levels, find(hn::LoadU(f, in), least)), Codes(), out);
}

template <class Find>
void reduce_row(Find find, const OrderedRow& row, const float* in, const float* strength,
                std::size_t count, std::uint16_t* out) {
  const std::size_t lanes = hn::Lanes(Floats());
  Leasts leasts(row);
  std::size_t x = 0;
  if (strength == nullptr) {
    for (; x + lanes <= count; x += lanes) reduce(find, leasts, in + x, nullptr, out + x);
  } else {
    for (; x + lanes <= count; x += lanes) reduce(find, leasts, in + x, strength + x, out + x);
  }
  if (x == count) return;
  std::array<float, kMostLanes> rest{};
  std::array<float, kMostLanes> rest_strength{};
  std::array<std::uint16_t, kMostLanes> rest_out{};
  std::copy(in + x, in + count, rest.begin());
  if (strength != nullptr) std::copy(strength + x, strength + count, rest_strength.begin());
  reduce(find, leasts, rest.data(), strength == nullptr ? nullptr : rest_strength.data(),
         rest_out.data());
  std::copy_n(rest_out.begin(), count - x, out + x);
}

void row_of(const OrderedRow& row, const float* in, const float* strength, std::size_t count,
            std::uint16_t* out) {
  const OrderedLevels* levels = row.levels;
  const auto by = [&](auto find) { reduce_row(find, row, in, strength, count, out); };
#if TRISTIM_GUESSES
  if (levels->guess && levels->guess->octaves()) return by(GuessedFirst<true>{levels});
  if (levels->guess) return by(GuessedFirst<false>{levels});
#endif
  switch (levels->way) {
    case LevelsWay::kTwo:
      return by(Mixed<TwoLevels>{{levels}});
    case LevelsWay::kEven:
      return by(Mixed<EvenLevels>{{levels}});
    case LevelsWay::kFew:
      return by(Mixed<FewLevels>{{levels}});
    case LevelsWay::kBins:
      return by(Mixed<LevelsInBins>{{levels}});
    case LevelsWay::kSearch:
      return scalar_ordered_kernels().row(row, in, strength, count, out);
  }
}

OrderedKernels vector_kernels() { return {hwy::TargetName(HWY_TARGET), row_of}; }

#endif

}  // namespace tristim::detail::ordered::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tristim::detail {
namespace ordered {
namespace {

HWY_EXPORT(vector_kernels);

}  // namespace
}  // namespace ordered

std::span<const OrderedKernels> simd_ordered_kernels() {
  static const std::vector<OrderedKernels> kernels =
      of_every_target(ordered::HWY_DISPATCH_TABLE(vector_kernels));
  return kernels;
}

}  // namespace tristim::detail
#endif
