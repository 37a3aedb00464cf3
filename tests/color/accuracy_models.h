#pragma once

#include <array>

#include "tests/color/accuracy_curves.h"
#include "tristim/color/primaries.h"
#include "tristim/color/yiq.h"

namespace tristim::reference {

using Three = std::array<Quad, 3>;

/// A colour, and for each component the largest term of its formula.
struct Colour {
  Three value, largest;
};

inline Term<Quad> sum3(Quad a, Quad b, Quad c) {
  const Quad terms = largest_of(magnitude(a), largest_of(magnitude(b), magnitude(c)));
  return {a + b + c, largest_of(terms, magnitude(a + b + c))};
}

inline Colour colour(Term<Quad> a, Term<Quad> b, Term<Quad> c) {
  return {{a.value, b.value, c.value}, {a.largest, b.largest, c.largest}};
}

using Matrix = std::array<Three, 3>;

inline Colour times(const Matrix& m, const Three& c) {
  const auto row = [&](const Three& r) { return sum3(r[0] * c[0], r[1] * c[1], r[2] * c[2]); };
  return colour(row(m[0]), row(m[1]), row(m[2]));
}

inline Matrix inverse(const Matrix& m) {
  const auto minor = [&](std::size_t i, std::size_t j) {
    const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
    return m[a][c] * m[b][d] - m[a][d] * m[b][c];
  };
  const Quad determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  Matrix result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = minor(j, i) / determinant;
  }
  return result;
}

/// XYZ of a white with Y = 1, and linear RGB to XYZ [Shoaff 2.2.4].
inline Three white_of(Chromaticity w) {
  const Quad x = w.x, y = w.y;
  return {x / y, 1, (1 - x - y) / y};
}

inline Matrix xyz_from_rgb(const Primaries& p) {
  const Chromaticity points[] = {p.red, p.green, p.blue};
  Matrix directions;
  for (std::size_t j = 0; j < 3; ++j) {
    const Quad x = points[j].x, y = points[j].y;
    directions[0][j] = x;
    directions[1][j] = y;
    directions[2][j] = 1 - x - y;
  }
  const Three c = times(inverse(directions), white_of(p.white)).value;
  for (Three& row : directions) {
    for (std::size_t j = 0; j < 3; ++j) row[j] *= c[j];
  }
  return directions;
}

inline Quad cube_root(Quad x) { return cbrtq(x); }

inline Quad lightness(Quad t) {
  const Quad epsilon = ratio<Quad>(216, 24389);
  return t > epsilon ? cube_root(t) : (ratio<Quad>(24389, 27) * t + 16) / 116;
}

inline Colour lab(const Three& xyz) {
  const Three w = white_of(kD65);
  const Quad x = lightness(xyz[0] / w[0]), y = lightness(xyz[1]), z = lightness(xyz[2] / w[2]);
  return {{116 * y - 16, 500 * (x - y), 200 * (y - z)}, {1, 1, 1}};
}

inline Colour luv(const Three& xyz) {
  const Three w = white_of(kD65);
  const auto total = [](const Three& c) { return c[0] + 15 * c[1] + 3 * c[2]; };
  const Quad l = 116 * lightness(xyz[1]) - 16;
  const Quad u = 4 * xyz[0] / total(xyz) - 4 * w[0] / total(w);
  const Quad v = 9 * xyz[1] / total(xyz) - 9 * w[1] / total(w);
  return {{l, 13 * l * u, 13 * l * v}, {1, 1, 1}};
}

inline Colour xyz_of_lab(const Three& c) {
  const Three w = white_of(kD65);
  const Quad y = (c[0] + 16) / 116;
  const auto light = [](Quad f) {
    const Quad cube = f * f * f;
    return cube > ratio<Quad>(216, 24389) ? cube : (116 * f - 16) * 27 / 24389;
  };
  const Three xyz{w[0] * light(y + c[1] / 500), light(y), w[2] * light(y - c[2] / 200)};
  return {xyz, {largest_of<Quad>(1, xyz[0]), 1, largest_of<Quad>(1, xyz[2])}};
}

inline Quad hue_of(const Three& c, Quad max, Quad range) {
  const Quad sextant = c[0] == max   ? (c[1] - c[2]) / range
                       : c[1] == max ? (c[2] - c[0]) / range + 2
                                     : (c[0] - c[1]) / range + 4;
  return 60 * (sextant < 0 ? sextant + 6 : sextant);
}

inline Colour hsv(const Three& c) {
  const Quad max = largest_of(c[0], largest_of(c[1], c[2]));
  const Quad min = -largest_of(-c[0], largest_of(-c[1], -c[2]));
  const Quad s = (max - min) / max;
  return {{hue_of(c, max, max - min), s, max}, {360, s, max}};
}

inline Colour hls(const Three& c) {
  const Quad max = largest_of(c[0], largest_of(c[1], c[2]));
  const Quad min = -largest_of(-c[0], largest_of(-c[1], -c[2]));
  const Quad total = max + min;
  const Quad s = (max - min) / (total <= 1 ? total : 2 - total);
  return {{hue_of(c, max, max - min), total / 2, s}, {360, max, s}};
}

inline Colour rgb_of_hsv(const Three& c) {
  const auto channel = [&](Quad side) {
    Quad k = side + c[0] / 60;
    while (k >= 6) k -= 6;
    Quad share = k < 4 - k ? k : 4 - k;
    share = share < 0 ? 0 : share > 1 ? 1 : share;
    return c[2] - c[2] * c[1] * share;
  };
  return {{channel(5), channel(3), channel(1)}, {c[2], c[2], c[2]}};
}

inline Colour yiq(const Three& c, const YiqSystem& s) {
  const Quad red = c[0] - c[1], blue = c[2] - c[1];
  return colour(sum3(c[1], s.y_r * red, s.y_b * blue), sum3(s.i_r * red, s.i_b * blue, 0),
                sum3(s.q_r * red, s.q_b * blue, 0));
}

inline Colour oklab(const Three& c) {
  const auto decimal = [](double x) { return ratio<Quad>(std::round(x * 1e10), 1e10); };
  const auto matrix = [&](const double(&m)[3][3]) {
    Matrix q;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) q[i][j] = decimal(m[i][j]);
    }
    return q;
  };
  constexpr double kCones[3][3] = {{0.4122214708, 0.5363325363, 0.0514459929},
                                   {0.2119034982, 0.6806995451, 0.1073969566},
                                   {0.0883024619, 0.2817188376, 0.6299787005}};
  constexpr double kLab[3][3] = {{0.2104542553, 0.7936177850, -0.0040720468},
                                 {1.9779984951, -2.4285922050, 0.4505937099},
                                 {0.0259040371, 0.7827717662, -0.8086757660}};
  Three roots = times(matrix(kCones), c).value;
  for (Quad& root : roots) root = cube_root(root);
  return times(matrix(kLab), roots);
}

}  // namespace tristim::reference
