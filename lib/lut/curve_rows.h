#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tristim/lut/lut.h"

namespace tristim::detail {

/// Curves at equal steps, ready for rows of three interleaved channels. `in` and `out` of its rows
/// may be the same.
class CurveRow {
 public:
  explicit CurveRow(const Lut1D& lut);
  void operator()(const float* in, float* out, std::size_t count) const noexcept;

 private:
  std::vector<float> rgb_;
  double last_;
  std::array<double, 3> low_, per_unit_;
};

/// A curve through points, with a table of where to begin to look for the next lower one.
class PointSearch {
 public:
  explicit PointSearch(LutCurve curve);
  float operator()(float x) const noexcept;

 private:
  LutCurve curve_;
  std::int64_t first_key_;
  int shift_ = 0;
  std::vector<std::uint32_t> start_;  // by the leading bits of the input
};

/// Curves through points, for rows likewise.
class PointsRow {
 public:
  explicit PointsRow(const LutPoints& lut);
  void operator()(const float* in, float* out, std::size_t count) const noexcept;

 private:
  std::array<PointSearch, 3> curves_;
};

}  // namespace tristim::detail
