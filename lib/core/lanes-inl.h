// ScalarLanes (lanes_scalar.h) in vectors of the processor at hand. Included inside of
// HWY_NAMESPACE by files that hwy/foreach_target.h includes, once for each instruction set.

#if HWY_TARGET == HWY_SCALAR
using VectorLanes = ScalarLanes;
#else

namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::ScalableTag<float>;
using HalfTag = hn::Half<FloatTag>;
using DoubleTag = hn::Rebind<double, HalfTag>;
using BitsTag = hn::RebindToUnsigned<DoubleTag>;
using IntTag = hn::RebindToSigned<FloatTag>;

// As many doubles as there are floats in a vector. Both halves take each step together: their
// chains of operations do not wait for each other.
struct Doubles {
  hn::Vec<DoubleTag> low, high;
};
HWY_INLINE Doubles operator+(Doubles a, Doubles b) { return {a.low + b.low, a.high + b.high}; }
HWY_INLINE Doubles operator-(Doubles a, Doubles b) { return {a.low - b.low, a.high - b.high}; }
HWY_INLINE Doubles operator*(Doubles a, Doubles b) { return {a.low * b.low, a.high * b.high}; }
HWY_INLINE Doubles operator/(Doubles a, Doubles b) { return {a.low / b.low, a.high / b.high}; }

struct VectorLanes {
  using F = hn::Vec<FloatTag>;
  using D = Doubles;

  static HWY_INLINE std::size_t size() { return hn::Lanes(FloatTag()); }
  static HWY_INLINE F load(const float* from) { return hn::LoadU(FloatTag(), from); }
  static HWY_INLINE void store(F x, float* to) { hn::StoreU(x, FloatTag(), to); }
  static HWY_INLINE F f(float x) { return hn::Set(FloatTag(), x); }
  static HWY_INLINE D d(double x) { return {hn::Set(DoubleTag(), x), hn::Set(DoubleTag(), x)}; }
  static HWY_INLINE D load_wide(const float* from) {
    return {hn::PromoteTo(DoubleTag(), hn::LoadU(HalfTag(), from)),
            hn::PromoteTo(DoubleTag(), hn::LoadU(HalfTag(), from + hn::Lanes(HalfTag())))};
  }
  static HWY_INLINE F narrow(D x) {
    return hn::Combine(FloatTag(), hn::DemoteTo(HalfTag(), x.high), hn::DemoteTo(HalfTag(), x.low));
  }

  static HWY_INLINE F min(F a, F b) { return hn::Min(a, b); }
  static HWY_INLINE D min(D a, D b) { return {hn::Min(a.low, b.low), hn::Min(a.high, b.high)}; }
  static HWY_INLINE F max(F a, F b) { return hn::Max(a, b); }
  static HWY_INLINE D max(D a, D b) { return {hn::Max(a.low, b.low), hn::Max(a.high, b.high)}; }
  static HWY_INLINE F root(F x) { return hn::Sqrt(x); }
  static HWY_INLINE D root(D x) { return {hn::Sqrt(x.low), hn::Sqrt(x.high)}; }

  static HWY_INLINE F where_positive(F x, F yes, F no) {
    return hn::IfThenElse(x > hn::Zero(FloatTag()), yes, no);
  }
  static HWY_INLINE D where_positive(D x, D yes, D no) {
    const auto zero = hn::Zero(DoubleTag());
    return {hn::IfThenElse(x.low > zero, yes.low, no.low),
            hn::IfThenElse(x.high > zero, yes.high, no.high)};
  }

  static HWY_INLINE hn::Vec<DoubleTag> scale_half(hn::Vec<DoubleTag> a, hn::Vec<DoubleTag> b,
                                                  hn::Vec<DoubleTag>& e) {
    const BitsTag tag;
    const auto bits = hn::BitCast(tag, a);
    const auto difference = bits - hn::BitCast(tag, b) + hn::Set(tag, std::uint64_t{1} << 51);
    const auto shift = hn::And(difference, hn::Set(tag, ~((std::uint64_t{1} << 52) - 1)));
    const auto above_zero = hn::ShiftRight<52>(shift + hn::Set(tag, std::uint64_t{1024} << 52));
    const auto magic = hn::BitCast(tag, hn::Set(DoubleTag(), 0x1p52));
    e = hn::BitCast(DoubleTag(), hn::Or(above_zero, magic)) - hn::Set(DoubleTag(), 0x1p52 + 1024);
    return hn::BitCast(DoubleTag(), bits - shift);
  }
  static HWY_INLINE D scale_near(D a, D b, D& e) {
    return {scale_half(a.low, b.low, e.low), scale_half(a.high, b.high, e.high)};
  }

  static HWY_INLINE F whole(F x) { return (x + f(0x1.8p23F)) - f(0x1.8p23F); }
  static HWY_INLINE D whole(D x) { return (x + d(0x1.8p52)) - d(0x1.8p52); }

  static HWY_INLINE F power_of_two(F n) {
    const IntTag tag;
    return hn::BitCast(FloatTag(), hn::ShiftLeft<23>(hn::ConvertTo(tag, n) + hn::Set(tag, 127)));
  }
};
#endif
