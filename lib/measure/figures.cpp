#include "tristim/measure/figures.h"

#include <algorithm>
#include <cmath>

#include "tristim/core/text.h"
#include "tristim/measure/pixels.h"
#include "tristim/measure/vision.h"

namespace tristim {
namespace {

using List = std::vector<Figure>;

// As a display shows it.
Image within_range(ImageView<const float> light) {
  Image shown(light.width, light.height, light.channels);
  for (int y = 0; y < light.height; ++y) {
    std::transform(light.row(y).begin(), light.row(y).end(), shown.view().row(y).begin(),
                   [](float v) { return std::clamp(v, 0.0F, 1.0F); });
  }
  return shown;
}

void add_tone(const ToneFigures& tone, List& list) {
  list.push_back({"mean_lin_ref", tone.mean_reference});
  list.push_back({"mean_lin_out", tone.mean_result});
  list.push_back({"tone_rel", tone.relative});
  list.push_back({"tone_max", tone.lstar_max});
  list.push_back({"tone_mean", tone.lstar_mean});
}

void add_pixels(const PixelFigures& pixels, List& list) {
  list.push_back({"de00_mean", pixels.ciede2000_mean});
  list.push_back({"de00_p95", pixels.ciede2000_p95});
  list.push_back({"de00_max", pixels.ciede2000_max});
  list.push_back({"psnr", pixels.psnr_db, true});
  list.push_back({"max_abs", pixels.max_abs});
  list.push_back({"rms", pixels.rms});
}

// The first filter has no name of its own in the figures: hvs_snr@40, hvs_snr_campbell@40.
std::string snr_name(const VisionFilter& filter) {
  const bool first = &filter == &kVisionFilters[0];
  return first ? "hvs_snr" : "hvs_snr_" + std::string(filter.name);
}

void add_vision(const PicturePair& pictures, const LuminanceMap& reference,
                const LuminanceMap& result, const std::vector<double>& viewers, List& list) {
  std::vector<Viewing> viewings;
  for (const double samples : viewers) {
    for (const VisionFilter& filter : kVisionFilters) viewings.push_back({&filter, samples});
  }
  const std::vector<double> snr = hvs_snr(reference, result, viewings);
  std::size_t next = 0;
  for (const double samples : viewers) {
    const std::string at = "@" + shortest(samples);
    const VisibleDifference visible = scielab(pictures, samples);
    list.push_back({"scielab_mean" + at, visible.mean});
    list.push_back({"scielab_p95" + at, visible.p95});
    for (const VisionFilter& filter : kVisionFilters) {
      list.push_back({snr_name(filter) + at, snr[next++], true});
    }
  }
}

void add_texture(const std::optional<TextureFigures>& texture, List& list) {
  if (!texture) {
    list.push_back({"flat", 1});
    return;
  }
  list.push_back({"level", texture->level});
  list.push_back({"fg", texture->principal});
  list.push_back({"lf_frac", texture->low_share});
  list.push_back({"lf_white", texture->low_white});
  list.push_back({"aniso_db", texture->anisotropy_db});
  list.push_back({"peak_frac", texture->peak_share});
  list.push_back({"checker_frac", texture->checker_share});
  if (texture->minority) {
    list.push_back({"worm", texture->minority->worm});
    list.push_back({"nn_ratio", texture->minority->nearest_ratio});
    list.push_back({"nn_cv", texture->minority->nearest_cv});
  }
  list.push_back({"edge_bias", texture->edge_bias});
}

void add_patches(const std::vector<TonePoint>& patches, List& list) {
  double largest = 0;
  double sum = 0;
  for (const TonePoint& patch : patches) {
    const double difference = std::fabs(lstar_difference(patch));
    largest = std::max(largest, difference);
    sum += difference;
  }
  list.push_back({"patch_dL_max", largest});
  list.push_back({"patch_dL_mean", sum / static_cast<double>(patches.size())});
}

}  // namespace

Figures all_figures(const PicturePair& pictures, const FigureOptions& options) {
  const PixelFigures pixels = pixel_figures(pictures);  // checks the pair
  const Image reference_shown = within_range(pictures.reference);
  const Image result_shown = within_range(pictures.result);
  const PicturePair shown{reference_shown.view(), result_shown.view()};
  const LuminanceMap reference = luminance(shown.reference);
  const LuminanceMap result = luminance(shown.result);
  Figures figures;
  figures.tone = tone_figures(reference, result);
  add_tone(figures.tone, figures.list);
  add_pixels(pixels, figures.list);
  add_vision(shown, reference, result, options.samples_per_degree, figures.list);
  if (options.texture) {
    figures.texture = texture_figures(result);
    add_texture(figures.texture, figures.list);
  }
  if (options.patches > 0) {
    figures.patches = patch_tones(reference, result, options.patches);
    add_patches(figures.patches, figures.list);
  }
  return figures;
}

}  // namespace tristim
