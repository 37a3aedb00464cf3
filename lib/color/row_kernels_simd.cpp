#include "lib/color/row_kernels.h"

#include <vector>

// Nothing older than SSE4 has what these need: it takes the emulation, which is slow and exact.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lib/color/row_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "lib/color/row_formulas-inl.h"
#include "lib/core/every_target.h"

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
using FloatBits = hn::RebindToUnsigned<WholeFloats>;

template <typename T>
struct MaskOf {
  hn::Mask<hn::ScalableTag<T> > m;
};

// As many numbers as a vector has, with the operations of row_lanes.h.
template <typename T>
struct VectorOf {
  using Tag = hn::ScalableTag<T>;
  hn::Vec<Tag> v;
  HWY_INLINE explicit VectorOf(hn::Vec<Tag> vector) : v(vector) {}
  HWY_INLINE explicit VectorOf(double x) : v(hn::Set(Tag(), static_cast<T>(x))) {}
};
using Wide = VectorOf<double>;
using Narrow = VectorOf<float>;

#define TRISTIM_LANEWISE(result, name, function)            \
  template <typename T>                                     \
  HWY_INLINE result<T> name(VectorOf<T> a, VectorOf<T> b) { \
    return result<T>{hn::function(a.v, b.v)};               \
  }
TRISTIM_LANEWISE(VectorOf, operator+, Add)
TRISTIM_LANEWISE(VectorOf, operator-, Sub)
TRISTIM_LANEWISE(VectorOf, operator*, Mul)
TRISTIM_LANEWISE(VectorOf, operator/, Div)
TRISTIM_LANEWISE(VectorOf, with_sign_of, CopySign)
TRISTIM_LANEWISE(MaskOf, operator<, Lt)
TRISTIM_LANEWISE(MaskOf, operator>, Gt)
TRISTIM_LANEWISE(MaskOf, operator<=, Le)
TRISTIM_LANEWISE(MaskOf, operator>=, Ge)
TRISTIM_LANEWISE(MaskOf, operator==, Eq)
#undef TRISTIM_LANEWISE

template <typename T>
HWY_INLINE MaskOf<T> operator&(MaskOf<T> a, MaskOf<T> b) {
  return {hn::And(a.m, b.m)};
}
template <typename T>
HWY_INLINE MaskOf<T> operator|(MaskOf<T> a, MaskOf<T> b) {
  return {hn::Or(a.m, b.m)};
}
template <typename T>
HWY_INLINE MaskOf<T> operator!(MaskOf<T> a) {
  return {hn::Not(a.m)};
}
template <typename T>
HWY_INLINE VectorOf<T> select(MaskOf<T> mask, VectorOf<T> yes, VectorOf<T> no) {
  return VectorOf<T>(hn::IfThenElse(mask.m, yes.v, no.v));
}
// not Ne, which calls NaN equal to itself on some instruction sets
template <typename T>
HWY_INLINE MaskOf<T> is_nan(VectorOf<T> x) {
  return {hn::Not(hn::Eq(x.v, x.v))};
}
template <typename T>
HWY_INLINE bool any(MaskOf<T> mask) {
  return !hn::AllFalse(hn::ScalableTag<T>(), mask.m);
}
template <typename T>
HWY_INLINE VectorOf<T> magnitude(VectorOf<T> x) {
  return VectorOf<T>(hn::Abs(x.v));
}
HWY_INLINE Wide root(Wide x) { return Wide(hn::Sqrt(x.v)); }
HWY_INLINE Wide whole_part(Wide x) { return Wide(hn::Trunc(x.v)); }
template <typename T>
HWY_INLINE VectorOf<T> larger(VectorOf<T> a, VectorOf<T> b) {
  return select(a > b, a, b);
}
template <typename T>
HWY_INLINE VectorOf<T> smaller(VectorOf<T> a, VectorOf<T> b) {
  return select(a < b, a, b);
}

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

HWY_INLINE hn::Vec<FloatBits> bits_of(Narrow x) { return hn::BitCast(FloatBits(), x.v); }
HWY_INLINE hn::Vec<FloatBits> float_bits(std::uint32_t x) { return hn::Set(FloatBits(), x); }
HWY_INLINE Narrow from_bits(hn::Vec<FloatBits> x) { return Narrow(hn::BitCast(WholeFloats(), x)); }

HWY_INLINE Narrow inverse_cube_root_guess(Narrow x) {
  const Narrow whole =
      from_bits(hn::Or(hn::ShiftRight<8>(bits_of(x)), float_bits(kWholeFloatBits)));
  return from_bits(hn::ShiftLeft<8>(bits_of(Narrow(kFloatCubeRootBits) - whole * Narrow(1.0 / 3))));
}

HWY_INLINE Narrow to_8_digits(Narrow x) {
  const auto up = hn::Add(bits_of(x), float_bits(kHalfOf8Digits));
  return from_bits(hn::And(up, float_bits(k8DigitsMask)));
}

// The halves of a vector of floats, and one of two halves.
HWY_INLINE Wide low(Narrow x) {
  return Wide(hn::PromoteTo(Doubles(), hn::LowerHalf(Floats(), x.v)));
}
HWY_INLINE Wide high(Narrow x) {
  return Wide(hn::PromoteTo(Doubles(), hn::UpperHalf(Floats(), x.v)));
}
HWY_INLINE Narrow whole(Wide low, Wide high) {
  return Narrow(
      hn::Combine(WholeFloats(), hn::DemoteTo(Floats(), high.v), hn::DemoteTo(Floats(), low.v)));
}

template <typename F, typename... X>
HWY_INLINE Three<Narrow> in_double(F&& f, X... x) {
  const Three<Wide> a = f(low(x)...);
  const Three<Wide> b = f(high(x)...);
  return {whole(a.a, b.a), whole(a.b, b.b), whole(a.c, b.c)};
}

HWY_INLINE Wide where(MaskOf<double> mask, Wide x, Wide otherwise, double (*f)(double) noexcept) {
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

  static HWY_INLINE std::size_t pixels() { return hn::Lanes(WholeFloats()); }
  static HWY_INLINE Three<Narrow> load_pixels(const float* in) {
    hn::Vec<WholeFloats> a, b, c;
    hn::LoadInterleaved3(WholeFloats(), in, a, b, c);
    return {Narrow(a), Narrow(b), Narrow(c)};
  }
  static HWY_INLINE void store_pixels(const Three<Narrow>& x, float* out) {
    hn::StoreInterleaved3(x.a.v, x.b.v, x.c.v, WholeFloats(), out);
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

}  // namespace

std::span<const RowKernels> simd_row_kernels() {
  static const std::vector<RowKernels> kernels =
      of_every_target(HWY_DISPATCH_TABLE(vector_kernels));
  return kernels;
}

}  // namespace tristim::detail
#endif
