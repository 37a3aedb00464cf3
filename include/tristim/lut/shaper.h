#pragma once

#include <span>
#include <string>
#include <string_view>

#include "tristim/lut/bake.h"

namespace tristim {

/// A curve from [0, 1] to [0, 1] that gives darks more room, the more the larger its strength.
struct ShaperShape {
  std::string_view name;
  double (*encode)(double x, double strength) noexcept;
  double (*decode)(double y, double strength) noexcept;
  std::span<const double> strengths;  // those that are tried
  std::string_view formula;           // with `s` for the strength
};

/// Every shape. The choice, the docs and the tests read this list.
std::span<const ShaperShape> shaper_shapes() noexcept;

/// A shape over a range; odd below 0.
struct Shaper {
  const ShaperShape* shape = nullptr;  // nullptr: none, equal steps of the input
  double strength = 1;
  LutRange range;
};

/// As a table of `entries` at equal steps of the input; or, with `points`, of the result, which is
/// better where the range is wide. Rises from 0 to 1. Throws std::invalid_argument where there are
/// so many entries that neighbours become one float.
LutStep shaper_step(const Shaper& shaper, int entries, bool points);

/// "log, s = 10", or "none".
std::string describe(const Shaper& shaper);

/// Which shaper brings a cube of `size` points nearest to the source: that of the least of the
/// largest differences among some hundred colours.
Shaper choose_shaper(const BakeSource& source, const LutRange& range, int size, int entries,
                     bool points, const LutInterpolation& interpolation = kLutInterpolations[0],
                     int threads = 0);

}  // namespace tristim
