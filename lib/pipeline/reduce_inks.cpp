#include "lib/pipeline/reduce_inks.h"

#include <algorithm>
#include <cstddef>

namespace tristim::detail {
namespace {

// An ink lies on a dot (1) or leaves the paper bare.
LevelScale ink_scale() { return {{0, 1}, {1, 0}, {0.5F}, {1, 0}}; }

// Ink `i` on the dots of a row.
void lay_ink(std::span<const std::uint16_t> inked, std::size_t i, std::span<std::uint16_t> codes) {
  for (std::size_t x = 0; x < codes.size(); ++x) {
    codes[x] = static_cast<std::uint16_t>(codes[x] | inked[x] << i);
  }
}

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

// A method for whole pictures sees one ink after the other, each with chances of its own.
void InkReducer::reduce_whole(const Band& band, ImageView<std::uint16_t> codes, int threads) {
  const int width = band.view.width;
  const int height = band.view.height;
  const auto size = static_cast<std::size_t>(width);
  const DitherParameters& told = options_->parameters;
  std::vector<Image> planes;
  for (std::size_t i = 0; i < inks_.size(); ++i) planes.emplace_back(width, height, 1);
  std::vector<float> of_row(size * inks_.size());
  for (int y = 0; y < height; ++y) {
    planes_.row(band.view.row(y), of_row);
    for (std::size_t i = 0; i < inks_.size(); ++i) {
      const std::span<float> row = planes[i].view().row(y);
      std::copy_n(of_row.data() + i * size, size, row.begin());
      to_mix(options_->mix, {row.data(), width, 1});
    }
  }
  Raster<std::uint16_t> inked(width, height, 1);
  for (int y = 0; y < height; ++y) std::ranges::fill(codes.row(y), std::uint16_t{0});
  for (std::size_t i = 0; i < inks_.size(); ++i) {
    const auto& whole = std::get<WholeChannel>(inks_[i]);
    whole.dither->channel(planes[i].view(), whole.levels,
                          {told.seed + i, told.effort, told.strength, band.dither_mask, threads},
                          inked.view());
    for (int y = 0; y < height; ++y) lay_ink(inked.view().row(y), i, codes.row(y));
  }
}

void InkReducer::reduce(Band band, ImageView<std::uint16_t> codes, int threads) {
  if (std::holds_alternative<WholeChannel>(inks_.front())) {
    return reduce_whole(band, codes, threads);
  }
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
      lay_ink(inked, i, out);
    }
  }
}

}  // namespace tristim::detail
