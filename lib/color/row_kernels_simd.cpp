#include "lib/color/row_kernels.h"

#include <vector>

// Nothing older than SSE4 has what these need: it takes the emulation, which is slow and exact.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lib/color/row_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "lib/color/row_formulas-inl.h"

HWY_BEFORE_NAMESPACE();
namespace tristim::detail::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

// Without vectors: the definition.
RowKernels vector_kernels() { return scalar_row_kernels(); }

#else

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;
using Floats = hn::Rebind<float, Doubles>;
using WholeFloats = hn::Repartition<float, Doubles>;
using Bits = hn::RebindToUnsigned<Doubles>;

struct WideMask {
  hn::Mask<Doubles> m;
};

// As many doubles as a vector has, with the operations of row_lanes.h.
struct Wide {
  hn::Vec<Doubles> v;
  HWY_INLINE explicit Wide(hn::Vec<Doubles> vector) : v(vector) {}
  HWY_INLINE explicit Wide(double x) : v(hn::Set(Doubles(), x)) {}
};

HWY_INLINE Wide operator+(Wide a, Wide b) { return Wide(hn::Add(a.v, b.v)); }
HWY_INLINE Wide operator-(Wide a, Wide b) { return Wide(hn::Sub(a.v, b.v)); }
HWY_INLINE Wide operator*(Wide a, Wide b) { return Wide(hn::Mul(a.v, b.v)); }
HWY_INLINE Wide operator/(Wide a, Wide b) { return Wide(hn::Div(a.v, b.v)); }
HWY_INLINE WideMask operator<(Wide a, Wide b) { return {hn::Lt(a.v, b.v)}; }
HWY_INLINE WideMask operator>(Wide a, Wide b) { return {hn::Gt(a.v, b.v)}; }
HWY_INLINE WideMask operator<=(Wide a, Wide b) { return {hn::Le(a.v, b.v)}; }
HWY_INLINE WideMask operator>=(Wide a, Wide b) { return {hn::Ge(a.v, b.v)}; }
HWY_INLINE WideMask operator==(Wide a, Wide b) { return {hn::Eq(a.v, b.v)}; }
HWY_INLINE WideMask operator&(WideMask a, WideMask b) { return {hn::And(a.m, b.m)}; }
HWY_INLINE WideMask operator!(WideMask a) { return {hn::Not(a.m)}; }
HWY_INLINE WideMask operator|(WideMask a, WideMask b) { return {hn::Or(a.m, b.m)}; }

HWY_INLINE Wide select(WideMask mask, Wide yes, Wide no) {
  return Wide(hn::IfThenElse(mask.m, yes.v, no.v));
}
// not Ne, which calls NaN equal to itself on some instruction sets
HWY_INLINE WideMask is_nan(Wide x) { return {hn::Not(hn::Eq(x.v, x.v))}; }
HWY_INLINE bool any(WideMask mask) { return !hn::AllFalse(Doubles(), mask.m); }
HWY_INLINE Wide magnitude(Wide x) { return Wide(hn::Abs(x.v)); }
HWY_INLINE Wide with_sign_of(Wide magnitude, Wide x) {
  return Wide(hn::CopySign(magnitude.v, x.v));
}
HWY_INLINE Wide root(Wide x) { return Wide(hn::Sqrt(x.v)); }
HWY_INLINE Wide whole_part(Wide x) { return Wide(hn::Trunc(x.v)); }
HWY_INLINE Wide larger(Wide a, Wide b) { return select(a > b, a, b); }
HWY_INLINE Wide smaller(Wide a, Wide b) { return select(a < b, a, b); }

HWY_INLINE hn::Vec<Bits> bits_of(Wide x) { return hn::BitCast(Bits(), x.v); }
HWY_INLINE hn::Vec<Bits> bits(std::uint64_t x) { return hn::Set(Bits(), x); }
HWY_INLINE Wide from_bits(hn::Vec<Bits> x) { return Wide(hn::BitCast(Doubles(), x)); }

HWY_INLINE MantissaExponent<Wide> split(Wide x) {
  const auto shifted = hn::Add(bits_of(x), bits(kOneBits - kHalfRootBits));
  return {from_bits(hn::Add(hn::And(shifted, bits(kMantissaMask)), bits(kHalfRootBits))),
          from_bits(hn::Or(hn::ShiftRight<52>(shifted), bits(kWholeBits))) - Wide(0x1p52 + 1023)};
}

HWY_INLINE Wide power_of_2(Wide n) {
  return from_bits(hn::ShiftLeft<52>(bits_of(n + Wide(kRoundToWhole + 1023))));
}

HWY_INLINE Wide inverse_cube_root_guess(Wide x) {
  const Wide whole = from_bits(hn::Or(hn::ShiftRight<20>(bits_of(x)), bits(kWholeBits)));
  const Wide third = (whole - Wide(0x1p52)) * Wide(1.0 / 3);
  return from_bits(hn::ShiftLeft<20>(bits_of((Wide(kInverseCubeRootBits) - third) + Wide(0x1p52))));
}

HWY_INLINE Wide where(WideMask mask, Wide x, Wide otherwise, double (*f)(double) noexcept) {
  if (!any(mask)) return otherwise;
  HWY_ALIGN double lanes[hn::MaxLanes(Doubles())];
  const Doubles d;
  hn::Store(select(mask, x, Wide(kNone)).v, d, lanes);
  for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
    if (lanes[i] == lanes[i]) lanes[i] = f(lanes[i]);
  }
  return select(mask, Wide(hn::Load(d, lanes)), otherwise);
}

