#include "tristim/lut/invert.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>

#include "tristim/core/text.h"

namespace tristim {
namespace {

constexpr std::string_view kChannelNames[] = {"red", "green", "blue"};

// A point of a curve the other way round.
struct Point {
  float value;
  double input;
};

[[noreturn]] void refuse(std::size_t channel, const std::string& wrong) {
  throw std::invalid_argument("invert: the " + std::string(kChannelNames[channel]) + " curve " +
                              wrong);
}

// Throws where the values turn; whether they rise.
bool rises(std::span<const Point> points, std::size_t channel) {
  const float first = points.front().value;
  const float last = points.back().value;
  if (first == last)
    refuse(channel, "begins and ends at " + shortest(first) + ": it has no inverse");
  const bool rising = first < last;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const float before = points[i - 1].value;
    const float after = points[i].value;
    if (rising ? after >= before : after <= before) continue;
    refuse(channel, std::string(rising ? "rises" : "falls") +
                        " from end to end, but turns at entry " + std::to_string(i) + " from " +
                        shortest(before) + " to " + shortest(after) + ": it has no inverse");
  }
  return rising;
}

// The inverse of a curve whose points are in the order of their inputs.
LutCurve inverse(std::vector<Point> points, std::size_t channel) {
  if (!rises(points, channel)) std::reverse(points.begin(), points.end());
  LutCurve curve;
  const auto add = [&](float value, double input) {
    curve.in.push_back(value);
    curve.out.push_back(static_cast<float>(input));
  };
  for (std::size_t i = 0; i < points.size();) {
    const float value = points[i].value;
    std::size_t last = i;
    while (last + 1 < points.size() && points[last + 1].value == value) ++last;
    add(value, points[i].input);
    const float above = std::nextafter(value, std::numeric_limits<float>::infinity());
    const bool more = last + 1 < points.size();
    if (last > i && more && above < points[last + 1].value) add(above, points[last].input);
    i = last + 1;
  }
  return curve;
}

double input_of(const LutRange& range, std::size_t channel, int size, int entry) {
  const double low = range.low[channel];
  const double high = range.high[channel];
  return entry == size - 1 ? high : low + (high - low) * entry / (size - 1);
}

Rgb apply_step(const LutStep& step, Rgb rgb) noexcept { return evaluate(step, rgb); }
Rgb apply_step(const CubeInverse& step, Rgb rgb) noexcept { return step(rgb); }

LutStep inverse_step(const Lut1D& step) { return invert(step); }
LutStep inverse_step(const LutPoints& step) { return invert(step); }
LutStep inverse_step(const LutMatrix& step) { return invert(step); }
LutStep inverse_step(const Lut3D&) {
  throw std::invalid_argument("invert: a cube has no inverse as steps");
}

}  // namespace

LutPoints invert(const Lut1D& curves) {
  check({"", {curves}});
  LutPoints inverted;
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<Point> points;
    for (int i = 0; i < curves.size; ++i) {
      points.push_back({curves.rgb[3 * static_cast<std::size_t>(i) + c],
                        input_of(curves.range, c, curves.size, i)});
    }
    inverted.curves[c] = inverse(std::move(points), c);
  }
  return inverted;
}

LutPoints invert(const LutPoints& curves) {
  check({"", {curves}});
  LutPoints inverted;
  for (std::size_t c = 0; c < 3; ++c) {
    const LutCurve& curve = curves.curves[c];
    std::vector<Point> points;
    for (std::size_t i = 0; i < curve.in.size(); ++i) points.push_back({curve.out[i], curve.in[i]});
    inverted.curves[c] = inverse(std::move(points), c);
  }
  return inverted;
}

LutMatrix invert(const LutMatrix& matrix) {
  const Eigen::FullPivLU<Eigen::Matrix3d> lu(matrix.matrix);
  if (!lu.isInvertible()) throw std::invalid_argument("invert: the matrix has no inverse");
  LutMatrix inverted;
  inverted.matrix = lu.inverse();
  inverted.offset = -(inverted.matrix * matrix.offset);
  return inverted;
}

LutInverse::LutInverse(const Lut& lut) {
  check(lut);
  for (auto step = lut.steps.rbegin(); step != lut.steps.rend(); ++step) {
    if (const auto* cube = std::get_if<Lut3D>(&*step)) {
      steps_.emplace_back(CubeInverse(*cube));
    } else {
      steps_.emplace_back(std::visit([](const auto& s) { return inverse_step(s); }, *step));
    }
  }
}

Rgb LutInverse::operator()(Rgb rgb) const noexcept {
  for (const auto& step : steps_) {
    rgb = std::visit([&](const auto& s) { return apply_step(s, rgb); }, step);
  }
  return rgb;
}

bool inverts_exactly(const Lut& lut) noexcept {
  return std::none_of(lut.steps.begin(), lut.steps.end(),
                      [](const LutStep& step) { return std::holds_alternative<Lut3D>(step); });
}

Lut invert(const Lut& lut) {
  check(lut);
  Lut inverted{lut.title, {}};
  for (auto step = lut.steps.rbegin(); step != lut.steps.rend(); ++step) {
    inverted.steps.push_back(std::visit([](const auto& s) { return inverse_step(s); }, *step));
  }
  return inverted;
}

}  // namespace tristim
