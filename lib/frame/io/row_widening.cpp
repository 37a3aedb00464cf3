#include "lib/frame/io/row_widening.h"

#include <algorithm>

#include "lib/frame/io/file_sink.h"

namespace tristim::detail {

RowWidening::RowWidening(const FrameInfo& frame, int depth) {
  const Packing& packing = frame.layout.packing;
  const auto samples = static_cast<std::size_t>(packing.samples);
  const bool deep = std::all_of(packing.bits.begin(), packing.bits.begin() + packing.samples,
                                [&](int bits) { return bits == depth; });
  if (deep) return;
  samples_ = samples;
  for (std::size_t k = 0; k < samples; ++k) {
    for (unsigned code = 0; code <= max_code(packing.bits[k]); ++code) {
      wide_[k].push_back(widen(code, packing.bits[k], depth));
    }
  }
}

std::span<const std::uint16_t> RowWidening::operator()(std::span<const std::uint16_t> codes) {
  if (samples_ == 0) return codes;
  row_.resize(codes.size());
  for (std::size_t k = 0; k < samples_; ++k) {
    for (std::size_t i = k; i < codes.size(); i += samples_) row_[i] = wide_[k][codes[i]];
  }
  return row_;
}

}  // namespace tristim::detail
