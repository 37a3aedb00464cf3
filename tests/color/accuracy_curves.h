#pragma once

#include <quadmath.h>

#include <cmath>
#include <string_view>

namespace tristim::reference {

// The curves once more, straight from their publications, in any arithmetic: T is __float128 for
// the page, double where every float is swept.

using Quad = __float128;

inline Quad power(Quad x, Quad y) { return powq(x, y); }
inline Quad logarithm(Quad x) { return logq(x); }
inline Quad exponential(Quad x) { return expq(x); }
inline double power(double x, double y) { return std::pow(x, y); }
inline double logarithm(double x) { return std::log(x); }
inline double exponential(double x) { return std::exp(x); }

/// n/d as a T: decimals exactly as printed.
template <typename T>
T ratio(double n, double d) {
  return static_cast<T>(n) / static_cast<T>(d);
}

/// What a formula gives, and its largest term: of a sum the sum itself where that is larger.
template <typename T>
struct Term {
  T value, largest;
};

template <typename T>
T magnitude(T x) {
  return x < 0 ? -x : x;
}

template <typename T>
T largest_of(T a, T b) {
  return a > b ? a : b;
}

template <typename T>
Term<T> sum(T a, T b) {
  return {a + b, largest_of(magnitude(T(a + b)), largest_of(magnitude(a), magnitude(b)))};
}

template <typename T>
Term<T> just(T x) {
  return {x, magnitude(x)};
}

/// slope x below the joint, else alpha x^exponent - (alpha - 1); joints are compared as doubles.
template <typename T>
struct Offset {
  T slope, alpha, exponent;
  double joint, encoded_joint;

  Term<T> encode(T x) const {
    if (x < static_cast<T>(joint)) return just<T>(slope * x);
    return sum<T>(alpha * power(x, exponent), 1 - alpha);
  }
  Term<T> decode(T e) const {
    if (e < static_cast<T>(encoded_joint)) return just<T>(e / slope);
    return just<T>(power((e + (alpha - 1)) / alpha, 1 / exponent));
  }
};

template <typename T>
Offset<T> bt2020() {
  T beta = ratio<T>(18, 1000);
  for (int i = 0; i < 8; ++i) {
    const T p = power(beta, ratio<T>(55, 100));
    beta -=
        (ratio<T>(55, 10) * beta - 10 * p + 1) / (ratio<T>(55, 10) - ratio<T>(55, 10) * p / beta);
  }
  const auto joint = static_cast<double>(beta);
  return {ratio<T>(45, 10), 1 + ratio<T>(55, 10) * beta, ratio<T>(45, 100), joint, 4.5 * joint};
}

template <typename T>
struct Pq {
  T m1 = ratio<T>(2610, 16384), m2 = ratio<T>(2523, 32), c1 = ratio<T>(3424, 4096),
    c2 = ratio<T>(2413, 128), c3 = ratio<T>(2392, 128);

  Term<T> encode(T x) const {
    const T p = x > 0 ? power(x, m1) : T(0);
    return just<T>(power((c1 + c2 * p) / (1 + c3 * p), m2));
  }
  Term<T> decode(T e) const {
    const T p = e > 0 ? power(e, 1 / m2) : T(0);
    return just<T>(p > c1 ? power((p - c1) / (c2 - c3 * p), 1 / m1) : T(0));
  }
};

template <typename T>
struct Hlg {
  T a = ratio<T>(17883277, 1e8);

  T b() const { return 1 - 4 * a; }
  T c() const { return ratio<T>(1, 2) - a * logarithm(4 * a); }
  Term<T> encode(T x) const {
    if (x <= static_cast<T>(1.0 / 12)) return just<T>(power(3 * x, ratio<T>(1, 2)));
    return sum<T>(a * logarithm(12 * x - b()), c());
  }
  Term<T> decode(T e) const {
    if (e <= ratio<T>(1, 2)) return just<T>(e * e / 3);
    return sum<T>(exponential((e - c()) / a) / 12, b() / 12);
  }
};

template <typename T>
struct Aces {
  bool toe_is_straight;  // ACEScct

