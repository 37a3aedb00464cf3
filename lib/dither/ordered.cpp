#include "tristim/dither/ordered.h"

#include <algorithm>
#include <vector>

#include "lib/dither/ordered_kernels.h"

namespace tristim {

struct OrderedDither::State {
  detail::OrderedLevels levels;
  const detail::OrderedKernels* kernels;
  ThresholdMatrix tile;  // without its ranks
  std::size_t period, stride;
  std::vector<float> least;  // rows as OrderedRow wants them

  State(const MixLevels& mix, const ThresholdMatrix& matrix)
      : levels(mix, matrix.ranks),
        kernels(levels.way == detail::LevelsWay::kSearch ? &detail::scalar_ordered_kernels()
                                                         : &detail::ordered_kernels()),
        tile{.width = matrix.width, .height = matrix.height, .shift = matrix.shift} {
    const auto width = static_cast<std::size_t>(matrix.width);
    period = (detail::kMostLanes + width - 1) / width * width;
    stride = period + detail::kMostLanes;
    least.reserve(static_cast<std::size_t>(matrix.height) * stride);
    for (int y = 0; y < matrix.height; ++y) {
      for (std::size_t i = 0; i < stride; ++i) least.push_back(matrix.row(y)[i % width] + 0.5F);
    }
  }

  detail::OrderedRow row(int x, int y) const noexcept {
    const auto tile_row = static_cast<std::size_t>(y % tile.height);
    const auto column = static_cast<std::size_t>(tile.column(y)) + static_cast<std::size_t>(x);
    return {&levels, least.data() + tile_row * stride, period, column % period};
  }
};

OrderedDither::OrderedDither(const MixLevels& levels, const ThresholdMatrix& matrix)
    : state_(std::make_shared<const State>(levels, matrix)) {}

void OrderedDither::row(ChannelRow<const float> in, int y, ChannelRow<std::uint16_t> out,
                        std::span<const float> strength, int x0) const {
  const auto count = static_cast<std::size_t>(in.width);
  const float* part = strength.empty() ? nullptr : strength.data();
  const detail::OrderedRow row = state_->row(x0, y);
  if (in.step == 1 && out.step == 1) {
    return state_->kernels->row(row, in.data, part, count, out.data);
  }
  std::vector<float> light(count);
  std::vector<std::uint16_t> codes(count);
  for (int x = 0; x < in.width; ++x) light[static_cast<std::size_t>(x)] = in[x];
  state_->kernels->row(row, light.data(), part, count, codes.data());
  for (int x = 0; x < in.width; ++x) out[x] = codes[static_cast<std::size_t>(x)];
}

}  // namespace tristim
