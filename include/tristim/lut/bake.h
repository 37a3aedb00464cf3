#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "tristim/color/lab.h"
#include "tristim/lut/lut.h"

namespace tristim {

/// What a LUT is baked from: a map of colours, and what its results look like.
class BakeSource {
 public:
  virtual ~BakeSource() = default;

  /// Changes colours to what the exact map makes of them. Called by several threads at once.
  virtual void apply(std::span<Rgb> colors) const = 0;

  /// A result as L*a*b*, for differences in CIEDE2000. Likewise.
  virtual Lab appearance(Rgb result) const = 0;
};

/// Any two callables as a source: Rgb map(Rgb) and Lab look(Rgb).
template <typename Map, typename Look>
class CallableSource final : public BakeSource {
 public:
  CallableSource(Map map, Look look) : map_(std::move(map)), look_(std::move(look)) {}
  void apply(std::span<Rgb> colors) const override {
    for (Rgb& color : colors) color = map_(color);
  }
  Lab appearance(Rgb result) const override { return look_(result); }

 private:
  Map map_;
  Look look_;
};

/// Where a LUT is sampled: equal steps over `range`, or of what `shaper` makes of it.
struct BakeGrid {
  LutRange range;
  std::optional<LutStep> shaper;  // a Lut1D or LutPoints that rises throughout, from 0 to 1
};

/// Curves at equal steps over the grid's range, from what the source makes of greys. Every entry is
/// the source's double rounded once. Throws std::invalid_argument where `size` is out of bounds or
/// a result is not finite.
Lut1D bake_curves(const BakeSource& source, const LutRange& range, int size, int threads = 0);

/// A cube, behind the grid's shaper where it has one; likewise. Points are where the shaper's own
/// table, not its formula, puts them.
Lut bake_cube(const BakeSource& source, const BakeGrid& grid, int size, int threads = 0);

/// How far a LUT is from what it was baked from.
struct BakeError {
  double largest = 0, mean = 0;  // CIEDE2000
  Rgb worst;                     // the input of the largest
  std::uint64_t colors = 0;      // how many were compared
};

/// Compares over 40 x 40 x 40 colours at equal steps of the grid and as many by chance, among them
/// such that have one or two channels at the low end, and some at equal steps of the input. Always
/// the same ones. NaN counts as infinite.
BakeError bake_error(const BakeSource& source, const Lut& lut, const BakeGrid& grid,
                     const LutInterpolation& interpolation = kLutInterpolations[0],
                     int threads = 0);

/// Compares at `inputs`.
BakeError bake_error(const BakeSource& source, const Lut& lut, const std::vector<Rgb>& inputs,
                     const LutInterpolation& interpolation = kLutInterpolations[0],
                     int threads = 0);

/// The same along greys alone, 4096 of them.
BakeError grey_error(const BakeSource& source, const Lut& lut, const BakeGrid& grid,
                     const LutInterpolation& interpolation = kLutInterpolations[0],
                     int threads = 0);

/// The largest difference that a cube of `size` points would have at `inputs`, without baking it.
double cube_error(const BakeSource& source, const BakeGrid& grid, int size,
                  std::span<const Rgb> inputs,
                  const LutInterpolation& interpolation = kLutInterpolations[0], int threads = 0);

/// The least size of a cube whose largest difference is `most`, as far as some thousand colours
/// tell; nothing where kMostCubeSize does not reach it.
std::optional<int> cube_size_for(const BakeSource& source, const BakeGrid& grid, double most,
                                 const LutInterpolation& interpolation = kLutInterpolations[0],
                                 int threads = 0);

}  // namespace tristim
