// The formulas of the row kernels, once for numbers and for vectors of every instruction set: W is
// a double or some of them. The double functions of the same name are the definitions. To be
// included by row_kernels.cpp and, for each instruction set, by row_kernels_simd.cpp.

#if defined(TRISTIM_ROW_FORMULAS) == defined(HWY_TARGET_TOGGLE)
#ifdef TRISTIM_ROW_FORMULAS
#undef TRISTIM_ROW_FORMULAS
#else
#define TRISTIM_ROW_FORMULAS
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <concepts>
#include <limits>

#include "lib/color/row_kernels.h"
#include "lib/color/row_lanes.h"
#include "tristim/color/transfer.h"

HWY_BEFORE_NAMESPACE();
namespace tristim::detail::HWY_NAMESPACE {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <typename T>
struct Two {
  T a, b;
};

template <typename W>
struct Three {
  W a, b, c;
};

// f of floats as doubles, its results rounded to float.
template <typename F, std::same_as<float>... X>
HWY_INLINE Three<float> in_double(F&& f, X... x) {
  const Three<double> y = f(double{x}...);
  return {static_cast<float>(y.a), static_cast<float>(y.b), static_cast<float>(y.c)};
}

// 2^y within 1e-14 relative; beyond [-1020, 1020] what the ends have, which no float can hold.
template <typename W>
HWY_INLINE W exp2(W y) {
  y = larger(W(-1020.0), smaller(W(1020.0), y));
  const W n = (y + W(kRoundToWhole)) - W(kRoundToWhole);
  const W r = y - n;
  constexpr double kTaylor[] = {
      // (ln 2)^k / k!
      4.4455382718708101e-10, 7.0549116208011209e-9, 1.0178086009239699e-7, 1.3215486790144305e-6,
      1.5252733804059838e-5,  1.5403530393381606e-4, 1.3333558146428441e-3, 9.618129107628477e-3,
      5.550410866482158e-2,   0.2402265069591007,    0.6931471805599453,    1};
  W sum = W(kTaylor[0]);
  for (std::size_t k = 1; k < std::size(kTaylor); ++k) sum = sum * r + W(kTaylor[k]);
  return sum * power_of_2(n);
}

// log2 of a normal x > 0 within 1e-15 absolute and relative: atanh series of the mantissa.
template <typename W>
HWY_INLINE W log2(W x) {
  const auto parts = split(x);
  const W s = (parts.mantissa - W(1.0)) / (parts.mantissa + W(1.0));
  const W z = s * s;
  constexpr double kSeries[] = {// 2 / (ln 2 (2k + 1))
                                0.16972882833987805, 0.19235933878519512, 0.2219530832136867,
                                0.26230818925253885, 0.3205988979753252,  0.41219858311113240,
                                0.57707801635558535, 0.96179669392597560, 2.8853900817779268};
  W sum = W(kSeries[0]);
  for (std::size_t k = 1; k < std::size(kSeries); ++k) sum = sum * z + W(kSeries[k]);
  return parts.exponent + s * sum;
}

template <typename W>
HWY_INLINE W power(W x, double exponent) {
  return exp2(log2(x) * W(exponent));
}

// x^(1/3), odd, within 2e-9: the guess, one step of fourth order, one of second.
template <typename W>
HWY_INLINE W cube_root_of(W x) {
  const W m = magnitude(x);
  W r = inverse_cube_root_guess(m);
  const W e = W(1.0) - m * (r * r * r);
  r = r + r * (e * (W(1.0 / 3) + e * (W(2.0 / 9) + e * W(14.0 / 81))));
  const W y = m * (r * r);
  const W refined = y + y * ((W(1.0) - y * r) * W(2.0 / 3));
  return select(m < W(kInfinity), with_sign_of(refined, x), x);
}

struct Matrix {
  template <typename W>
  static HWY_INLINE Three<W> apply(Three<W> c, const RowParameters& m) {
    return {(W(m[0]) * c.a + W(m[1]) * c.b) + W(m[2]) * c.c,
            (W(m[3]) * c.a + W(m[4]) * c.b) + W(m[5]) * c.c,
            (W(m[6]) * c.a + W(m[7]) * c.b) + W(m[8]) * c.c};
  }
};

struct GreyMatrix {
  template <typename W>
  static HWY_INLINE Three<W> apply(Three<W> c, const RowParameters& m) {
    const W red = c.a - c.b;
    const W blue = c.c - c.b;
    return {W(m[0]) * c.b + (W(m[1]) * red + W(m[2]) * blue),
            W(m[3]) * c.b + (W(m[4]) * red + W(m[5]) * blue),
            W(m[6]) * c.b + (W(m[7]) * red + W(m[8]) * blue)};
  }
};

struct Complement {
  template <typename W>
  static HWY_INLINE Three<W> apply(Three<W> c, const RowParameters&) {
    return {W(1.0) - c.a, W(1.0) - c.b, W(1.0) - c.c};
  }
};

// A hue in [0, 360] that stays below 360 as a float.
template <typename W>
HWY_INLINE W below_360(W hue) {
  return select(hue >= W(360 - 0x1p-16), W(0.0), hue);
}

// The hue on the hexagon, and between which values a colour lies; all NaN where one component is.
template <typename W>
struct Hexagon {
  W rise, side;  // 60 (rise/(max - min) + side) is the hue
  W max, min;
};

template <typename W>
HWY_INLINE Hexagon<W> hexagon(Three<W> c) {
  const auto no_red = is_nan(c.a);
  const auto no_green = is_nan(c.b);
  const auto no_blue = is_nan(c.c);
  const auto nan = no_red | no_green | no_blue;
  const W max = larger(larger(c.a, c.b), c.c);
  const W min = smaller(smaller(c.a, c.b), c.c);
  const auto red = c.a == max;
  const auto green = c.b == max;
  return {select(red, c.b - c.c, select(green, c.c - c.a, c.a - c.b)),
          select(red, W(0.0), select(green, W(2.0), W(4.0))), select(nan, W(kNone), max), min};
}

// a/da and b/db with one division; what is divided by 0 comes out as any number.
template <typename W>
HWY_INLINE Two<W> ratios(W a, W da, W b, W db) {
  const W first = select(da == W(0.0), W(1.0), da);
  const W second = select(db == W(0.0), W(1.0), db);
  const W product = first * second;
  const W inverse = W(1.0) / product;
  const Two<W> quick{a * (inverse * second), b * (inverse * first)};
  const auto plain = magnitude(product) < W(kInfinity);
  if (!any(!plain)) return quick;
  return {select(plain, quick.a, a / first), select(plain, quick.b, b / second)};
}

// Hue and saturation of `range` over `denominator`; none where there is no range, or a vanishing
// denominator above one.
template <typename W>
HWY_INLINE Two<W> hue_and_saturation(const Hexagon<W>& place, W range, W denominator) {
  const Two<W> ratio = ratios(place.rise, range, range, denominator);
  const W hue = (ratio.a + place.side) * W(60.0);
  const W turned = select(hue < W(0.0), hue + W(360.0), hue + W(0.0));
  const auto grey = range == W(0.0);
  const W saturation = select(denominator == W(0.0), W(kNone), ratio.b);
  const auto none = is_nan(range);
  return {select(grey | none, W(kNone), below_360(turned)), select(grey, W(0.0), saturation)};
}

// Any hue modulo 360, in [0, 360]. The stages keep hues exact that are whole turns times 2^44.
template <typename W>
HWY_INLINE W wrap(W hue) {
  if (any(magnitude(hue) > W(0x1p40))) {
    hue = hue - W(360 * 0x1p88) * whole_part(hue * W(1 / (360 * 0x1p88)));
    hue = hue - W(360 * 0x1p44) * whole_part(hue * W(1 / (360 * 0x1p44)));
  }
  hue = hue - W(360.0) * whole_part(hue / W(360.0));
  return select(hue < W(0.0), hue + W(360.0), hue);
}

// How much of the colour's range the channel has whose hexagon side is centred on `side`.
template <typename W>
HWY_INLINE W share(W sextants) {
  return larger(W(0.0), smaller(W(1.0), sextants));
}

// h: sixths of a turn in [0, 6].
template <typename W>
HWY_INLINE Three<W> from_hexagon(W h, W max, W min) {
  const W range = max - min;
  const auto grey = max == min;
  const auto channel = [&](W part)
                           HWY_ATTR { return select(grey, max, min + range * share(part)); };
  return {channel(magnitude(h - W(3.0)) - W(1.0)), channel(W(2.0) - magnitude(h - W(2.0))),
          channel(W(2.0) - magnitude(h - W(4.0)))};
}

struct HsvFromRgb {
  template <typename W>
  static HWY_INLINE Three<W> apply(Three<W> c, const RowParameters&) {
    const Hexagon<W> place = hexagon(c);
    const Two<W> out = hue_and_saturation(place, place.max - place.min, place.max);
    return {out.a, out.b, place.max};
  }
};

// The colours by h, the position on the hexagon.
struct FromHsv {
  template <typename W>
  static HWY_INLINE Three<W> colors(W h, Three<W> c) {
    return from_hexagon(h, c.c, c.c * (W(1.0) - c.b));
  }
};

struct FromHls {
  template <typename W>
  static HWY_INLINE Three<W> colors(W h, Three<W> c) {
    const W half = c.c * select(c.b <= W(0.5), c.b, W(1.0) - c.b);
    return from_hexagon(h, c.b + half, c.b - half);
  }
};

// Of any hue.
template <typename From>
struct RgbFrom {
  template <typename W>
  static HWY_INLINE Three<W> apply(Three<W> c, const RowParameters&) {
    return From::colors(wrap(c.a) / W(60.0), c);
  }
};

struct HlsFromRgb {
  template <typename W>
  static HWY_INLINE Three<W> apply(Three<W> c, const RowParameters&) {
    const Hexagon<W> place = hexagon(c);
    const W sum = place.max + place.min;
    const W rest = (W(1.0) - place.max) + (W(1.0) - place.min);
    const Two<W> out =
        hue_and_saturation(place, place.max - place.min, select(sum <= W(1.0), sum, rest));
    return {out.a, sum * W(0.5), out.b};
  }
};

struct SwapLast {
  template <typename W>
  static HWY_INLINE Three<W> apply(Three<W> c, const RowParameters&) {
    return {c.a, c.c, c.b};
  }
};

struct Hue {
  template <typename W>
  static HWY_INLINE Three<W> apply(Three<W> c, const RowParameters& p) {
    return {p[0] == 0 ? below_360(c.a) : c.a, c.b, p[0] == 2 ? below_360(c.c) : c.c};
  }
};

// CIE lightness and its inverse on 0..1.16 [CIE15 8.2.1].
constexpr double kEpsilon = 216.0 / 24389;
constexpr double kKappa = 24389.0 / 27;

template <typename W>
HWY_INLINE W lightness(W t) {
  return select(t > W(kEpsilon), cube_root_of(t), (W(kKappa) * t + W(16.0)) * W(1.0 / 116));
}

template <typename W>
HWY_INLINE W from_lightness(W f) {
  const W cube = f * f * f;
  return select(cube > W(kEpsilon), cube, (W(116.0) * f - W(16.0)) * W(1 / kKappa));
}

template <typename W>
HWY_INLINE W luminance_of(W lstar) {
  const W f = (lstar + W(16.0)) * W(1.0 / 116);
  return select(lstar > W(8.0), f * f * f, lstar * W(1 / kKappa));
}

struct LabFromRatios {
  template <typename W>
  static HWY_INLINE Three<W> apply(Three<W> c, const RowParameters&) {
    const W y = lightness(c.b);
    return {W(116.0) * y - W(16.0), W(500.0) * (lightness(c.a) - y),
            W(200.0) * (y - lightness(c.c))};
  }
};

struct RatiosFromLab {
  template <typename W>
  static HWY_INLINE Three<W> apply(Three<W> c, const RowParameters&) {
    const W f = (c.a + W(16.0)) * W(1.0 / 116);
    const W y = luminance_of(c.a);
    // no way round for a* = 0 or b* = 0: greys stay exact
    return {select(c.b == W(0.0), y, from_lightness(f + c.b * W(1.0 / 500))), y,
            select(c.c == W(0.0), y, from_lightness(f - c.c * W(1.0 / 200)))};
  }
};

// With S = Xw x + 15 y + 3 Zw z, u' - u'w = 4 Xw (15 (x - y) + 3 Zw (x - z))/(S Sw) and
// v' - v'w = 9 (Xw (y - x) + 3 Zw (y - z))/(S Sw): nothing is left on greys.
template <typename W>
HWY_INLINE Three<W> luv_of_ratios(Three<W> c, W lstar, const RowParameters& white) {
  const W xw = W(white[0]);
  const W zw3 = W(3 * white[1]);
  const W white_sum = (xw + W(15.0)) + zw3;
  const W sum = (xw * c.a + W(15.0) * c.b) + zw3 * c.c;
  const W scale = select(sum == W(0.0), W(0.0), W(13.0) * lstar / (sum * white_sum));
  const W u = xw * (W(15.0) * (c.a - c.b) + zw3 * (c.a - c.c));
  const W v = xw * (c.b - c.a) + zw3 * (c.b - c.c);
  return {lstar, W(4.0) * scale * u, W(9.0) * scale * v};
}

struct LuvFromRatios {
  template <typename W>
  static HWY_INLINE Three<W> apply(Three<W> c, const RowParameters& white) {
    return luv_of_ratios(c, W(116.0) * lightness(c.b) - W(16.0), white);
  }
};

// With du = u' - u'w and dv: x/y = 1 + 9 (du v'w - u'w dv)/(4 v' v'w Xw) and its like.
struct RatiosFromLuv {
  template <typename W>
  static HWY_INLINE Three<W> apply(Three<W> c, const RowParameters& white) {
    const double white_sum = white[0] + 15 + 3 * white[1];
    const W uw = W(4 * white[0] / white_sum);
    const W vw = W(9 / white_sum);
    const W y = luminance_of(c.a);
    const W scale = W(1.0) / (W(13.0) * c.a);
    const auto black = c.a == W(0.0);
    const W du = c.b * select(black, W(0.0), scale);
    const W dv = c.c * select(black, W(0.0), scale);
    const W part = y / (W(4.0) * (vw + dv) * vw);
    const W turn = du * vw - uw * dv;
    return {y + part * (W(9 / white[0]) * turn), y,
            y - part * (W(3 / white[1]) * (du * vw + (W(4.0) - uw) * dv))};
  }
};

struct CubeRoot {
  template <typename W>
  static HWY_INLINE W curve(W x, const RowParameters&) {
    return cube_root_of(x);
  }
};

struct Cube {
  template <typename W>
  static HWY_INLINE W curve(W x, const RowParameters&) {
    return x * x * x;
  }
};

constexpr RowParameters second_half(const RowParameters& p) {
  RowParameters half{};
  for (std::size_t i = 9; i < p.size(); ++i) half[i - 9] = p[i];
  return half;
}

// Formulas one after the other; the second's numbers follow the nine of the first.
template <typename First, typename Second>
struct Then {
  template <typename W>
  static HWY_INLINE Three<W> apply(Three<W> c, const RowParameters& p) {
    return Second::apply(First::apply(c, p), second_half(p));
  }
};

// A matrix, a curve, a matrix.
template <typename Curve>
struct OklabLike {
  template <typename W>
  static HWY_INLINE Three<W> apply(Three<W> c, const RowParameters& p) {
    const Three<W> cones = Matrix::apply(c, p);
    return Matrix::apply(
        Three<W>{Curve::curve(cones.a, p), Curve::curve(cones.b, p), Curve::curve(cones.c, p)},
        second_half(p));
  }
};

// sign(x) f(|x|); infinities and NaN stay.
template <typename W, typename F>
HWY_INLINE W odd_of(W x, F&& f) {
  const W m = magnitude(x);
  return select(m < W(kInfinity), with_sign_of(f(m), x), x);
}

struct PowerEncode {
  template <typename W>
  static HWY_INLINE W curve(W x, const RowParameters& p) {
    const W m = magnitude(x);
    const W curved = W(p[3]) * power(m, p[5]) - W(p[4]);
    const W line = W(p[0]) * m;
    const auto straight = p[7] == 0 ? m < W(p[1]) : x < W(p[1]);
    const W y = select(straight | (m == W(0.0)), line, curved);
    return select(m < W(kInfinity), with_sign_of(y, x), x);
  }
};

struct PowerDecode {
  template <typename W>
  static HWY_INLINE W curve(W e, const RowParameters& p) {
    const W m = magnitude(e);
    const W curved = power((m + W(p[4])) / W(p[3]), p[6]);
    const W line = m / W(p[0]);
    const auto straight = p[7] == 0 ? m < W(p[2]) : e < W(p[2]);
    const W y = select(straight | (m == W(0.0)), line, curved);
    return select(m < W(kInfinity), with_sign_of(y, e), e);
  }
};

struct Bt1886Encode {
  template <typename W>
  static HWY_INLINE W curve(W x, const RowParameters& p) {
    const W light = select(x > W(0.0), power(x, 1 / 2.4), W(0.0));
    const W code = (light - W(p[1])) / W(p[0]);
    return select((x < W(kInfinity)), code, x);
  }
};

struct Bt1886Decode {
  template <typename W>
  static HWY_INLINE W curve(W e, const RowParameters& p) {
    const W light = W(p[0]) * e + W(p[1]);
    const W y = select(light > W(0.0), power(light, 2.4), W(0.0));
    return select(e < W(kInfinity), y, e);
  }
};

// [ST2084].
constexpr double kM1 = 2610.0 / 16384;
constexpr double kM2 = 2523.0 / 32;
constexpr double kC1 = 3424.0 / 4096;
constexpr double kC2 = 2413.0 / 128;
constexpr double kC3 = 2392.0 / 128;

struct PqEncode {
  template <typename W>
  static HWY_INLINE W curve(W x, const RowParameters&) {
    // 1e300 is as good as no end: p is 10^48
    const W p = select(x > W(0.0), power(smaller(W(1e300), x), kM1), W(0.0));
    const W e = power((W(kC1) + W(kC2) * p) / (W(1.0) + W(kC3) * p), kM2);
    return select(is_nan(x), x, e);
  }
};

struct PqDecode {
  template <typename W>
  static HWY_INLINE W curve(W e, const RowParameters&) {
    const W p = power(e, 1 / kM2);
    const W light = power((p - W(kC1)) / (W(kC2) - W(kC3) * p), 1 / kM1);
    // Beside its zero and its pole a difference loses all digits.
    const auto coarse = (e > W(0.0)) & ((e < W(1e-3)) | (e > W(1.9))) & (e < W(kInfinity));
    const W y = where(coarse, e, select(e > W(0.0), light, W(0.0)), pq_decode);
    const auto nan = is_nan(e);
    return select(nan | (e == W(kInfinity)), e, y);
  }
};

struct HlgEncode {
  template <typename W>
  static HWY_INLINE W curve(W x, const RowParameters& p) {
    return odd_of(x, [&](W m) HWY_ATTR {
      const W curved = W(p[0]) * (log2(W(12.0) * m - W(p[1])) * W(0.6931471805599453)) + W(p[2]);
      return select(m <= W(1.0 / 12), root(W(3.0) * m), curved);
    });
  }
};

struct HlgDecode {
  template <typename W>
  static HWY_INLINE W curve(W e, const RowParameters& p) {
    return odd_of(e, [&](W m) HWY_ATTR {
      const W curved = exp2((m - W(p[2])) * W(1.4426950408889634 / p[0])) + W(p[1]);
      return select(m <= W(0.5), m * m * W(1.0 / 3), curved * W(1.0 / 12));
    });
  }
};

template <typename W>
HWY_INLINE W aces_code(W light) {
  return (log2(light) + W(9.72)) * W(1 / 17.52);
}

template <typename W>
HWY_INLINE W aces_light(W code) {
  return exp2(code * W(17.52) - W(9.72));
}

struct AcesccEncode {
  template <typename W>
  static HWY_INLINE W curve(W x, const RowParameters&) {
    const W low = W(0x1p-16) + larger(W(0.0), x) * W(0.5);
    const W code = aces_code(select(x < W(0x1p-15), low, x));
    return select(x < W(kInfinity), code, x);
  }
};

struct AcesccDecode {
  template <typename W>
  static HWY_INLINE W curve(W e, const RowParameters&) {
    const W light = aces_light(e);
    const W y = select(e < W((9.72 - 15) / 17.52), (light - W(0x1p-16)) * W(2.0), light);
    return select(e < W(kInfinity), y, e);
  }
};

struct AcescctEncode {
  template <typename W>
  static HWY_INLINE W curve(W x, const RowParameters&) {
    const W line = W(10.5402377416545) * x + W(0.0729055341958355);
    const W code = select(x <= W(0.0078125), line, aces_code(x));
    return select(x < W(kInfinity), code, x);
  }
};

struct AcescctDecode {
  template <typename W>
  static HWY_INLINE W curve(W e, const RowParameters&) {
    const W line = (e - W(0.0729055341958355)) / W(10.5402377416545);
    const W y = select(e <= W(0.155251141552511), line, aces_light(e));
    return select(e < W(kInfinity), y, e);
  }
};

}  // namespace tristim::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#include "lib/color/row_floats-inl.h"

