#include "lib/pipeline/reduce_palette.h"

#include <span>
#include <stdexcept>

#include "lib/pipeline/channel_reducer.h"
#include "tristim/color/primaries.h"

namespace tristim::detail {
namespace {

Eigen::Matrix3d srgb_from(const Display& display) {
  return rgb_from_rgb(Primaries{}, display.primaries, Adaptation::kBradford);
}

std::unique_ptr<const MixPalette> mix_palette(const Display& display,
                                              const ReduceOptions& options) {
  if (display.palette.empty()) {
    throw std::invalid_argument("display: an indexed packing needs a palette");
  }
  const Eigen::Matrix3d to_srgb = srgb_from(display);
  std::vector<Rgb> entries;
  for (const Rgb& c : palette_light(display, options.black_point)) {
    const Eigen::Vector3d srgb = to_srgb * Eigen::Vector3d(c.r, c.g, c.b);
    entries.push_back({srgb.x(), srgb.y(), srgb.z()});
  }
  return std::make_unique<const MixPalette>(
      entries, options.metric, options.mix,
      display.palette_has_white ? Beyond::kMoved : Beyond::kDamped);
}

void multiply(const Eigen::Matrix3f& matrix, std::span<float> rgb) {
  if (matrix.isIdentity(0)) return;
  for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) {
    const Eigen::Vector3f c = matrix * Eigen::Vector3f(rgb[i], rgb[i + 1], rgb[i + 2]);
    for (std::size_t k = 0; k < 3; ++k) rgb[i + k] = c[static_cast<Eigen::Index>(k)];
  }
}

}  // namespace

PaletteReducer::PaletteReducer(const Display& display, const ReduceOptions& options, int width)
    : options_(&options),
      palette_(mix_palette(display, options)),
      srgb_from_device_(srgb_from(display).cast<float>()) {
  const std::vector<ThresholdMatrix> matrices =
      dither_matrices(options.dither, options.parameters, 1);
  if (!matrices.empty()) ordered_.emplace(*palette_, matrices.front());
  if (const auto* kernel = std::get_if<DiffusionKernel>(&options.dither)) {
    diffusion_.emplace(*palette_, width, diffusion_options(*kernel, options.parameters));
  }
}

void PaletteReducer::reduce(Band band, ImageView<std::uint16_t> indices, int threads) {
  for (int row = 0; row < band.view.height; ++row) multiply(srgb_from_device_, band.view.row(row));
  const float whole = options_->parameters.strength;
  if (diffusion_ && whole == 1 && band.dither_mask.data == nullptr) {
    return diffusion_->rows(band.view, indices, threads);
  }
  for (int row = 0; row < band.view.height; ++row) {
    const std::span<const float> rgb = band.view.row(row);
    const std::span<std::uint16_t> out = indices.row(row);
    const std::vector<float> strength = row_strength(band, row, whole);
    if (diffusion_) {
      diffusion_->row(rgb, out, strength);
    } else if (ordered_) {
      ordered_->row(band.y0 + row, rgb, out, strength);
    } else {
      palette_nearest_row(*palette_, rgb, out);
    }
  }
}

}  // namespace tristim::detail
