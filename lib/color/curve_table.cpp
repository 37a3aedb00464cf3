#include "lib/color/curve_table.h"

#include <bit>
#include <cstdint>

#include "tristim/color/transfer.h"

namespace tristim::detail {
namespace {

constexpr int kShift = 16;
constexpr std::uint32_t kFirstBin =
    0x2f80;  // 2^-32: below it the curves are straight, or it does not matter
constexpr std::uint32_t kEndBin = 0x3f80;  // 1

float bin_start(std::uint32_t bin) { return std::bit_cast<float>(bin << kShift); }

}  // namespace

CurveTable::CurveTable(double (*curve)(double) noexcept)
    : at_zero_(static_cast<float>(curve(0))), at_one_(static_cast<float>(curve(1))) {
  double value = curve(bin_start(kFirstBin));
  for (std::uint32_t bin = kFirstBin; bin < kEndBin; ++bin) {
    const double next = curve(bin_start(bin + 1));
    value_.push_back(static_cast<float>(value));
    slope_.push_back(
        static_cast<float>((next - value) / (double{bin_start(bin + 1)} - bin_start(bin))));
    value = next;
  }
}

float CurveTable::operator()(float x) const noexcept {
  if (!(x > 0)) return at_zero_;
  if (x >= 1) return at_one_;
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(x) >> kShift;
  if (bits < kFirstBin) return at_zero_ + (value_[0] - at_zero_) * (x / bin_start(kFirstBin));
  const std::size_t i = bits - kFirstBin;
  return value_[i] + (x - bin_start(bits)) * slope_[i];
}

const CurveTable& srgb_encode_table() {
  static const CurveTable table(srgb_encode);
  return table;
}

const CurveTable& srgb_decode_table() {
  static const CurveTable table(srgb_decode);
  return table;
}

}  // namespace tristim::detail
