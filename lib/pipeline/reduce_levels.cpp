#include "lib/pipeline/reduce_levels.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "lib/dither/planes.h"
#include "lib/pipeline/channel_planes.h"
#include "tristim/color/primaries.h"

namespace tristim::detail {
namespace {

// Light that a metric calls half way between two greys.
float metric_middle(const Metric& metric, double lower, double upper) {
  const auto distance2 = [&](double light, double to) {
    const auto a = metric.place({light, light, light});
    const auto b = metric.place({to, to, to});
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) sum += (double{a[c]} - b[c]) * (double{a[c]} - b[c]);
    return sum;
  };
  double low = lower;
  double high = upper;
  for (int i = 0; i < 40; ++i) {
    const double middle = (low + high) / 2;
    (distance2(middle, lower) <= distance2(middle, upper) ? low : high) = middle;
  }
  return static_cast<float>(high);
}

// The greys of a palette as levels; codes are positions in it.
LevelScale palette_scale(const Display& display, const ReduceOptions& options) {
  const std::vector<Rgb> palette = palette_light(display, options.black_point);
  const Eigen::RowVector3d weights = xyz_from_rgb(display.primaries).row(1);
  struct Grey {
    double light;
    std::uint16_t position;
  };
  std::vector<Grey> greys;
  for (const Rgb& c : palette) {
    greys.push_back(
        {weights * Eigen::Vector3d(c.r, c.g, c.b), static_cast<std::uint16_t>(greys.size())});
  }
  std::stable_sort(greys.begin(), greys.end(),
                   [](const Grey& a, const Grey& b) { return a.light < b.light; });
  LevelScale scale;
  for (const Grey& grey : greys) {
    const auto light = static_cast<float>(grey.light);
    if (!scale.light.empty() && !(light > scale.light.back())) continue;
    if (!scale.light.empty()) {
      scale.threshold.push_back(metric_middle(options.metric, scale.light.back(), light));
    }
    scale.light.push_back(light);
    scale.code.push_back(grey.position);
    scale.nearest.push_back(grey.position);
  }
  return scale;
}

LevelScale channel_scale(const Display& display, const ReduceOptions& options,
                         std::size_t channel) {
  if (!display.palette.empty()) return palette_scale(display, options);
  return level_scale(display, display.frame.packing.bits[channel], options.black_point,
                     static_cast<int>(channel));
}

// Whether it keeps nothing from pixel to pixel, so that channels may share one.
bool keeps_nothing(const ChannelReducer& channel) noexcept {
  return std::holds_alternative<NearestLevel>(channel) ||
         std::holds_alternative<OrderedDither>(channel);
}

}  // namespace

LevelReducer::LevelReducer(const Display& display, const ReduceOptions& options, int width)
    : options_(&options),
      luminance_(xyz_from_rgb(display.primaries).row(1).cast<float>()),
      tone_before_gain_(display.dots ? display.dots->gain : NoGain{}) {
  const int count = display.frame.packing.samples;
  const std::vector<ThresholdMatrix> matrices =
      dither_matrices(options.dither, options.parameters, count);
  const std::array<int, 3>& bits = display.frame.packing.bits;
  for (int c = 0; c < count; ++c) {
    const auto channel = static_cast<std::size_t>(c);
    const bool same_scale = c > 0 && has_one_response(display) && bits[channel] == bits[0];
    scales_.push_back(same_scale ? scales_.front() : channel_scale(display, options, channel));
    const ThresholdMatrix* matrix = matrices.empty() ? nullptr : &matrices[channel];
    const bool same_matrix = matrix == nullptr || matrix->rank == matrices.front().rank;
    if (same_scale && same_matrix && keeps_nothing(channels_.front())) {
      channels_.push_back(channels_.front());  // its tables are shared
    } else {
      channels_.push_back(channel_reducer(scales_.back(), options, matrix, c, width));
    }
  }
}

// The luminances of a row, in its first third; what dots gain is taken off.
std::span<float> LevelReducer::grey_row(std::span<float> rgb) const {
  const bool dithered = !std::holds_alternative<NoDither>(options_->dither);
  const std::span<float> grey = rgb.first(rgb.size() / 3);
  for (std::size_t x = 0; x < grey.size(); ++x) {  // x never overtakes 3 x
    const float* p = &rgb[3 * x];
    const float tone = luminance_[0] * p[0] + luminance_[1] * p[1] + luminance_[2] * p[2];
    grey[x] = dithered ? tone_before_gain_(tone) : tone;
  }
  return grey;
}

bool LevelReducer::leads() const noexcept {
  return !grey() && !std::holds_alternative<WholeChannel>(channels_[0]);
}

