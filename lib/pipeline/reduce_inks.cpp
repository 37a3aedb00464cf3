#include "lib/pipeline/reduce_inks.h"

#include <algorithm>
#include <cstddef>

namespace tristim::detail {
namespace {

// An ink lies on a dot (1) or leaves the paper bare.
LevelScale ink_scale() { return {{0, 1}, {1, 0}, {0.5F}, {1, 0}}; }

}  // namespace

InkReducer::InkReducer(const Display& display, const ReduceOptions& options, int width)
    : options_(&options), planes_(display, options.black_point) {
  const std::vector<ThresholdMatrix> matrices =
      dither_matrices(options.dither, options.parameters, planes_.count());
  for (int i = 0; i < planes_.count(); ++i) {
    const ThresholdMatrix* matrix =
        matrices.empty() ? nullptr : &matrices[static_cast<std::size_t>(i)];
    inks_.push_back(channel_reducer(ink_scale(), options, matrix, i, width));
  }
}

void InkReducer::reduce(Band band, ImageView<std::uint16_t> codes) {
  const int width = band.view.width;
  const auto size = static_cast<std::size_t>(width);
  std::vector<float> planes(size * inks_.size());
  std::vector<std::uint16_t> inked(size);
  for (int row = 0; row < band.view.height; ++row) {
    const std::vector<float> strength = row_strength(band, row, options_->parameters.strength);
    const std::span<std::uint16_t> out = codes.row(row);
    planes_.row(band.view.row(row), planes);
    std::ranges::fill(out, std::uint16_t{0});
    for (std::size_t i = 0; i < inks_.size(); ++i) {
      reduce_row(inks_[i], options_->mix, {planes.data() + i * size, width, 1}, band.y0 + row,
                 {inked.data(), width, 1}, strength);
      for (std::size_t x = 0; x < size; ++x) {
        out[x] = static_cast<std::uint16_t>(out[x] | inked[x] << i);
      }
    }
  }
}

}  // namespace tristim::detail
