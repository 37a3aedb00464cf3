#include "tristim/color/ictcp.h"

#include "tristim/color/transfer.h"

namespace tristim {
namespace {

// A matrix of 4096ths. All three of ours send greys to greys: the first and the last column say it
// all of R - G and B - G.
struct Matrix4096 {
  double m[3][3];
};

constexpr Matrix4096 kLmsFromSrgb{{{1688, 2146, 262}, {683, 2951, 462}, {99, 309, 3688}}};
constexpr Matrix4096 kPqFromLms{{{2048, 2048, 0}, {6610, -13613, 7003}, {17933, -17390, -543}}};
constexpr Matrix4096 kHlgFromLms{{{2048, 2048, 0}, {3625, -7465, 3840}, {9500, -9212, -288}}};

// The inverse by cofactors: whole numbers, so that each entry is rounded once.
constexpr Matrix4096 inverse(const Matrix4096& a) noexcept {
  const auto minor = [&](int i, int j) {
    const int r = (i + 1) % 3;
    const int s = (i + 2) % 3;
    const int c = (j + 1) % 3;
    const int d = (j + 2) % 3;
    return a.m[r][c] * a.m[s][d] - a.m[r][d] * a.m[s][c];
  };
  const double determinant =
      a.m[0][0] * minor(0, 0) + a.m[0][1] * minor(0, 1) + a.m[0][2] * minor(0, 2);
  Matrix4096 b{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) b.m[i][j] = 4096.0 * 4096 * minor(j, i) / determinant;
  }
  return b;
}

// The matrix where its rows add up to 1: greys stay as they are, exactly.
Rgb apply(const Matrix4096& a, Rgb c) noexcept {
  const double red = c.r - c.g;
  const double blue = c.b - c.g;
  const auto row = [&](int i) { return c.g + (a.m[i][0] * red + a.m[i][2] * blue) / 4096; };
  return {row(0), row(1), row(2)};
}

// I, Ct and Cp of encoded cone responses; the rows of Ct and Cp add up to 0.
Ictcp opponents(const Matrix4096& a, Rgb lms) noexcept {
  const double l = lms.r - lms.g;
  const double s = lms.b - lms.g;
  return {(lms.r + lms.g) / 2, (a.m[1][0] * l + a.m[1][2] * s) / 4096,
          (a.m[2][0] * l + a.m[2][2] * s) / 4096};
}

Rgb responses(const Matrix4096& a, Ictcp c) noexcept {
  const auto row = [&](int i) { return c.i + (a.m[i][1] * c.ct + a.m[i][2] * c.cp) / 4096; };
  return {row(0), row(1), row(2)};
}

Rgb each(double (*curve)(double) noexcept, Rgb c) noexcept {
  return {curve(c.r), curve(c.g), curve(c.b)};
}

constexpr Matrix4096 kRgbFromLms = inverse(kLmsFromSrgb);
constexpr Matrix4096 kLmsFromPq = inverse(kPqFromLms);
constexpr Matrix4096 kLmsFromHlg = inverse(kHlgFromLms);

}  // namespace

Ictcp bt2020_to_ictcp_pq(Rgb cd_m2) noexcept {
  const Rgb lms = apply(kLmsFromSrgb, cd_m2);
  return opponents(kPqFromLms,
                   each(pq_encode, {lms.r / kPqPeak, lms.g / kPqPeak, lms.b / kPqPeak}));
}

Rgb ictcp_pq_to_bt2020(Ictcp ictcp) noexcept {
  const Rgb lms = each(pq_decode, responses(kLmsFromPq, ictcp));
  return apply(kRgbFromLms, {lms.r * kPqPeak, lms.g * kPqPeak, lms.b * kPqPeak});
}

Ictcp bt2020_to_ictcp_hlg(Rgb scene) noexcept {
  return opponents(kHlgFromLms, each(hlg_encode, apply(kLmsFromSrgb, scene)));
}

Rgb ictcp_hlg_to_bt2020(Ictcp ictcp) noexcept {
  return apply(kRgbFromLms, each(hlg_decode, responses(kLmsFromHlg, ictcp)));
}

}  // namespace tristim
