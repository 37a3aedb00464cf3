#include "tristim/lut/compose.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace tristim {
namespace {

// Where the line from (x0, y0) to (x1, y1) passes points of `second`, from x0 to x1.
void add_passings(const LutCurve& second, double x0, double y0, double x1, double y1,
                  std::vector<float>& inputs) {
  const auto passing = [&](float y) {
    inputs.push_back(static_cast<float>(x0 + (x1 - x0) * ((y - y0) / (y1 - y0))));
  };
  const std::vector<float>& points = second.in;
  const auto first = std::upper_bound(points.begin(), points.end(), std::min(y0, y1));
  const auto last = std::lower_bound(first, points.end(), std::max(y0, y1));
  if (y0 < y1) {
    std::for_each(first, last, passing);
  } else {
    std::for_each(std::make_reverse_iterator(last), std::make_reverse_iterator(first), passing);
  }
}

std::optional<LutCurve> composed(const LutCurve& first, const LutCurve& second) {
  constexpr auto kMost = static_cast<std::size_t>(kMostCurveSize);
  std::vector<float> inputs = {first.in.front()};
  for (std::size_t i = 1; i < first.in.size(); ++i) {
    add_passings(second, first.in[i - 1], first.out[i - 1], first.in[i], first.out[i], inputs);
    inputs.push_back(first.in[i]);
    if (inputs.size() > kMost) return std::nullopt;
  }
  LutCurve curve;
  for (const float x : inputs) {
    if (!curve.in.empty() && x <= curve.in.back()) continue;  // rounded to the one before
    curve.in.push_back(x);
    curve.out.push_back(static_cast<float>(evaluate(second, evaluate(first, x))));
  }
  return curve;
}

LutMatrix compose(const LutMatrix& first, const LutMatrix& second) {
  LutMatrix both;
  both.matrix = second.matrix * first.matrix;
  both.offset = second.matrix * first.offset + second.offset;
  return both;
}

std::optional<LutPoints> curves_of(const LutStep& step) {
  if (const auto* curves = std::get_if<Lut1D>(&step)) return points_of(*curves);
  if (const auto* points = std::get_if<LutPoints>(&step)) return *points;
  return std::nullopt;
}

// Two steps as one, where that is possible.
std::optional<LutStep> joined(const LutStep& first, const LutStep& second) {
  const auto* a = std::get_if<LutMatrix>(&first);
  const auto* b = std::get_if<LutMatrix>(&second);
  if (a != nullptr && b != nullptr) return compose(*a, *b);
  const auto before = curves_of(first);
  const auto after = curves_of(second);
  if (!before || !after) return std::nullopt;
  if (auto both = tristim::compose(*before, *after)) return std::move(*both);
  return std::nullopt;
}

}  // namespace

LutPoints points_of(const Lut1D& curves) {
  LutPoints points;
  for (std::size_t c = 0; c < 3; ++c) {
    LutCurve& curve = points.curves[c];
    const double low = curves.range.low[c];
    const double high = curves.range.high[c];
    for (int i = 0; i < curves.size; ++i) {
      const bool last = i == curves.size - 1;
      const auto x = static_cast<float>(last ? high : low + (high - low) * i / (curves.size - 1));
      if (!curve.in.empty() && x <= curve.in.back()) continue;
      curve.in.push_back(x);
      curve.out.push_back(curves.rgb[3 * static_cast<std::size_t>(i) + c]);
    }
  }
  return points;
}

std::optional<LutPoints> compose(const LutPoints& first, const LutPoints& second) {
  LutPoints both;
  for (std::size_t c = 0; c < 3; ++c) {
    auto curve = composed(first.curves[c], second.curves[c]);
    if (!curve) return std::nullopt;
    both.curves[c] = std::move(*curve);
  }
  return both;
}

Lut compose(std::span<const Lut> luts) {
  Lut all;
  for (const Lut& lut : luts) {
    check(lut);
    if (!lut.title.empty()) all.title += (all.title.empty() ? "" : ", ") + lut.title;
    for (const LutStep& step : lut.steps) {
      auto both = all.steps.empty() ? std::nullopt : joined(all.steps.back(), step);
      if (both) {
        all.steps.back() = std::move(*both);
      } else {
        all.steps.push_back(step);
      }
    }
  }
  return all;
}

}  // namespace tristim
