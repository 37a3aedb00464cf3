// Row formulas that compute in floats where that is exact enough, for plain pixels: F is a float or
// a vector of them. Roots are kept as sums of two floats, so that differences of neighbours lose
// nothing, and matrices stay in double. To be included by row_formulas-inl.h.

#if defined(TRISTIM_ROW_FLOATS) == defined(HWY_TARGET_TOGGLE)
#ifdef TRISTIM_ROW_FLOATS
#undef TRISTIM_ROW_FLOATS
#else
#define TRISTIM_ROW_FLOATS
#endif

HWY_BEFORE_NAMESPACE();
namespace tristim::detail::HWY_NAMESPACE {

// A number as a sum of two.
template <typename F>
struct Sum {
  F high, low;
};

// x^(1/3) of 0 and normal x > 0 within 1.2e-8 relative. h has 8 binary digits, so d = x - h^3 is
// exact, and Halley's step h d/(x + 2 h^3) gives what is missing; the 2 is lessened by the mean of
// its error.
template <typename F>
HWY_INLINE Sum<F> cube_root_sum(F x) {
  const F r = inverse_cube_root_guess(x);
  const F y = x * (r * r);
  const F e = F(1.0) - y * r;
  // (1 - e)^(-2/3) for |e| < 0.104 within 2e-4
  const F h = to_8_digits(y * (F(1.00000439) + e * (F(0.67165615) + e * F(0.55964558))));
  const F cube = (h * h) * h;
  const F divisor = (x + F(2 - 2.4e-5) * cube) + F(0x1p-100);  // not 0
  return {h, (h * (x - cube)) / divisor};
}

template <typename F>
HWY_INLINE F size_of(Three<F> c) {
  return (magnitude(c.a) + magnitude(c.b)) + magnitude(c.c);
}

// CIE lightness of a ratio on 0..1 and beyond, 16/116 at 0.
template <typename F>
HWY_INLINE Sum<F> lightness_sum(F t) {
  constexpr double kZero = 141.0 / 1024;  // the 8 digits of 16/116
  const Sum<F> root = cube_root_sum(larger(t, F(kEpsilon)));
  const auto curved = t > F(kEpsilon);
  const F line = F(kKappa / 116) * t + F(16.0 / 116 - kZero);
  return {select(curved, root.high, F(kZero)), select(curved, root.low, line)};
}

// L* of a ratio whose lightness is f: 116 f.high is exact.
template <typename F>
HWY_INLINE Sum<F> lstar_sum(F t, Sum<F> f) {
  const auto curved = t > F(kEpsilon);
  return {select(curved, F(116.0) * f.high - F(16.0), F(kKappa) * t),
          select(curved, F(116.0) * f.low, F(0.0))};
}

template <typename Formula, typename F>
HWY_INLINE Three<F> apply_in_double(Three<F> c, const RowParameters& p) {
  const auto formula = [&](auto x, auto y, auto z) HWY_ATTR {
    return Formula::apply(Three<decltype(x)>{x, y, z}, p);
  };
  return in_double(formula, c.a, c.b, c.c);
}

// `Ratios`, then Lab within 4e-5 in and about the gamuts of displays.
template <typename Ratios>
struct FastLab {
  template <typename F>
  static HWY_INLINE auto takes(Three<F> c, Three<F> /*result*/) {
    return size_of(c) < F(0x1p40);
  }

  template <typename F>
  static HWY_INLINE Three<F> apply(Three<F> c, const RowParameters& p, F /*undefined*/) {
    const Three<F> ratios = apply_in_double<Ratios>(c, p);
    const Sum<F> x = lightness_sum(ratios.a);
    const Sum<F> y = lightness_sum(ratios.b);
    const Sum<F> z = lightness_sum(ratios.c);
    const Sum<F> l = lstar_sum(ratios.b, y);
    return {l.high + l.low, F(500.0) * (x.high - y.high) + F(500.0) * (x.low - y.low),
            F(200.0) * (y.high - z.high) + F(200.0) * (y.low - z.low)};
  }
};

// `Ratios`, then Luv: but for the root in double, since u* and v* reach several hundred.
template <typename Ratios>
struct FastLuv {
  // Beyond 512 the rounding to float leaves the root no room.
  template <typename F>
  static HWY_INLINE auto takes(Three<F> c, Three<F> result) {
    const auto plain = size_of(c) < F(0x1p40);
    const auto displayable = magnitude(result.b) < F(512.0);
    return plain & displayable;
  }

  template <typename F>
  static HWY_INLINE Three<F> apply(Three<F> c, const RowParameters& p, F /*undefined*/) {
    const F ratio = apply_in_double<Ratios>(c, p).b;
    const Sum<F> l = lstar_sum(ratio, lightness_sum(ratio));
    const auto luv = [&](auto x, auto y, auto z, auto high, auto low) HWY_ATTR {
      using W = decltype(x);
      return luv_of_ratios(Ratios::apply(Three<W>{x, y, z}, p), high + low, second_half(p));
    };
    return in_double(luv, c.a, c.b, c.c, l.high, l.low);
  }
};

struct FastOklab {
  // Cube roots of what is tiny need their floats normal.
  template <typename F>
  static HWY_INLINE auto takes(Three<F> c, Three<F> /*result*/) {
    const F size = size_of(c);
    return (size < F(0x1p60)) & ((size > F(0x1p-40)) | (size == F(0.0)));
  }

