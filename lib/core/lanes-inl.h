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
using Float = hn::Vec<FloatTag>;
using Double = hn::Vec<DoubleTag>;

// Two vectors, or pairs of them, that take each step together: a formula is a long chain of
// operations that wait for each other, but not for those of the other half.
template <class V>
struct Pair {
  V low, high;
};
using Floats = Pair<Float>;
using Doubles = Pair<Pair<Double> >;  // as many as there are floats in Floats

template <class V>
HWY_INLINE Pair<V> operator+(Pair<V> a, Pair<V> b) {
  return {a.low + b.low, a.high + b.high};
}
template <class V>
HWY_INLINE Pair<V> operator-(Pair<V> a, Pair<V> b) {
  return {a.low - b.low, a.high - b.high};
}
template <class V>
HWY_INLINE Pair<V> operator*(Pair<V> a, Pair<V> b) {
  return {a.low * b.low, a.high * b.high};
}
template <class V>
HWY_INLINE Pair<V> operator/(Pair<V> a, Pair<V> b) {
  return {a.low / b.low, a.high / b.high};
}

// What operators do not say: of one vector, then of pairs.

template <class V>
HWY_INLINE V lesser(V a, V b) {
  return hn::Min(a, b);
}
template <class V>
HWY_INLINE Pair<V> lesser(Pair<V> a, Pair<V> b) {
  return {lesser(a.low, b.low), lesser(a.high, b.high)};
}

template <class V>
HWY_INLINE V greater(V a, V b) {
  return hn::Max(a, b);
}
template <class V>
HWY_INLINE Pair<V> greater(Pair<V> a, Pair<V> b) {
  return {greater(a.low, b.low), greater(a.high, b.high)};
}

template <class V>
HWY_INLINE V square_root(V x) {
  return hn::Sqrt(x);
}
template <class V>
HWY_INLINE Pair<V> square_root(Pair<V> x) {
  return {square_root(x.low), square_root(x.high)};
}

template <class V>
HWY_INLINE V if_positive(V x, V yes, V no) {
  return hn::IfThenElse(x > hn::Zero(hn::DFromV<V>()), yes, no);
}
template <class V>
HWY_INLINE Pair<V> if_positive(Pair<V> x, Pair<V> yes, Pair<V> no) {
  return {if_positive(x.low, yes.low, no.low), if_positive(x.high, yes.high, no.high)};
}

HWY_INLINE Double scaled(Double a, Double b, Double& e) {
  const BitsTag tag;
  const auto bits = hn::BitCast(tag, a);
  const auto difference = bits - hn::BitCast(tag, b) + hn::Set(tag, std::uint64_t{1} << 51);
  const auto shift = hn::And(difference, hn::Set(tag, ~((std::uint64_t{1} << 52) - 1)));
  const auto above_zero = hn::ShiftRight<52>(shift + hn::Set(tag, std::uint64_t{1024} << 52));
  const auto magic = hn::BitCast(tag, hn::Set(DoubleTag(), 0x1p52));
  e = hn::BitCast(DoubleTag(), hn::Or(above_zero, magic)) - hn::Set(DoubleTag(), 0x1p52 + 1024);
  return hn::BitCast(DoubleTag(), bits - shift);
}
HWY_INLINE Float scaled(Float a, Float b, Float& e) {
  const IntTag tag;
  const auto bits = hn::BitCast(tag, a);
  const auto difference = bits - hn::BitCast(tag, b) + hn::Set(tag, 1 << 22);
  const auto shift = hn::And(difference, hn::Set(tag, -(1 << 23)));
  e = hn::ConvertTo(FloatTag(), hn::ShiftRight<23>(shift));
  return hn::BitCast(FloatTag(), bits - shift);
}
template <class V>
HWY_INLINE Pair<V> scaled(Pair<V> a, Pair<V> b, Pair<V>& e) {
  return {scaled(a.low, b.low, e.low), scaled(a.high, b.high, e.high)};
}

HWY_INLINE Pair<Double> loaded_wide(const float* from) {
  return {hn::PromoteTo(DoubleTag(), hn::LoadU(HalfTag(), from)),
          hn::PromoteTo(DoubleTag(), hn::LoadU(HalfTag(), from + hn::Lanes(HalfTag())))};
}
HWY_INLINE Pair<Double> widened(Float x) {
  return {hn::PromoteTo(DoubleTag(), hn::LowerHalf(HalfTag(), x)),
          hn::PromoteTo(DoubleTag(), hn::UpperHalf(HalfTag(), x))};
}
HWY_INLINE Float narrowed(Pair<Double> x) {
  return hn::Combine(FloatTag(), hn::DemoteTo(HalfTag(), x.high), hn::DemoteTo(HalfTag(), x.low));
}

HWY_INLINE Float raised_two(Float n) {
  // n in the last bits of a float; what is above them leaves on the left.
  const IntTag tag;
  const auto bits = hn::BitCast(tag, n + hn::Set(FloatTag(), 0x1.8p23F));
  return hn::BitCast(FloatTag(), hn::ShiftLeft<23>(bits + hn::Set(tag, 127)));
}

struct VectorLanes {
  using F = Floats;
  using D = Doubles;

  static HWY_INLINE std::size_t half() { return hn::Lanes(FloatTag()); }
  static HWY_INLINE std::size_t size() { return 2 * half(); }
  static HWY_INLINE F load(const float* from) {
    return {hn::LoadU(FloatTag(), from), hn::LoadU(FloatTag(), from + half())};
  }
  static HWY_INLINE void store(F x, float* to) {
    hn::StoreU(x.low, FloatTag(), to);
    hn::StoreU(x.high, FloatTag(), to + half());
  }
  static HWY_INLINE F f(float x) { return {hn::Set(FloatTag(), x), hn::Set(FloatTag(), x)}; }
  static HWY_INLINE D d(double x) {
    const Pair<Double> both{hn::Set(DoubleTag(), x), hn::Set(DoubleTag(), x)};
    return {both, both};
  }
  static HWY_INLINE D load_wide(const float* from) {
    return {loaded_wide(from), loaded_wide(from + half())};
  }
  static HWY_INLINE F narrow(D x) { return {narrowed(x.low), narrowed(x.high)}; }
  static HWY_INLINE D widen(F x) { return {widened(x.low), widened(x.high)}; }

  static HWY_INLINE F min(F a, F b) { return lesser(a, b); }
  static HWY_INLINE D min(D a, D b) { return lesser(a, b); }
  static HWY_INLINE F max(F a, F b) { return greater(a, b); }
  static HWY_INLINE D max(D a, D b) { return greater(a, b); }
  static HWY_INLINE F root(F x) { return square_root(x); }
  static HWY_INLINE F where_positive(F x, F yes, F no) { return if_positive(x, yes, no); }
  static HWY_INLINE D where_positive(D x, D yes, D no) { return if_positive(x, yes, no); }
  static HWY_INLINE F scale_near(F a, F b, F& e) { return scaled(a, b, e); }
  static HWY_INLINE D scale_near(D a, D b, D& e) { return scaled(a, b, e); }

  static HWY_INLINE F whole(F x) { return (x + f(0x1.8p23F)) - f(0x1.8p23F); }
  static HWY_INLINE D whole(D x) { return (x + d(0x1.8p52)) - d(0x1.8p52); }
  static HWY_INLINE F power_of_two(F n) { return {raised_two(n.low), raised_two(n.high)}; }
};
#endif
