#pragma once

#include <cmath>

namespace tristim::detail {

/// A number as the unevaluated sum of two doubles, |lo| <= ulp(hi)/2: 106 bits [Dekker71].
///
/// Products and quotients are within 2^-102 of their value, sums of numbers of one sign within
/// 2^-104. Nothing but IEEE addition, multiplication, division and square root in a fixed order.
struct DoubleDouble {
  double hi = 0, lo = 0;

  constexpr DoubleDouble() noexcept = default;
  // A double is such a number. NOLINTNEXTLINE(google-explicit-constructor)
  constexpr DoubleDouble(double high, double low = 0) noexcept : hi(high), lo(low) {}

  /// Rounded once.
  constexpr double value() const noexcept { return hi + lo; }
};

/// The sum of |a| >= |b|, exactly.
constexpr DoubleDouble quick_two_sum(double a, double b) noexcept {
  const double s = a + b;
  return {s, b - (s - a)};
}

/// The sum of any two doubles, exactly.
constexpr DoubleDouble two_sum(double a, double b) noexcept {
  const double s = a + b;
  const double v = s - a;
  return {s, (a - (s - v)) + (b - v)};
}

/// The product of two doubles below 2^996, exactly. By Dekker's splitting: std::fma may be slow, or
/// a call into the C library.
constexpr DoubleDouble two_product(double a, double b) noexcept {
  constexpr double kSplitter = 134217729;  // 2^27 + 1
  const double p = a * b;
  const double ca = kSplitter * a;
  const double ah = ca - (ca - a);
  const double al = a - ah;
  const double cb = kSplitter * b;
  const double bh = cb - (cb - b);
  const double bl = b - bh;
  return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}

constexpr DoubleDouble add(DoubleDouble a, DoubleDouble b) noexcept {
  const DoubleDouble s = two_sum(a.hi, b.hi);
  const DoubleDouble t = two_sum(a.lo, b.lo);
  const DoubleDouble u = quick_two_sum(s.hi, s.lo + t.hi);
  return quick_two_sum(u.hi, u.lo + t.lo);
}

constexpr DoubleDouble negate(DoubleDouble a) noexcept { return {-a.hi, -a.lo}; }

constexpr DoubleDouble subtract(DoubleDouble a, DoubleDouble b) noexcept {
  return add(a, negate(b));
}

constexpr DoubleDouble multiply(DoubleDouble a, DoubleDouble b) noexcept {
  DoubleDouble p = two_product(a.hi, b.hi);
  p.lo += a.hi * b.lo + a.lo * b.hi;
  return quick_two_sum(p.hi, p.lo);
}

constexpr DoubleDouble multiply(DoubleDouble a, double b) noexcept {
  DoubleDouble p = two_product(a.hi, b);
  p.lo += a.lo * b;
  return quick_two_sum(p.hi, p.lo);
}

constexpr DoubleDouble divide(DoubleDouble a, DoubleDouble b) noexcept {
  const double q1 = a.hi / b.hi;
  DoubleDouble r = add(a, multiply(b, -q1));
  const double q2 = r.hi / b.hi;
  r = add(r, multiply(b, -q2));
  const double q3 = r.hi / b.hi;
  return add(quick_two_sum(q1, q2), {q3, 0});
}

// The same as operators, for formulas that read as they are printed.
constexpr DoubleDouble operator-(DoubleDouble a) noexcept { return negate(a); }
constexpr DoubleDouble operator+(DoubleDouble a, DoubleDouble b) noexcept { return add(a, b); }
constexpr DoubleDouble operator-(DoubleDouble a, DoubleDouble b) noexcept { return subtract(a, b); }
constexpr DoubleDouble operator*(DoubleDouble a, DoubleDouble b) noexcept { return multiply(a, b); }
constexpr DoubleDouble operator/(DoubleDouble a, DoubleDouble b) noexcept { return divide(a, b); }

/// The decimal number that the text of `x` was, 22/10 and not the double beside it, for up to 15
/// digits and 14 places behind the point; of other numbers `x` itself.
constexpr DoubleDouble decimal(double x) noexcept {
  for (double scale = 1; scale <= 1e14; scale *= 10) {
    const double scaled = x * scale;
    if (!(scaled < 1e15 && scaled > -1e15)) break;
    const auto n = static_cast<double>(static_cast<long long>(scaled + (scaled < 0 ? -0.5 : 0.5)));
    if (n / scale == x) return DoubleDouble(n) / scale;
  }
  return x;
}

/// Square root of a >= 0.
inline DoubleDouble square_root(DoubleDouble a) noexcept {
  if (!(a.hi > 0)) return {std::sqrt(a.hi), 0};
  const double root = std::sqrt(a.hi);  // one Newton step doubles its digits
  const DoubleDouble rest = subtract(a, two_product(root, root));
  return quick_two_sum(root, rest.hi / (2 * root));
}

}  // namespace tristim::detail
