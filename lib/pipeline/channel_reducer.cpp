#include "lib/pipeline/channel_reducer.h"

#include <cstddef>

#include "lib/color/curve_table.h"

namespace tristim::detail {

ChannelReducer channel_reducer(const LevelScale& scale, const ReduceOptions& options,
                               const ThresholdMatrix* matrix, int channel, int width) {
  if (std::holds_alternative<NoDither>(options.dither)) {
    return NearestLevel(scale.threshold, scale.nearest);
  }
  MixLevels levels{scale.light, scale.code};
  to_mix(options.mix, {levels.light.data(), static_cast<int>(levels.light.size()), 1});
  if (matrix != nullptr) return OrderedDither(levels, *matrix);
  if (const auto* whole = std::get_if<WholePictureDither>(&options.dither)) {
    return WholeChannel{whole, std::move(levels)};
  }
  const auto& kernel = std::get<DiffusionKernel>(options.dither);
  return LevelDiffusion(levels, width, diffusion_options(kernel, options.parameters, channel));
}

void to_mix(Mix mix, ChannelRow<float> row) noexcept {
  if (mix == Mix::kLight) return;
  const CurveTable& encode = srgb_encode_table();
  for (int x = 0; x < row.width; ++x) row[x] = encode(row[x]);
}

void reduce_row(ChannelReducer& reducer, Mix mix, ChannelRow<float> in, int y,
                ChannelRow<std::uint16_t> out, std::span<const float> strength, int x) {
  const ChannelRow<const float> light{in.data, in.width, in.step};
  if (auto* nearest = std::get_if<NearestLevel>(&reducer)) return nearest->row(light, out);
  to_mix(mix, in);
  if (auto* ordered = std::get_if<OrderedDither>(&reducer)) {
    return ordered->row(light, y, out, strength, x);
  }
  std::get<LevelDiffusion>(reducer).row(light, out, strength);
}

std::vector<float> row_strength(const Band& band, int row, float strength) {
  const ImageView<const float>& mask = band.dither_mask;
  if (mask.data == nullptr && strength == 1) return {};
  std::vector<float> all(static_cast<std::size_t>(band.view.width), strength);
  if (mask.data == nullptr) return all;
  const std::span<const float> of_mask = mask.row(row);
  for (std::size_t x = 0; x < all.size(); ++x) all[x] *= of_mask[x];
  return all;
}

}  // namespace tristim::detail
