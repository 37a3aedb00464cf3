#include "lib/lut/grid_points.h"

#include <cstdint>
#include <random>
#include <stdexcept>

namespace tristim::detail {
namespace {

constexpr int kSteps = 40;  // of the dense grid: their multiples meet few points of usual cubes

LutPoints inverse_of(const LutStep& shaper) {
  if (const auto* curves = std::get_if<Lut1D>(&shaper)) return invert(*curves);
  if (const auto* points = std::get_if<LutPoints>(&shaper)) return invert(*points);
  throw std::invalid_argument("bake: a shaper is made of curves");
}

double along(const LutRange& range, std::size_t channel, double at) {
  const double low = range.low[channel];
  const double high = range.high[channel];
  return at == 1 ? high : low + (high - low) * at;
}

Rgb spread(const LutRange& range, Rgb at) {
  return {along(range, 0, at.r), along(range, 1, at.g), along(range, 2, at.b)};
}

// Numbers by chance, the same with every standard library.
class Chance {
 public:
  double operator()() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

  // A colour, one time in four with a channel or two of them at the low end.
  Rgb color() {
    Rgb at{(*this)(), (*this)(), (*this)()};
    const std::uint64_t kind = random_() >> 60;
    if (kind == 0 || kind == 1) at.r = 0;
    if (kind == 1 || kind == 2) at.g = 0;
    if (kind == 2 || kind == 3) at.b = 0;
    return at;
  }

 private:
  std::mt19937_64 random_{1976};
};

}  // namespace

GridPoints::GridPoints(const BakeGrid& grid) : range_(grid.range), shaper_(grid.shaper) {
  if (shaper_) inverse_ = inverse_of(*shaper_);
}

Rgb GridPoints::input(Rgb at) const noexcept {
  return inverse_ ? evaluate(*inverse_, at) : spread(range_, at);
}

Rgb GridPoints::place(Rgb input) const noexcept {
  if (shaper_) return evaluate(*shaper_, input);
  const auto part = [&](std::size_t c, double x) {
    return (x - range_.low[c]) / (range_.high[c] - range_.low[c]);
  };
  return {part(0, input.r), part(1, input.g), part(2, input.b)};
}

std::vector<Rgb> chance_inputs(const GridPoints& points, const LutRange& range, std::size_t count) {
  std::vector<Rgb> inputs;
  Chance chance;
  for (std::size_t i = 0; i < count; ++i) {
    const Rgb at = chance.color();
    inputs.push_back(i % 4 == 0 ? spread(range, at) : points.input(at));
  }
  return inputs;
}

std::vector<Rgb> many_inputs(const GridPoints& points, const LutRange& range) {
  std::vector<Rgb> inputs;
  const auto at = [](int i) { return i / (kSteps - 1.0); };
  for (int b = 0; b < kSteps; ++b) {
    for (int g = 0; g < kSteps; ++g) {
      for (int r = 0; r < kSteps; ++r) inputs.push_back(points.input({at(r), at(g), at(b)}));
    }
  }
  const std::vector<Rgb> more = chance_inputs(points, range, inputs.size());
  inputs.insert(inputs.end(), more.begin(), more.end());
  return inputs;
}

std::vector<Rgb> grey_inputs(const GridPoints& points, std::size_t count) {
  std::vector<Rgb> inputs;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = static_cast<double>(i) / static_cast<double>(count - 1);
    inputs.push_back(points.input({at, at, at}));
  }
  return inputs;
}

}  // namespace tristim::detail
