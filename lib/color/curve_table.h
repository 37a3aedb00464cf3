#pragma once

#include <cstddef>
#include <vector>

namespace tristim::detail {

/// A smooth monotone curve on [0, 1] as straight lines between nodes that are 1/128 octave apart,
/// for places where 1e-5 is enough: choosing and mixing, never a code. The same bits everywhere.
class CurveTable {
 public:
  explicit CurveTable(double (*curve)(double) noexcept);

  /// Below 0 and NaN: the value at 0; above 1: the value at 1.
  float operator()(float x) const noexcept;

 private:
  float at_zero_, at_one_;
  std::vector<float> value_;
  std::vector<float> slope_;
};

/// The sRGB curve and its inverse.
const CurveTable& srgb_encode_table();
const CurveTable& srgb_decode_table();

}  // namespace tristim::detail