// Some hundred pixels go all the way while they lie in the nearest cache.
StageCounts LevelReducer::reduce_rgb_row(const RowLead& lead, std::span<const float> rgb, int y,
                                         std::span<std::uint16_t> out,
                                         std::span<const float> strength) {
  constexpr std::size_t kTogether = 512;
  alignas(64) std::array<std::array<float, kTogether>, 3> light;
  alignas(64) std::array<std::array<std::uint16_t, kTogether>, 3> code;
  StageCounts counts;
  for (std::size_t x = 0; 3 * x < rgb.size(); x += kTogether) {
    const std::size_t count = std::min(kTogether, rgb.size() / 3 - x);
    const auto width = static_cast<int>(count);
    counts += lead.split(rgb.subspan(3 * x, 3 * count),
                         {light[0].data(), light[1].data(), light[2].data()});
    for (std::size_t c = 0; c < 3; ++c) {
      const auto part = strength.empty() ? strength : strength.subspan(x, count);
      reduce_row(channels_[c], options_->mix, {light[c].data(), width, 1}, y,
                 {code[c].data(), width, 1}, part, static_cast<int>(x));
    }
    join_row({code[0].data(), code[1].data(), code[2].data()}, out.subspan(3 * x, 3 * count));
  }
  return counts;
}

StageCounts LevelReducer::prepare(const Band& band, const Lead& lead) const {
  const StageCounts counts = grey() ? StageCounts{} : split_rows(band.view, RowLead(lead));
  for (int y = 0; y < band.view.height; ++y) {
    const std::span<float> row = band.view.row(y);
    const std::span<float> light = grey() ? grey_row(row) : row;
    to_mix(options_->mix, {light.data(), static_cast<int>(light.size()), 1});
  }
  return counts;
}

void LevelReducer::advance(int channel, const Band& band, ImageView<std::uint16_t> codes,
                           int threads) {
  auto& diffusion = std::get<LevelDiffusion>(channels_[static_cast<std::size_t>(channel)]);
  const ImageView<const float> light = plane(band.view, channel);
  const ImageView<std::uint16_t> out = plane(codes, channel);
  const float strength = options_->parameters.strength;
  if (strength == 1 && band.dither_mask.data == nullptr) {
    return diffusion.rows(light, out, threads);
  }
  for (int y = 0; y < light.height; ++y) {
    diffusion.row({light.row(y).data(), light.width, 1}, {out.row(y).data(), out.width, 1},
                  row_strength(band, y, strength));
  }
}

// A method for whole pictures sees one channel after the other.
void LevelReducer::reduce_whole(const Band& band, ImageView<std::uint16_t> codes, int threads) {
  Image light(band.view.width, band.view.height, 1);
  Raster<std::uint16_t> channel_codes(band.view.width, band.view.height, 1);
  const DitherParameters& told = options_->parameters;
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    for (int y = 0; y < band.view.height; ++y) {
      const std::span<float> rgb = band.view.row(y);
      const std::span<float> row = light.view().row(y);
      if (grey()) {
        std::ranges::copy(grey_row(rgb), row.begin());
      } else {
        for (std::size_t x = 0; x < row.size(); ++x) row[x] = rgb[3 * x + c];
      }
      to_mix(options_->mix, {row.data(), band.view.width, 1});
    }
    const auto& whole = std::get<WholeChannel>(channels_[c]);
    whole.dither->channel(light.view(), whole.levels,
                          {told.seed, told.effort, told.strength, band.dither_mask, threads},
                          channel_codes.view());
    for (int y = 0; y < codes.height; ++y) {
      const std::span<const std::uint16_t> from = channel_codes.view().row(y);
      for (std::size_t x = 0; x < from.size(); ++x) {
        codes.row(y)[channels_.size() * x + c] = from[x];
      }
    }
  }
}

StageCounts LevelReducer::reduce(Band band, ImageView<std::uint16_t> codes, const Lead& lead,
                                 int threads) {
  if (std::holds_alternative<WholeChannel>(channels_[0])) {
    reduce_whole(band, codes, threads);
    return {};
  }
  const RowLead row_lead(lead);
  StageCounts counts;
  for (int row = 0; row < band.view.height; ++row) {
    const std::vector<float> shares = row_strength(band, row, options_->parameters.strength);
    const std::span<float> rgb = band.view.row(row);
    const std::span<std::uint16_t> out = codes.row(row);
    const int y = band.y0 + row;
    if (!grey()) {
      counts += reduce_rgb_row(row_lead, rgb, y, out, shares);
      continue;
    }
    const int width = band.view.width;
    reduce_row(channels_[0], options_->mix, {grey_row(rgb).data(), width, 1}, y,
               {out.data(), width, 1}, shares);
  }
  return counts;
}

}  // namespace tristim::detail