  static T log2(T x) { return logarithm(x) / logarithm(T(2)); }
  Term<T> code(T x) const {
    const Term<T> s = sum<T>(log2(x), ratio<T>(972, 100));
    return {s.value / ratio<T>(1752, 100), s.largest / ratio<T>(1752, 100)};
  }
  T light(T e) const {
    return exponential((e * ratio<T>(1752, 100) - ratio<T>(972, 100)) * logarithm(T(2)));
  }
  Term<T> encode(T x) const {
    const T slope = ratio<T>(105402377416545, 1e13);
    const T offset = static_cast<T>(0.0729055341958355);
    if (toe_is_straight) {
      return x <= static_cast<T>(0.0078125) ? sum<T>(slope * x, offset) : code(x);
    }
    const T low = ratio<T>(1, 65536) + x / 2;
    return x < ratio<T>(1, 32768) ? code(x > 0 ? low : ratio<T>(1, 65536)) : code(x);
  }
  Term<T> decode(T e) const {
    const T slope = ratio<T>(105402377416545, 1e13);
    const T offset = static_cast<T>(0.0729055341958355);
    if (toe_is_straight && e <= static_cast<T>(0.155251141552511)) {
      const Term<T> s = sum<T>(e, -offset);
      return {s.value / slope, s.largest / slope};
    }
    if (!toe_is_straight && e < static_cast<T>((9.72 - 15) / 17.52)) {
      const Term<T> s = sum<T>(light(e), -ratio<T>(1, 65536));
      return {2 * s.value, 2 * s.largest};
    }
    return just<T>(light(e));
  }
};

template <typename T>
struct CubeRoot {
  Term<T> encode(T x) const {
    if (!(x > static_cast<T>(216.0 / 24389))) return just<T>(x * ratio<T>(24389, 2700));
    return sum<T>(ratio<T>(116, 100) * power(x, ratio<T>(1, 3)), -ratio<T>(16, 100));
  }
  Term<T> decode(T e) const {
    if (!(e > static_cast<T>(0.08))) return just<T>(e * ratio<T>(2700, 24389));
    const T root = (e + ratio<T>(16, 100)) / ratio<T>(116, 100);
    return just<T>(root * root * root);
  }
};

/// The member of kTransferFunctions of that name, of x >= 0.
template <typename T>
Term<T> curve(std::string_view name, bool encodes, T x) {
  const auto either = [&](const auto& c) { return encodes ? c.encode(x) : c.decode(x); };
  const double above_srgb = std::nextafter(0.0031308, 1);  // the line holds at the joint
  const double above_code = std::nextafter(0.04045, 1);
  if (name == "srgb") {
    return either(Offset<T>{ratio<T>(1292, 100), ratio<T>(1055, 1000), ratio<T>(5, 12), above_srgb,
                            above_code});
  }
  if (name == "bt709") {
    return either(
        Offset<T>{ratio<T>(45, 10), ratio<T>(1099, 1000), ratio<T>(45, 100), 0.018, 0.081});
  }
  if (name == "smpte240m") {
    return either(Offset<T>{T(4), ratio<T>(11115, 10000), ratio<T>(45, 100), 0.0228, 0.0913});
  }
  if (name == "bt2020") {
    static const Offset<T> solved = bt2020<T>();
    return either(solved);
  }
  if (name == "romm") {
    return either(Offset<T>{T(16), T(1), ratio<T>(10, 18), 1.0 / 512, 1.0 / 32});
  }
  if (name == "adobe") return either(Offset<T>{T(1), T(1), ratio<T>(256, 563), 0, 0});
  if (name == "bt1886") return either(Offset<T>{T(1), T(1), ratio<T>(10, 24), 0, 0});
  if (name == "lstar") return either(CubeRoot<T>{});
  if (name == "pq") return either(Pq<T>{});
  if (name == "hlg") return either(Hlg<T>{});
  if (name == "acescc") return either(Aces<T>{false});
  if (name == "acescct") return either(Aces<T>{true});
  return just<T>(x);
}

}  // namespace tristim::reference
