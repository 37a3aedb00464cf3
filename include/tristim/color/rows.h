#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "tristim/color/conversion.h"

namespace tristim {

struct RowOptions {
  bool keep_undefined = false;  // components without a value, such as a grey's hue: NaN, else 0
};

/// A conversion between two models for rows of float pixels, the same bits in every instruction
/// set.
///
/// It takes the way of a ColorConversion and computes in double, so a row differs from the double
/// functions by the rounding to float: at most 0.52 units in the last place of the largest term.
/// From RGB to HSV and HLS, and from XYZ and linear RGB to Lab, Luv and Oklab, colours that a
/// display can show take floats: 1.5 units in the last place, roots 2, Lab and Luv 4e-5.
/// docs/accuracy.md has the measured errors. NaN and infinities pass as they do there; the hue is
/// below 360 in float as well. Copies share what they hold, and any number of threads may use one.
class RowConversion {
 public:
  /// Throws as ColorConversion does, and Error (kMisuse) where a model's colours are words.
  RowConversion(const ModelReference& from, const ModelReference& to, Adaptation adaptation,
                RowOptions options = {});

  /// Converts interleaved pixels of `in_channels` numbers to pixels of `out_channels`: the model's
  /// components, then alpha where there is room. Alpha is carried over, 1 where there was none;
  /// channels behind it are left alone. `in` and `out` may be the same memory where they have the
  /// same channels, else they must not overlap. Throws std::invalid_argument where a model has more
  /// components than there are channels, or where the rows differ in length.
  void operator()(std::span<const float> in, std::size_t in_channels, std::span<float> out,
                  std::size_t out_channels) const;

  const ColorConversion& conversion() const noexcept { return conversion_; }

 private:
  struct Program;

  ColorConversion conversion_;
  std::shared_ptr<const Program> program_;
};

}  // namespace tristim
