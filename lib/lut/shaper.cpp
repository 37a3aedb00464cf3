#include "tristim/lut/shaper.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lib/core/math.h"
#include "lib/lut/grid_points.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

constexpr std::size_t kFewProbes = 200;  // colours that all shapes are tried at
constexpr std::size_t kProbes = 2000;    // and the best of them
constexpr int kTrialEntries = 4096;      // larger tables are tried as so many points
constexpr std::size_t kFinalists = 4;

double log_encode(double x, double s) noexcept {
  return detail::log(1 + x * (detail::pow(2, s) - 1)) / (s * detail::log(2));
}
double log_decode(double y, double s) noexcept {
  return (detail::pow(2, s * y) - 1) / (detail::pow(2, s) - 1);
}
double power_encode(double x, double s) noexcept { return detail::pow(x, 1 / s); }
double power_decode(double y, double s) noexcept { return detail::pow(y, s); }

constexpr double kOctaves[] = {1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 20, 24};
constexpr double kExponents[] = {1.25, 1.5, 1.8, 2, 2.2, 2.4, 2.7, 3, 4, 5};

constexpr ShaperShape kShapes[] = {
    {"log", log_encode, log_decode, kOctaves, "log2(1 + x (2^s - 1))/s"},
    {"power", power_encode, power_decode, kExponents, "x^(1/s)"}};

// A channel's shape, odd about 0 and scaled so that its range becomes [0, 1].
class Channel {
 public:
  Channel(const Shaper& shaper, std::size_t c)
      : shaper_(&shaper),
        most_(std::max(std::fabs(shaper.range.low[c]), std::fabs(shaper.range.high[c]))),
        low_(shaper.range.low[c]),
        high_(shaper.range.high[c]),
        first_(odd(low_ / most_, shaper.shape->encode)),
        span_(odd(high_ / most_, shaper.shape->encode) - first_) {}

  double encode(double x) const {
    if (x == low_) return 0;
    if (x == high_) return 1;
    return (odd(x / most_, shaper_->shape->encode) - first_) / span_;
  }
  double decode(double y) const {
    if (y == 0) return low_;
    if (y == 1) return high_;
    return most_ * odd(first_ + span_ * y, shaper_->shape->decode);
  }

 private:
  double odd(double x, double (*f)(double, double) noexcept) const {
    return std::copysign(f(std::fabs(x), shaper_->strength), x);
  }

  const Shaper* shaper_;
  double most_, low_, high_, first_, span_;
};

Lut1D curves_of(const Shaper& shaper, int entries) {
  Lut1D curves{shaper.range, entries, std::vector<float>(curve_samples(entries))};
  for (std::size_t c = 0; c < 3; ++c) {
    const Channel channel(shaper, c);
    const double low = shaper.range.low[c];
    const double high = shaper.range.high[c];
    for (int i = 0; i < entries; ++i) {
      const double x = i == entries - 1 ? high : low + (high - low) * i / (entries - 1);
      curves.rgb[3 * static_cast<std::size_t>(i) + c] = static_cast<float>(channel.encode(x));
    }
  }
  return curves;
}

// Points at equal steps of the result; those that would be the one before in float are left out.
LutPoints points_of(const Shaper& shaper, int entries) {
  LutPoints points;
  for (std::size_t c = 0; c < 3; ++c) {
    const Channel channel(shaper, c);
    LutCurve& curve = points.curves[c];
    for (int i = 0; i < entries; ++i) {
      const auto in = static_cast<float>(channel.decode(static_cast<double>(i) / (entries - 1)));
      if (!curve.in.empty() && in <= curve.in.back()) continue;
      curve.in.push_back(in);
      curve.out.push_back(static_cast<float>(channel.encode(in)));
    }
    curve.out.back() = 1;
  }
  return points;
}

struct Trial {
  Shaper shaper;
  double error = 0;
};

}  // namespace

std::span<const ShaperShape> shaper_shapes() noexcept { return kShapes; }

LutStep shaper_step(const Shaper& shaper, int entries, bool points) {
  if (points) return points_of(shaper, entries);
  return curves_of(shaper, entries);
}

std::string describe(const Shaper& shaper) {
  if (shaper.shape == nullptr) return "none";
  return std::string(shaper.shape->name) + ", " + std::string(shaper.shape->formula) +
         ", s = " + shortest(shaper.strength);
}

Shaper choose_shaper(const BakeSource& source, const LutRange& range, int size, int entries,
                     bool points, const LutInterpolation& interpolation, int threads) {
  // Colours that favour no shape: at equal steps of a middling one, and of the input.
  const Shaper middling{&kShapes[0], 10, range};
  const bool as_points = points || entries > kTrialEntries;
  entries = std::min(entries, kTrialEntries);
  const detail::GridPoints places({range, shaper_step(middling, entries, as_points)});
  const auto error = [&](const Shaper& shaper, std::size_t probes) {
    BakeGrid grid{range, {}};
    if (shaper.shape != nullptr) grid.shaper = shaper_step(shaper, entries, as_points);
    const std::vector<Rgb> inputs = detail::chance_inputs(places, range, probes);
    return cube_error(source, grid, size, inputs, interpolation, threads);
  };
  std::vector<Trial> trials{{{nullptr, 1, range}, 0}};
  for (const ShaperShape& shape : kShapes) {
    for (const double strength : shape.strengths) trials.push_back({{&shape, strength, range}, 0});
  }
  const auto less = [](const Trial& a, const Trial& b) { return a.error < b.error; };
  for (Trial& trial : trials) trial.error = error(trial.shaper, kFewProbes);
  std::stable_sort(trials.begin(), trials.end(), less);
  trials.resize(std::min(trials.size(), kFinalists));
  for (Trial& trial : trials) trial.error = error(trial.shaper, kProbes);
  return std::min_element(trials.begin(), trials.end(), less)->shaper;
}

}  // namespace tristim