struct VectorLanes {
  using W = Wide;
  static HWY_INLINE std::size_t count() { return hn::Lanes(Doubles()); }
  static HWY_INLINE Wide load(const double* from) { return Wide(hn::Load(Doubles(), from)); }
  static HWY_INLINE void store(Wide x, double* to) { hn::Store(x.v, Doubles(), to); }

  static HWY_INLINE Two<Three<Wide> > load_pixels(const float* in) {
    hn::Vec<WholeFloats> a, b, c;
    hn::LoadInterleaved3(WholeFloats(), in, a, b, c);
    return {{low(a), low(b), low(c)}, {high(a), high(b), high(c)}};
  }
  static HWY_INLINE void store_pixels(const Two<Three<Wide> >& x, float* out) {
    hn::StoreInterleaved3(whole(x.a.a, x.b.a), whole(x.a.b, x.b.b), whole(x.a.c, x.b.c),
                          WholeFloats(), out);
  }

  static void load_block(const float* in, RowChannels channels, std::size_t count,
                         RowBlock& block) {
    const std::size_t whole = count / VectorLanes::count() * VectorLanes::count();
    std::size_t i = 0;
    if (channels.components == 3 && channels.channels == 3) {
      for (; i < whole; i += VectorLanes::count()) {
        hn::Vec<Floats> a, b, c;
        hn::LoadInterleaved3(Floats(), in + 3 * i, a, b, c);
        load_colors(a, b, c, i, block);
        hn::Store(hn::Set(Doubles(), 1), Doubles(), &block.alpha[i]);
      }
    } else if (channels.components == 3 && channels.channels == 4) {
      for (; i < whole; i += VectorLanes::count()) {
        hn::Vec<Floats> a, b, c, alpha;
        hn::LoadInterleaved4(Floats(), in + 4 * i, a, b, c, alpha);
        load_colors(a, b, c, i, block);
        hn::Store(hn::PromoteTo(Doubles(), alpha), Doubles(), &block.alpha[i]);
      }
    }
    load_pixels_of(in, channels, i, count, block);  // the rest, and other numbers of channels
  }

  static void store_block(const RowBlock& block, RowChannels channels, std::size_t count,
                          float* out) {
    const std::size_t whole = count / VectorLanes::count() * VectorLanes::count();
    std::size_t i = 0;
    if (channels.components == 3 && channels.channels == 3) {
      for (; i < whole; i += VectorLanes::count()) {
        hn::StoreInterleaved3(floats(block, 0, i), floats(block, 1, i), floats(block, 2, i),
                              Floats(), out + 3 * i);
      }
    } else if (channels.components == 3 && channels.channels == 4) {
      for (; i < whole; i += VectorLanes::count()) {
        hn::StoreInterleaved4(floats(block, 0, i), floats(block, 1, i), floats(block, 2, i),
                              hn::DemoteTo(Floats(), hn::Load(Doubles(), &block.alpha[i])),
                              Floats(), out + 4 * i);
      }
    }
    store_pixels_of(block, channels, i, count, out);
  }

 private:
  // The halves of a vector of floats, and one of two halves.
  static HWY_INLINE Wide low(hn::Vec<WholeFloats> x) {
    return Wide(hn::PromoteTo(Doubles(), hn::LowerHalf(Floats(), x)));
  }
  static HWY_INLINE Wide high(hn::Vec<WholeFloats> x) {
    return Wide(hn::PromoteTo(Doubles(), hn::UpperHalf(Floats(), x)));
  }
  static HWY_INLINE hn::Vec<WholeFloats> whole(Wide low, Wide high) {
    return hn::Combine(WholeFloats(), hn::DemoteTo(Floats(), high.v),
                       hn::DemoteTo(Floats(), low.v));
  }

  static HWY_INLINE void load_colors(hn::Vec<Floats> a, hn::Vec<Floats> b, hn::Vec<Floats> c,
                                     std::size_t i, RowBlock& block) {
    const Wide x(hn::PromoteTo(Doubles(), a));
    const Wide y(hn::PromoteTo(Doubles(), b));
    const Wide z(hn::PromoteTo(Doubles(), c));
    const Wide sum = (x + y) + z;
    store(x, &block.plane[0][i]);
    store(y, &block.plane[1][i]);
    store(z, &block.plane[2][i]);
    store(sum - sum, &block.undefined[i]);
  }

  static HWY_INLINE hn::Vec<Floats> floats(const RowBlock& block, std::size_t channel,
                                           std::size_t i) {
    const Wide x = load(&block.plane[channel][i]);
    return hn::DemoteTo(Floats(), select(x == x, x, load(&block.undefined[i])).v);
  }
};

RowKernels vector_kernels() { return all_kernels<VectorLanes>(hwy::TargetName(HWY_TARGET)); }

#endif

}  // namespace tristim::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tristim::detail {
namespace {

HWY_EXPORT(vector_kernels);

std::vector<RowKernels> kernels_of_this_processor() {
  std::vector<RowKernels> all;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    if (target == HWY_SCALAR || target == HWY_EMU128) continue;  // ours is the definition
#if (HWY_TARGETS & (HWY_TARGETS - 1)) == 0
    all.push_back(HWY_DYNAMIC_DISPATCH(vector_kernels)());
#else
    hwy::ChosenTarget chosen;  // of our own: the process-wide choice stays as it is
    chosen.Update(target);
    all.push_back(HWY_DISPATCH_TABLE(vector_kernels)[chosen.GetIndex()]());
#endif
    if (all.back().name == "AVX3") all.back().name = "avx512";
  }
  return all;
}

}  // namespace

std::span<const RowKernels> simd_row_kernels() {
  static const std::vector<RowKernels> kernels = kernels_of_this_processor();
  return kernels;
}

}  // namespace tristim::detail
#endif