HWY_BEFORE_NAMESPACE();
namespace tristim::detail::HWY_NAMESPACE {

// Runs a formula over a block, Lanes::count() pixels at a time.
template <typename Formula, typename Lanes>
void run_block(RowBlock& block, std::size_t count, const RowParameters& p) {
  using W = typename Lanes::W;
  for (std::size_t i = 0; i < count; i += Lanes::count()) {
    const Three<W> c{Lanes::load(&block.plane[0][i]), Lanes::load(&block.plane[1][i]),
                     Lanes::load(&block.plane[2][i])};
    const Three<W> out = Formula::apply(c, p);
    Lanes::store(out.a, &block.plane[0][i]);
    Lanes::store(out.b, &block.plane[1][i]);
    Lanes::store(out.c, &block.plane[2][i]);
  }
}

// A formula, and what stands for NaN: 0 where the colour is finite, unless `undefined` is NaN.
template <typename Formula, typename W>
HWY_INLINE Three<W> defined(Three<W> c, const RowParameters& p, W undefined) {
  const W sum = (c.a + c.b) + c.c;
  const W none = (sum - sum) + undefined;
  const Three<W> x = Formula::apply(c, p);
  return {select(is_nan(x.a), none, x.a), select(is_nan(x.b), none, x.b),
          select(is_nan(x.c), none, x.c)};
}

// A vector of floats a time. A formula without a `Fast` one computes in double.
template <typename Formula, typename Fast, typename Lanes>
HWY_INLINE void run_group(const float* in, float* out, const RowParameters& p, double undefined) {
  const auto c = Lanes::load_pixels(in);
  const auto exact = [&](auto x, auto y, auto z) HWY_ATTR {
    using W = decltype(x);
    return defined<Formula>(Three<W>{x, y, z}, p, W(undefined));
  };
  if constexpr (std::same_as<Fast, void>) {
    Lanes::store_pixels(in_double(exact, c.a, c.b, c.c), out);
  } else {
    using F = decltype(c.a);
    auto x = Fast::apply(c, p, F(undefined));
    const auto usual = Fast::takes(c, x);
    if (any(!usual)) {
      const auto rest = in_double(exact, c.a, c.b, c.c);
      x = {select(usual, x.a, rest.a), select(usual, x.b, rest.b), select(usual, x.c, rest.c)};
    }
    Lanes::store_pixels(x, out);
  }
}

template <typename Formula, typename Fast, typename Lanes>
void run_pixels(const float* in, float* out, std::size_t count, const RowParameters& p,
                bool keep_undefined) {
  const double undefined = keep_undefined ? kNone : 0;
  const RowParameters own = p;  // which nothing that is stored can change: read before the loop
  const std::size_t step = Lanes::pixels();
  std::size_t i = 0;
  for (; i + step <= count; i += step) {
    run_group<Formula, Fast, Lanes>(in + 3 * i, out + 3 * i, own, undefined);
  }
  if (i == count) return;
  float rest[3 * 128] = {};  // no vector has more floats than 128
  std::copy(in + 3 * i, in + 3 * count, rest);
  run_group<Formula, Fast, Lanes>(rest, rest, own, undefined);
  std::copy(rest, rest + 3 * (count - i), out + 3 * i);
}

template <typename Formula, typename Lanes, typename Fast = void>
constexpr RowKernel run{run_block<Formula, Lanes>, run_pixels<Formula, Fast, Lanes>};

template <typename Formula, typename Lanes>
void run_curve_block(RowBlock& block, std::size_t count, const RowParameters& p) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    double* plane = block.plane[channel];
    for (std::size_t i = 0; i < count; i += Lanes::count()) {
      Lanes::store(Formula::curve(Lanes::load(&plane[i]), p), &plane[i]);
    }
  }
}

