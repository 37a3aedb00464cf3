#include "tristim/lut/lut.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tristim/core/text.h"

namespace tristim {
namespace {

using Triple = std::array<double, 3>;

// Where a channel's value lies between two neighbouring entries.
struct Place {
  int index;        // of the lower one, 0 .. size - 2
  double fraction;  // [0, 1]
};

Place place(double x, double low, double high, int size) noexcept {
  const double position = (x - low) / (high - low) * (size - 1);
  if (!(position > 0)) return {0, 0};  // NaN too
  if (position >= size - 1) return {size - 2, 1};
  const int index = static_cast<int>(position);
  return {index, position - index};
}

double mix(double a, double b, double fraction) noexcept {
  return (1 - fraction) * a + fraction * b;
}

struct Cell {
  const float* corner;  // the lowest of the eight
  std::size_t step[3];  // floats to the next one of each axis
  double fraction[3];
};

Cell cell(const Lut3D& cube, Rgb rgb) noexcept {
  const auto size = static_cast<std::size_t>(cube.size);
  const Triple in = {rgb.r, rgb.g, rgb.b};
  Cell found{cube.rgb.data(), {3, 3 * size, 3 * size * size}, {}};
  for (std::size_t c = 0; c < 3; ++c) {
    const Place at = place(in[c], cube.range.low[c], cube.range.high[c], cube.size);
    found.corner += static_cast<std::size_t>(at.index) * found.step[c];
    found.fraction[c] = at.fraction;
  }
  return found;
}

Rgb sum(Rgb a, double weight, const float* point) noexcept {
  return {a.r + weight * point[0], a.g + weight * point[1], a.b + weight * point[2]};
}

Rgb evaluate_step(const Lut1D& lut, Rgb rgb, const LutInterpolation&) noexcept {
  Triple x = {rgb.r, rgb.g, rgb.b};
  for (std::size_t c = 0; c < 3; ++c) {
    const Place at = place(x[c], lut.range.low[c], lut.range.high[c], lut.size);
    const float* entry = lut.rgb.data() + 3 * static_cast<std::size_t>(at.index) + c;
    x[c] = mix(entry[0], entry[3], at.fraction);
  }
  return {x[0], x[1], x[2]};
}

Rgb evaluate_step(const LutPoints& lut, Rgb rgb, const LutInterpolation&) noexcept {
  return {evaluate(lut.curves[0], rgb.r), evaluate(lut.curves[1], rgb.g),
          evaluate(lut.curves[2], rgb.b)};
}

Rgb evaluate_step(const Lut3D& lut, Rgb rgb, const LutInterpolation& interpolation) noexcept {
  return interpolation.evaluate(lut, rgb);
}

Rgb evaluate_step(const LutMatrix& lut, Rgb rgb, const LutInterpolation&) noexcept {
  const Eigen::Vector3d out = lut.matrix * Eigen::Vector3d(rgb.r, rgb.g, rgb.b) + lut.offset;
  return {out.x(), out.y(), out.z()};
}

// Why a step cannot be used; empty where it can.
using Complaint = std::string;

Complaint size_complaint(std::string_view what, int size, int most) {
  if (size >= 2 && size <= most) return "";
  return std::string(what) + " of size " + std::to_string(size) + "; expected 2 to " +
         std::to_string(most);
}

Complaint table_complaint(const std::vector<float>& table, std::size_t samples) {
  if (table.size() != samples) {
    return "has " + std::to_string(table.size()) + " numbers; expected " + std::to_string(samples);
  }
  const auto odd =
      std::find_if(table.begin(), table.end(), [](float x) { return !std::isfinite(x); });
  if (odd == table.end()) return "";
  return "entry " + std::to_string((odd - table.begin()) / 3) + " is " + shortest(*odd) +
         "; expected finite numbers";
}

Complaint range_complaint(const LutRange& range) {
  for (std::size_t c = 0; c < 3; ++c) {
    const double width = range.high[c] - range.low[c];
    if (width > 0 && std::isfinite(width)) continue;
    return "range " + shortest(range.low[c]) + " to " + shortest(range.high[c]) +
           "; expected low < high";
  }
  return "";
}

Complaint first_of(std::initializer_list<Complaint> complaints) {
  for (const Complaint& complaint : complaints) {
    if (!complaint.empty()) return complaint;
  }
  return "";
}

Complaint complaint(const Lut1D& lut) {
  const Complaint size = size_complaint("curves", lut.size, kMostCurveSize);
  if (!size.empty()) return size;
  return first_of({range_complaint(lut.range), table_complaint(lut.rgb, curve_samples(lut.size))});
}

Complaint complaint(const Lut3D& lut) {
  const Complaint size = size_complaint("cube", lut.size, kMostCubeSize);
  if (!size.empty()) return size;
  return first_of({range_complaint(lut.range), table_complaint(lut.rgb, cube_samples(lut.size))});
}

Complaint complaint(const LutPoints& lut) {
  for (const LutCurve& curve : lut.curves) {
    const bool fits = curve.in.size() <= static_cast<std::size_t>(kMostCurveSize);
    const Complaint found = first_of(
        {size_complaint("curve", fits ? static_cast<int>(curve.in.size()) : kMostCurveSize + 1,
                        kMostCurveSize),
         table_complaint(curve.in, curve.in.size()), table_complaint(curve.out, curve.in.size())});
    if (!found.empty()) return found;
    const auto turn = std::adjacent_find(curve.in.begin(), curve.in.end(),
                                         [](float a, float b) { return a >= b; });
    if (turn != curve.in.end()) {
      return "point " + shortest(turn[1]) + " follows " + shortest(turn[0]) +
             "; expected ascending points";
    }
  }
  return "";
}

Complaint complaint(const LutMatrix& lut) {
  if (lut.matrix.allFinite() && lut.offset.allFinite()) return "";
  return "matrix with a number that is not finite";
}

LutRange range_of(const Lut1D& lut) { return lut.range; }
LutRange range_of(const Lut3D& lut) { return lut.range; }
LutRange range_of(const LutMatrix&) { return {}; }
LutRange range_of(const LutPoints& lut) {
  LutRange range;
  for (std::size_t c = 0; c < 3; ++c) {
    range.low[c] = lut.curves[c].in.front();
    range.high[c] = lut.curves[c].in.back();
  }
  return range;
}

}  // namespace

std::size_t curve_samples(int size) {
  const Complaint wrong = size_complaint("curves", size, kMostCurveSize);
  if (!wrong.empty()) throw std::invalid_argument("lut: " + wrong);
  return 3 * static_cast<std::size_t>(size);
}

std::size_t cube_samples(int size) {
  const Complaint wrong = size_complaint("cube", size, kMostCubeSize);
  if (!wrong.empty()) throw std::invalid_argument("lut: " + wrong);
  const auto n = static_cast<std::size_t>(size);
  return 3 * n * n * n;
}

void check(const Lut& lut) {
  for (std::size_t i = 0; i < lut.steps.size(); ++i) {
    const Complaint wrong =
        std::visit([](const auto& step) { return complaint(step); }, lut.steps[i]);
    if (wrong.empty()) continue;
    throw std::invalid_argument("lut: step " + std::to_string(i + 1) + ": " + wrong);
  }
}

LutRange input_range(const Lut& lut) {
  if (lut.steps.empty()) return {};
  return std::visit([](const auto& step) { return range_of(step); }, lut.steps.front());
}

Rgb tetrahedral(const Lut3D& cube, Rgb rgb) noexcept {
  const Cell at = cell(cube, rgb);
  // From the lowest corner to the highest along the axes, that of the largest fraction first.
  std::size_t axis[3] = {0, 1, 2};
  const auto before = [&](std::size_t a, std::size_t b) { return at.fraction[a] > at.fraction[b]; };
  if (before(axis[1], axis[0])) std::swap(axis[0], axis[1]);
  if (before(axis[2], axis[1])) std::swap(axis[1], axis[2]);
  if (before(axis[1], axis[0])) std::swap(axis[0], axis[1]);
  const float* corner = at.corner;
  double rest = 1;
  Rgb out;
  for (const std::size_t a : axis) {
    out = sum(out, rest - at.fraction[a], corner);
    rest = at.fraction[a];
    corner += at.step[a];
  }
  return sum(out, rest, corner);
}

Rgb trilinear(const Lut3D& cube, Rgb rgb) noexcept {
  const Cell at = cell(cube, rgb);
  Rgb out;
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1;
    const float* point = at.corner;
    for (int c = 0; c < 3; ++c) {
      const bool upper = (corner >> c & 1) != 0;
      weight *= upper ? at.fraction[c] : 1 - at.fraction[c];
      if (upper) point += at.step[c];
    }
    out = sum(out, weight, point);
  }
  return out;
}

Rgb evaluate(const LutStep& step, Rgb rgb, const LutInterpolation& interpolation) noexcept {
  return std::visit([&](const auto& s) { return evaluate_step(s, rgb, interpolation); }, step);
}

Rgb evaluate(const Lut& lut, Rgb rgb, const LutInterpolation& interpolation) noexcept {
  for (const LutStep& step : lut.steps) rgb = evaluate(step, rgb, interpolation);
  return rgb;
}

double evaluate(const LutCurve& curve, double x) noexcept {
  if (!(x > curve.in.front())) return curve.out.front();  // NaN too
  if (x >= curve.in.back()) return curve.out.back();
  const auto upper = std::upper_bound(curve.in.begin(), curve.in.end(), x,
                                      [](double value, float point) { return value < point; });
  const auto i = static_cast<std::size_t>(upper - curve.in.begin());
  const double below = curve.in[i - 1];
  return mix(curve.out[i - 1], curve.out[i], (x - below) / (curve.in[i] - below));
}

}  // namespace tristim