  template <typename F>
  static HWY_INLINE Three<F> apply(Three<F> c, const RowParameters& p, F /*undefined*/) {
    const Three<F> cones = apply_in_double<Matrix>(c, p);
    const Three<Sum<F> > roots{odd_root(cones.a), odd_root(cones.b), odd_root(cones.c)};
    return {row(&p[9], roots), row(&p[12], roots), row(&p[15], roots)};
  }

 private:
  template <typename F>
  static HWY_INLINE Sum<F> odd_root(F x) {
    const Sum<F> root = cube_root_sum(magnitude(x));
    const F sign = with_sign_of(F(1.0), x);
    return {root.high * sign, root.low * sign};
  }

  // A row of a matrix: its numbers rounded to 1/4096 times 8 digits are exact, and mostly so the
  // sum.
  template <typename F>
  static HWY_INLINE F row(const double* m, const Three<Sum<F> >& c) {
    const double* first = m + 9;
    const F high = (F(first[0]) * c.a.high + F(first[1]) * c.b.high) + F(first[2]) * c.c.high;
    const F rest = (F(m[0] - first[0]) * c.a.high + F(m[1] - first[1]) * c.b.high) +
                   F(m[2] - first[2]) * c.c.high;
    const F low = (F(m[0]) * c.a.low + F(m[1]) * c.b.low) + F(m[2]) * c.c.low;
    return high + (low + rest);
  }
};

// a - b without an error [Dekker71].
template <typename F>
HWY_INLINE Sum<F> exact_difference(F a, F b) {
  const F high = a - b;
  const F back = high - a;
  return {high, (a - (high - back)) - (b + back)};
}

// a/b, rounded once of what is left of the terms.
template <typename F>
HWY_INLINE F quotient(Sum<F> a, Sum<F> b) {
  const F first = a.high / b.high;
  return first + (a.low - first * b.low) / b.high;
}

// Hue, max and min of a colour with no negative component.
template <typename F>
struct FastHexagon {
  F hue, max, min;
  Sum<F> range;
};

template <typename F>
HWY_INLINE FastHexagon<F> fast_hexagon(Three<F> c, F undefined) {
  const F max = larger(larger(c.a, c.b), c.c);
  const F min = smaller(smaller(c.a, c.b), c.c);
  const auto red = c.a == max;
  const auto green = c.b == max;
  const F from = select(red, c.b, select(green, c.c, c.a));
  const F less = select(red, c.c, select(green, c.a, c.b));
  const F start =
      select(red, select(from < less, F(360.0), F(0.0)), select(green, F(120.0), F(240.0)));
  const F high = max - min;
  const Sum<F> range{high, (max - high) - min};
  const F hue = start + F(60.0) * quotient(exact_difference(from, less), range);
  return {select(high == F(0.0), undefined, select(hue >= F(360.0), F(0.0), hue)), max, min, range};
}

template <typename F>
HWY_INLINE F least_of(Three<F> c) {
  return smaller(smaller(c.a, c.b), c.c);
}

struct FastHsv {
  template <typename F>
  static HWY_INLINE auto takes(Three<F> c, Three<F> /*result*/) {
    const auto positive = least_of(c) >= F(0.0);
    const auto plain = size_of(c) < F(0x1p40);
    return positive & plain;
  }

  template <typename F>
  static HWY_INLINE Three<F> apply(Three<F> c, const RowParameters&, F undefined) {
    const FastHexagon<F> place = fast_hexagon(c, undefined);
    const auto grey = place.range.high == F(0.0);
    return {place.hue, select(grey, F(0.0), place.range.high / place.max), place.max};
  }
};

struct FastHls {
  // Beside white 2 - max - min has no digits.
  template <typename F>
  static HWY_INLINE auto takes(Three<F> c, Three<F> /*result*/) {
    const F max = larger(larger(c.a, c.b), c.c);
    const F min = least_of(c);
    const auto saturates = (max + min < F(2 - 0x1p-10)) | (max == min);
    return ((min >= F(0.0)) & (max <= F(1.0))) & (saturates & (size_of(c) <= F(3.0)));
  }

  template <typename F>
  static HWY_INLINE Three<F> apply(Three<F> c, const RowParameters&, F undefined) {
    const FastHexagon<F> place = fast_hexagon(c, undefined);
    const F sum = place.max + place.min;
    const F low = place.min - (sum - place.max);
    const auto dark = sum <= F(1.0);
    const Sum<F> whole{select(dark, sum, F(2.0) - sum), select(dark, low, F(0.0) - low)};
    const auto grey = place.range.high == F(0.0);
    return {place.hue, sum * F(0.5), select(grey, F(0.0), quotient(place.range, whole))};
  }
};

// In double without the turns of hues in [0, 360].
template <typename From>
struct FastRgbFrom {
  template <typename F>
  static HWY_INLINE auto takes(Three<F> c, Three<F> /*result*/) {
    return ((c.a >= F(0.0)) & (c.a <= F(360.0))) & (size_of(c) < F(0x1p40));
  }

  template <typename F>
  static HWY_INLINE Three<F> apply(Three<F> c, const RowParameters&, F /*undefined*/) {
    const auto rgb = [](auto x, auto y, auto z) HWY_ATTR {
      using W = decltype(x);
      return From::colors(x * W(1.0 / 60), Three<W>{x, y, z});
    };
    return in_double(rgb, c.a, c.b, c.c);
  }
};

}  // namespace tristim::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
