#include "lib/lut/curve_rows.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace tristim::detail {
namespace {

constexpr std::int64_t kMostStarts = 1 << 14;

// Integers that ascend as floats do; -0 and 0 have one.
std::int64_t key(float x) noexcept {
  const auto bits = std::bit_cast<std::int32_t>(x);
  return bits >= 0 ? std::int64_t{bits} : std::int64_t{INT32_MIN} - bits;
}

}  // namespace

CurveRow::CurveRow(const Lut1D& lut) : rgb_(lut.rgb), last_(lut.size - 1), low_(lut.range.low) {
  for (std::size_t c = 0; c < 3; ++c) per_unit_[c] = last_ / (lut.range.high[c] - low_[c]);
}

void CurveRow::operator()(const float* in, float* out, std::size_t count) const noexcept {
  for (std::size_t i = 0; i < count; ++i, in += 3, out += 3) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double along = (in[c] - low_[c]) * per_unit_[c];
      const double position = along > 0 ? std::min(along, last_) : 0;  // NaN becomes 0
      const auto index =
          std::min(static_cast<std::int32_t>(position), static_cast<std::int32_t>(last_) - 1);
      const double fraction = position - index;
      const float* entry = rgb_.data() + 3 * static_cast<std::size_t>(index) + c;
      out[c] = static_cast<float>((1 - fraction) * entry[0] + fraction * entry[3]);
    }
  }
}

PointSearch::PointSearch(LutCurve curve)
    : curve_(std::move(curve)), first_key_(key(curve_.in.front())) {
  const std::int64_t span = key(curve_.in.back()) - first_key_;
  while (span >> shift_ >= kMostStarts) ++shift_;
  start_.resize(static_cast<std::size_t>(span >> shift_) + 1);
  std::uint32_t point = 0;
  for (std::size_t i = 0; i < start_.size(); ++i) {
    const std::int64_t begin = first_key_ + (static_cast<std::int64_t>(i) << shift_);
    while (point + 2 < curve_.in.size() && key(curve_.in[point + 1]) <= begin) ++point;
    start_[i] = point;
  }
}

float PointSearch::operator()(float x) const noexcept {
  const std::vector<float>& in = curve_.in;
  const std::vector<float>& out = curve_.out;
  if (!(x > in.front())) return out.front();  // NaN too
  if (x >= in.back()) return out.back();
  std::size_t i = start_[static_cast<std::size_t>((key(x) - first_key_) >> shift_)];
  while (in[i + 1] <= x) ++i;
  const double below = in[i];
  const double fraction = (x - below) / (in[i + 1] - below);
  return static_cast<float>((1 - fraction) * out[i] + fraction * out[i + 1]);
}

PointsRow::PointsRow(const LutPoints& lut)
    : curves_{PointSearch(lut.curves[0]), PointSearch(lut.curves[1]), PointSearch(lut.curves[2])} {}

void PointsRow::operator()(const float* in, float* out, std::size_t count) const noexcept {
  for (std::size_t i = 0; i < 3 * count; i += 3) {
    for (std::size_t c = 0; c < 3; ++c) out[i + c] = curves_[c](in[i + c]);
  }
}

}  // namespace tristim::detail