template <typename Formula, typename Lanes>
constexpr RowKernel run_curve{run_curve_block<Formula, Lanes>, nullptr};

template <typename Lanes>
RowKernels all_kernels(std::string_view name) {
  return {.name = name,
          .load = Lanes::load_block,
          .store = Lanes::store_block,
          .matrix = run<Matrix, Lanes>,
          .grey_matrix = run<GreyMatrix, Lanes>,
          .complement = run<Complement, Lanes>,
          .hsv_from_rgb = run<HsvFromRgb, Lanes, FastHsv>,
          .rgb_from_hsv = run<RgbFrom<FromHsv>, Lanes, FastRgbFrom<FromHsv>>,
          .hls_from_rgb = run<HlsFromRgb, Lanes, FastHls>,
          .rgb_from_hls = run<RgbFrom<FromHls>, Lanes, FastRgbFrom<FromHls>>,
          .swap_last = run<SwapLast, Lanes>,
          .hue = run<Hue, Lanes>,
          .lab_from_ratios = run<LabFromRatios, Lanes>,
          .ratios_from_lab = run<RatiosFromLab, Lanes>,
          .luv_from_ratios = run<LuvFromRatios, Lanes>,
          .ratios_from_luv = run<RatiosFromLuv, Lanes>,
          .lab_of_matrix = run<Then<Matrix, LabFromRatios>, Lanes, FastLab<Matrix>>,
          .lab_of_grey_matrix = run<Then<GreyMatrix, LabFromRatios>, Lanes, FastLab<GreyMatrix>>,
          .luv_of_matrix = run<Then<Matrix, LuvFromRatios>, Lanes, FastLuv<Matrix>>,
          .luv_of_grey_matrix = run<Then<GreyMatrix, LuvFromRatios>, Lanes, FastLuv<GreyMatrix>>,
          .matrix_of_lab = run<Then<RatiosFromLab, Matrix>, Lanes>,
          .grey_matrix_of_lab = run<Then<RatiosFromLab, GreyMatrix>, Lanes>,
          .matrix_of_luv = run<Then<RatiosFromLuv, Matrix>, Lanes>,
          .grey_matrix_of_luv = run<Then<RatiosFromLuv, GreyMatrix>, Lanes>,
          .oklab = run<OklabLike<CubeRoot>, Lanes, FastOklab>,
          .linear_of_oklab = run<OklabLike<Cube>, Lanes>,
          .power_encode = run_curve<PowerEncode, Lanes>,
          .power_decode = run_curve<PowerDecode, Lanes>,
          .bt1886_encode = run_curve<Bt1886Encode, Lanes>,
          .bt1886_decode = run_curve<Bt1886Decode, Lanes>,
          .pq_encode = run_curve<PqEncode, Lanes>,
          .pq_decode = run_curve<PqDecode, Lanes>,
          .hlg_encode = run_curve<HlgEncode, Lanes>,
          .hlg_decode = run_curve<HlgDecode, Lanes>,
          .acescc_encode = run_curve<AcesccEncode, Lanes>,
          .acescc_decode = run_curve<AcesccDecode, Lanes>,
          .acescct_encode = run_curve<AcescctEncode, Lanes>,
          .acescct_decode = run_curve<AcescctDecode, Lanes>};
}

}  // namespace tristim::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
