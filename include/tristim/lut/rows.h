#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "tristim/image/view.h"
#include "tristim/lut/lut.h"

namespace tristim {

/// A LUT for rows of float pixels, the same bits in every instruction set.
///
/// Each step differs from its double definition by 2e-7 at most where its entries are in [-1, 1],
/// else by as much of the largest; what goes from one step to the next is floats. Copies share what
/// they hold, and any number of threads may use one.
class LutRows {
 public:
  /// Throws std::invalid_argument as check() does.
  explicit LutRows(const Lut& lut, const LutInterpolation& interpolation = kLutInterpolations[0]);

  /// Takes interleaved pixels of `channels` floats, 3 or more, to as many; channels behind the
  /// third are carried over. `in` and `out` may be the same memory, else they must not overlap.
  /// Throws std::invalid_argument for fewer channels, for rows of different length or of part of a
  /// pixel.
  void operator()(std::span<const float> in, std::span<float> out, std::size_t channels = 3) const;

 private:
  struct Program;
  std::shared_ptr<const Program> program_;
};

/// Takes a picture of 3 channels or more through a LUT, on up to `threads` threads (0: one for each
/// processor); the result does not depend on how many. `in` and `out` may be the same picture.
/// Throws std::invalid_argument where they differ in size or channels.
void apply(const LutRows& lut, ImageView<const float> in, ImageView<float> out, int threads = 0);

}  // namespace tristim
