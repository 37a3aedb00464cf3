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
// operations that wait for each other, but not for those of the other half. Four vectors are about
// as many as a processor overlaps.
template <class V>
struct Pair {
  V low, high;
};
using Floats = Pair<Pair<Float> >;
using Doubles = Pair<Pair<Pair<Double> > >;  // as many as there are floats in Floats

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

// Between memory, floats and doubles. Results are arguments: they tell how many lanes there are.

HWY_INLINE std::size_t lanes_of(const Float&) { return hn::Lanes(FloatTag()); }
HWY_INLINE std::size_t lanes_of(const Double&) { return hn::Lanes(DoubleTag()); }
template <class V>
HWY_INLINE std::size_t lanes_of(const Pair<V>& x) {
  return 2 * lanes_of(x.low);
}

HWY_INLINE void set(float value, Float& x) { x = hn::Set(FloatTag(), value); }
HWY_INLINE void set(double value, Double& x) { x = hn::Set(DoubleTag(), value); }
template <class T, class V>
HWY_INLINE void set(T value, Pair<V>& x) {
  set(value, x.low);
  set(value, x.high);
}

HWY_INLINE void load_lanes(const float* from, Float& x) { x = hn::LoadU(FloatTag(), from); }
HWY_INLINE void load_lanes(const float* from, Double& x) {
  x = hn::PromoteTo(DoubleTag(), hn::LoadU(HalfTag(), from));
}
HWY_INLINE void load_lanes(const double* from, Double& x) { x = hn::LoadU(DoubleTag(), from); }
template <class T, class V>
HWY_INLINE void load_lanes(const T* from, Pair<V>& x) {
  load_lanes(from, x.low);
  load_lanes(from + lanes_of(x.low), x.high);
}

HWY_INLINE void store_lanes(Float x, float* to) { hn::StoreU(x, FloatTag(), to); }
template <class V>
HWY_INLINE void store_lanes(Pair<V> x, float* to) {
  store_lanes(x.low, to);
  store_lanes(x.high, to + lanes_of(x.low));
}

HWY_INLINE void narrow_lanes(Pair<Double> x, Float& to) {
  to = hn::Combine(FloatTag(), hn::DemoteTo(HalfTag(), x.high), hn::DemoteTo(HalfTag(), x.low));
}
template <class D, class F>
HWY_INLINE void narrow_lanes(Pair<D> x, Pair<F>& to) {
  narrow_lanes(x.low, to.low);
  narrow_lanes(x.high, to.high);
}

HWY_INLINE void widen_lanes(Float x, Pair<Double>& to) {
  to.low = hn::PromoteTo(DoubleTag(), hn::LowerHalf(HalfTag(), x));
  to.high = hn::PromoteTo(DoubleTag(), hn::UpperHalf(HalfTag(), x));
}
template <class F, class D>
HWY_INLINE void widen_lanes(Pair<F> x, Pair<D>& to) {
  widen_lanes(x.low, to.low);
  widen_lanes(x.high, to.high);
}

HWY_INLINE Float two_to(Float n) {
  // n in the last bits of a float; what is above them leaves on the left.
  const IntTag tag;
  const auto bits = hn::BitCast(tag, n + hn::Set(FloatTag(), 0x1.8p23F));
  return hn::BitCast(FloatTag(), hn::ShiftLeft<23>(bits + hn::Set(tag, 127)));
}
template <class V>
HWY_INLINE Pair<V> two_to(Pair<V> n) {
  return {two_to(n.low), two_to(n.high)};
}

struct VectorLanes {
  using F = Floats;
  using D = Doubles;

  static constexpr std::size_t kVectors = sizeof(Floats) / sizeof(Float);
  static HWY_INLINE std::size_t size() { return kVectors * hn::Lanes(FloatTag()); }

  static HWY_INLINE F f(float value) {
    F x;
    set(value, x);
    return x;
  }
  static HWY_INLINE D d(double value) {
    D x;
    set(value, x);
    return x;
  }
  static HWY_INLINE F load(const float* from) {
    F x;
    load_lanes(from, x);
    return x;
  }
  static HWY_INLINE D load_wide(const float* from) {
    D x;
    load_lanes(from, x);
    return x;
  }
  static HWY_INLINE D load_double(const double* from) {
    D x;
    load_lanes(from, x);
    return x;
  }
  static HWY_INLINE void store(F x, float* to) { store_lanes(x, to); }
  static HWY_INLINE F narrow(D x) {
    F to;
    narrow_lanes(x, to);
    return to;
  }
  static HWY_INLINE D widen(F x) {
    D to;
    widen_lanes(x, to);
    return to;
  }

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
  static HWY_INLINE F power_of_two(F n) { return two_to(n); }
};
#endif
