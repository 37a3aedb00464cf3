#include "tristim/pipeline/reduce.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "lib/color/curve_table.h"
#include "lib/dither/planes.h"
#include "lib/pipeline/ink_planes.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/dither/ordered.h"

namespace tristim {
namespace {

// A channel whose codes are chosen with all of its light in view.
struct WholeChannel {
  const WholePictureDither* dither;
  MixLevels levels;
};

using ChannelReducer = std::variant<NearestLevel, OrderedDither, LevelDiffusion, WholeChannel>;

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

// `matrix` of an ordered method, else null.
ChannelReducer channel_reducer(const LevelScale& scale, const ReduceOptions& options,
                               const ThresholdMatrix* matrix, int channel, int width) {
  if (std::holds_alternative<NoDither>(options.dither)) {
    return NearestLevel(scale.threshold, scale.nearest);
  }
  MixLevels levels{scale.light, scale.code};
  if (options.mix == Mix::kEncoded) {
    for (float& light : levels.light) light = detail::srgb_encode_table()(light);
  }
  if (matrix != nullptr) return OrderedDither(levels, *matrix);
  if (const auto* whole = std::get_if<WholePictureDither>(&options.dither)) {
    return WholeChannel{whole, std::move(levels)};
  }
  const auto& kernel = std::get<DiffusionKernel>(options.dither);
  return LevelDiffusion(levels, width, diffusion_options(kernel, options.parameters, channel));
}

// An ink lies on a dot (1) or leaves the paper bare.
LevelScale ink_scale() { return {{0, 1}, {1, 0}, {0.5F}, {1, 0}}; }

std::string dither_name(const DitherMethod& method) {
  return std::visit([](const auto& m) { return std::string(m.name); }, method);
}

std::string dither_source(const DitherMethod& method) {
  return std::visit([](const auto& m) { return std::string(m.source); }, method);
}

void add_gain(const Dots& dots, StepReport& step) {
  const std::string gain = describe(dots.gain);
  if (!gain.empty()) step.numbers.emplace_back("dot gain", gain);
}

StepReport press_step(const Display& display) {
  const Press& press = *display.press;
  StepReport step{"inks", "light = product of 1 - area (1 - ink)", "[Neugebauer37]", {}};
  step.numbers.emplace_back("inks", list_names(press.inks));
  for (const NamedSeparation& separation : kSeparations) {
    if (separation.rule == press.rule) {
      step.numbers.emplace_back("separation", std::string(separation.name));
    }
  }
  step.numbers.emplace_back("black", shortest(press.black.replacement));
  step.numbers.emplace_back("ink limit", shortest(press.black.limit));
  if (display.dots) add_gain(*display.dots, step);
  return step;
}

// The strength of a row's pixels: the mask's, times that of the whole; empty where the dither is
// whole everywhere.
std::vector<float> row_strength(const Band& band, int row, float strength) {
  const ImageView<const float>& mask = band.dither_mask;
  if (mask.data == nullptr && strength == 1) return {};
  std::vector<float> all(static_cast<std::size_t>(band.view.width), strength);
  if (mask.data == nullptr) return all;
  const std::span<const float> of_mask = mask.row(row);
  for (std::size_t x = 0; x < all.size(); ++x) all[x] *= of_mask[x];
  return all;
}

}  // namespace

const NamedDither& default_dither(const Display& display) {
  const bool holds_dots = !display.dots || display.dots->isolated;
  const Packing& packing = display.frame.packing;
  const int least_bits = packing.samples == 3
                             ? *std::min_element(packing.bits.begin(), packing.bits.end())
                             : packing.bits[0];
  const bool chosen_palette = packing.indexed && !display.palette_has_white;
  const bool one_bit = least_bits == 1 && !packing.indexed;
  const char* name = one_bit || chosen_palette ? "blue-diffusion" : "floyd-steinberg";
  if (!holds_dots) name = "clustered8";
  if (display.press) name = "screen";
  if (least_bits >= 8 && !packing.indexed && display.palette.empty()) name = "none";
  return *find_by_name(dither_methods(), name);
}

struct Reducer::State {
  const Display display;
  const ReduceOptions options;
  int samples = 1;
  std::vector<ChannelReducer> channels;  // none where there is a palette of colours
  std::vector<LevelScale> scales;
  std::optional<MixPalette> palette;
  std::vector<ThresholdMatrix> matrices;  // of ordered methods, by channel
  std::optional<PaletteDiffusion> diffusion;
  Eigen::RowVector3f luminance;
  Eigen::Matrix3f srgb_from_device;
  std::optional<detail::InkPlanes> inks;  // of a press: channels are inks
  detail::ToneBeforeGain tone_before_gain;

  State(const Display& d, const ReduceOptions& o)
      : display(d), options(o), tone_before_gain(d.dots ? d.dots->gain : NoGain{}) {}

  void set_up_palette(int width);
  void reduce_palette_row(std::span<float> rgb, int y, std::span<std::uint16_t> out,
                          std::span<const float> strength);
  std::span<float> grey_row(std::span<float> rgb) const;
  void reduce_channel(std::size_t channel, ChannelRow<float> in, int y,
                      ChannelRow<std::uint16_t> out, std::span<const float> strength);
  void reduce_ordered_row(std::span<float> rgb, int y, std::span<std::uint16_t> out,
                          std::span<const float> strength);
  void add_channel(const LevelScale& scale, int width);
  void reduce_inks_row(std::span<const float> rgb, int y, std::span<std::uint16_t> out,
                       std::span<const float> strength);
  void reduce_row(const Band& band, int row, std::span<std::uint16_t> out);
  void reduce_whole(const Band& band, ImageView<std::uint16_t> codes);
  void diffuse_levels(const Band& band, ImageView<std::uint16_t> codes);
  bool dithered() const noexcept { return !std::holds_alternative<NoDither>(options.dither); }
};

void Reducer::State::set_up_palette(int width) {
  const Eigen::Matrix3d to_srgb =
      rgb_from_rgb(Primaries{}, display.primaries, Adaptation::kBradford);
  std::vector<Rgb> entries;
  for (const Rgb& c : palette_light(display, options.black_point)) {
    const Eigen::Vector3d srgb = to_srgb * Eigen::Vector3d(c.r, c.g, c.b);
    entries.push_back({srgb.x(), srgb.y(), srgb.z()});
  }
  palette.emplace(entries, options.metric, options.mix,
                  display.palette_has_white ? Beyond::kMoved : Beyond::kDamped);
  srgb_from_device = to_srgb.cast<float>();
  if (const auto* kernel = std::get_if<DiffusionKernel>(&options.dither)) {
    diffusion.emplace(*palette, width, diffusion_options(*kernel, options.parameters));
  }
}

void Reducer::State::reduce_palette_row(std::span<float> rgb, int y, std::span<std::uint16_t> out,
                                        std::span<const float> strength) {
  if (!srgb_from_device.isIdentity(0)) {
    for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) {
      const Eigen::Vector3f c = srgb_from_device * Eigen::Vector3f(rgb[i], rgb[i + 1], rgb[i + 2]);
      for (std::size_t k = 0; k < 3; ++k) rgb[i + k] = c[static_cast<Eigen::Index>(k)];
    }
  }
  if (diffusion) return diffusion->row(rgb, out, strength);
  if (!matrices.empty()) {
    return palette_ordered_row(*palette, matrices.front(), y, rgb, out, strength);
  }
  palette_nearest_row(*palette, rgb, out);
}

void Reducer::State::reduce_channel(std::size_t channel, ChannelRow<float> in, int y,
                                    ChannelRow<std::uint16_t> out,
                                    std::span<const float> strength) {
  const ChannelRow<const float> light{in.data, in.width, in.step};
  ChannelReducer& reducer = channels[channel];
  if (auto* nearest = std::get_if<NearestLevel>(&reducer)) return nearest->row(light, out);
  if (options.mix == Mix::kEncoded) {
    const detail::CurveTable& encode = detail::srgb_encode_table();
    for (int x = 0; x < in.width; ++x) in[x] = encode(in[x]);
  }
  if (auto* ordered = std::get_if<OrderedDither>(&reducer)) {
    return ordered->row(light, y, out, strength);
  }
  std::get<LevelDiffusion>(reducer).row(light, out, strength);
}

void Reducer::State::add_channel(const LevelScale& scale, int width) {
  const ThresholdMatrix* matrix = matrices.empty() ? nullptr : &matrices[channels.size()];
  const auto channel = static_cast<int>(channels.size());
  channels.push_back(channel_reducer(scale, options, matrix, channel, width));
}

// The luminances of a row, in its first third; what dots gain is taken off.
std::span<float> Reducer::State::grey_row(std::span<float> rgb) const {
  const std::span<float> grey = rgb.first(rgb.size() / 3);
  for (std::size_t x = 0; x < grey.size(); ++x) {  // x never overtakes 3 x
    const float* p = &rgb[3 * x];
    const float tone = luminance[0] * p[0] + luminance[1] * p[1] + luminance[2] * p[2];
    grey[x] = dithered() ? tone_before_gain(tone) : tone;
  }
  return grey;
}

// Three channels at once.
void Reducer::State::reduce_ordered_row(std::span<float> rgb, int y, std::span<std::uint16_t> out,
                                        std::span<const float> strength) {
  if (options.mix == Mix::kEncoded) {
    const detail::CurveTable& encode = detail::srgb_encode_table();
    for (float& v : rgb) v = encode(v);
  }
  const OrderedDither* dithers[3];
  for (std::size_t c = 0; c < 3; ++c) dithers[c] = &std::get<OrderedDither>(channels[c]);
  OrderedDither::rgb_row(dithers, rgb, y, out, strength);
}

// Bit i of a code is ink i.
void Reducer::State::reduce_inks_row(std::span<const float> rgb, int y,
                                     std::span<std::uint16_t> out,
                                     std::span<const float> strength) {
  const std::size_t width = out.size();
  std::vector<float> planes(width * channels.size());
  std::vector<std::uint16_t> inked(width);
  inks->row(rgb, planes);
  std::ranges::fill(out, std::uint16_t{0});
  for (std::size_t i = 0; i < channels.size(); ++i) {
    reduce_channel(i, {planes.data() + i * width, static_cast<int>(width), 1}, y,
                   {inked.data(), static_cast<int>(width), 1}, strength);
    for (std::size_t x = 0; x < width; ++x) {
      out[x] = static_cast<std::uint16_t>(out[x] | inked[x] << i);
    }
  }
}

void Reducer::State::reduce_row(const Band& band, int row, std::span<std::uint16_t> out) {
  const int y = band.y0 + row;
  const std::vector<float> strength = row_strength(band, row, options.parameters.strength);
  const std::span<float> rgb = band.view.row(row);
  if (inks) return reduce_inks_row(rgb, y, out, strength);
  if (palette) return reduce_palette_row(rgb, y, out, strength);
  const int width = band.view.width;
  if (samples == 1) {
    return reduce_channel(0, {grey_row(rgb).data(), width, 1}, y, {out.data(), width, 1}, strength);
  }
  if (std::holds_alternative<OrderedDither>(channels[0])) {
    return reduce_ordered_row(rgb, y, out, strength);
  }
  for (std::size_t c = 0; c < 3; ++c) {
    reduce_channel(c, {rgb.data() + c, width, 3}, y, {out.data() + c, width, 3}, strength);
  }
}

// Error diffusion of channels without a mask: many rows of a channel at a time.
void Reducer::State::diffuse_levels(const Band& band, ImageView<std::uint16_t> codes) {
  const int width = band.view.width;
  const int height = band.view.height;
  const auto rows = [&](std::size_t channel, ImageView<float> light,
                        ImageView<std::uint16_t> channel_codes) {
    if (options.mix == Mix::kEncoded) {
      for (int y = 0; y < height; ++y) {
        for (float& v : light.row(y)) v = detail::srgb_encode_table()(v);
      }
    }
    std::get<LevelDiffusion>(channels[channel]).rows(light, channel_codes);
  };
  if (samples == 1) {
    for (int y = 0; y < height; ++y) grey_row(band.view.row(y));
    return rows(0, {band.view.data, width, height, 1, band.view.stride}, codes);
  }
  std::array<Image, 3> light;
  std::array<Raster<std::uint16_t>, 3> plane;
  for (std::size_t c = 0; c < 3; ++c) {
    light[c] = Image(width, height, 1);
    plane[c] = Raster<std::uint16_t>(width, height, 1);
  }
  for (int y = 0; y < height; ++y) {
    detail::split_row(band.view.row(y),
                      {light[0].view().row(y).data(), light[1].view().row(y).data(),
                       light[2].view().row(y).data()});
  }
  for (std::size_t c = 0; c < 3; ++c) rows(c, light[c].view(), plane[c].view());
  for (int y = 0; y < height; ++y) {
    detail::join_row({plane[0].view().row(y).data(), plane[1].view().row(y).data(),
                      plane[2].view().row(y).data()},
                     codes.row(y));
  }
}

// A method for whole pictures sees one channel after the other.
void Reducer::State::reduce_whole(const Band& band, ImageView<std::uint16_t> codes) {
  Image light(band.view.width, band.view.height, 1);
  Raster<std::uint16_t> channel_codes(band.view.width, band.view.height, 1);
  const DitherParameters& told = options.parameters;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    for (int y = 0; y < band.view.height; ++y) {
      const std::span<float> rgb = band.view.row(y);
      const std::span<float> row = light.view().row(y);
      if (samples == 1) {
        std::ranges::copy(grey_row(rgb), row.begin());
      } else {
        for (std::size_t x = 0; x < row.size(); ++x) row[x] = rgb[3 * x + c];
      }
      if (options.mix != Mix::kEncoded) continue;
      for (float& v : row) v = detail::srgb_encode_table()(v);
    }
    const auto& whole = std::get<WholeChannel>(channels[c]);
    whole.dither->channel(light.view(), whole.levels,
                          {told.seed, told.effort, told.strength, band.dither_mask},
                          channel_codes.view());
    for (int y = 0; y < codes.height; ++y) {
      const std::span<const std::uint16_t> from = channel_codes.view().row(y);
      for (std::size_t x = 0; x < from.size(); ++x) {
        codes.row(y)[channels.size() * x + c] = from[x];
      }
    }
  }
}

Reducer::Reducer(const Display& display, const ReduceOptions& options, int width)
    : state_(std::make_unique<State>(display, options)) {
  State& s = *state_;
  const Packing& packing = s.display.frame.packing;
  s.samples = packing.samples;
  s.luminance = xyz_from_rgb(s.display.primaries).row(1).cast<float>();
  const std::size_t count =
      s.display.press ? s.display.press->inks.size() : static_cast<std::size_t>(packing.samples);
  s.matrices = dither_matrices(s.options.dither, s.options.parameters, static_cast<int>(count));
  if (s.display.press) {
    if (whole_picture()) {
      throw std::invalid_argument("dither: a method for whole pictures takes no press");
    }
    s.inks.emplace(s.display, s.options.black_point);
    for (std::size_t i = 0; i < count; ++i) s.add_channel(ink_scale(), width);
    return;
  }
  if (packing.indexed) {
    if (s.display.palette.empty()) {
      throw std::invalid_argument("display: an indexed packing needs a palette");
    }
    if (whole_picture()) {
      throw std::invalid_argument("dither: " + dither_name(options.dither) +
                                  " works on the levels of channels, not on a palette; use a "
                                  "kernel such as floyd-steinberg");
    }
    s.set_up_palette(width);
    return;
  }
  for (int c = 0; c < packing.samples; ++c) {
    const LevelScale scale = s.display.palette.empty()
                                 ? level_scale(s.display, packing.bits[static_cast<std::size_t>(c)],
                                               s.options.black_point)
                                 : palette_scale(s.display, s.options);
    s.add_channel(scale, width);
    s.scales.push_back(scale);
  }
}

Reducer::Reducer(Reducer&&) noexcept = default;
Reducer::~Reducer() = default;

int Reducer::samples() const noexcept { return state_->samples; }

bool Reducer::in_order() const noexcept {
  return std::holds_alternative<DiffusionKernel>(state_->options.dither);
}

bool Reducer::whole_picture() const noexcept {
  return std::holds_alternative<WholePictureDither>(state_->options.dither);
}

void Reducer::reduce(Band band, ImageView<std::uint16_t> codes) {
  if (whole_picture()) return state_->reduce_whole(band, codes);
  const bool whole_strength =
      state_->options.parameters.strength == 1 && band.dither_mask.data == nullptr;
  if (in_order() && !state_->palette && !state_->inks && whole_strength) {
    return state_->diffuse_levels(band, codes);
  }
  for (int i = 0; i < band.view.height; ++i) state_->reduce_row(band, i, codes.row(i));
}

std::vector<StepReport> Reducer::explain() const {
  const State& s = *state_;
  std::vector<StepReport> steps;
  const bool relative = s.options.black_point == BlackPoint::kRelative;
  steps.push_back({"black and white",
                   relative ? "picture [0, 1] to the device's black..white, in light"
                            : "picture light is the device's light: below its black it is lost",
                   "",
                   {}});
  if (s.display.press) {
    steps.push_back(press_step(s.display));
  } else if (s.palette) {
    StepReport palette{"palette", "the nearest entry", std::string(s.options.metric.source), {}};
    palette.numbers.emplace_back("entries", std::to_string(s.palette->size()));
    palette.numbers.emplace_back("metric", std::string(s.options.metric.name));
    steps.push_back(std::move(palette));
  } else {
    StepReport response{"response",
                        s.display.palette.empty() ? describe(s.display.response)
                                                  : "levels are the palette's luminances",
                        "",
                        {}};
    if (s.display.levels) {
      response.formula += "; levels I_j from I0 to 1, V_j = floor((I_j/K)^(1/gamma) + .5)";
      response.source = "[Shoaff 2.1.1]";
      response.numbers.emplace_back("I0", shortest(s.display.levels->i0));
    }
    for (std::size_t c = 0; c < s.scales.size(); ++c) {
      const LevelScale& scale = s.scales[c];
      const std::string channel = s.scales.size() == 1 ? "" : std::string(1, "RGB"[c]) + " ";
      response.numbers.emplace_back(channel + "levels", std::to_string(scale.light.size()));
      response.numbers.emplace_back(channel + "first",
                                    "code " + std::to_string(scale.code.front()) + " at light " +
                                        rounded(scale.light.front(), 8));
      response.numbers.emplace_back(channel + "last", "code " + std::to_string(scale.code.back()) +
                                                          " at light " +
                                                          rounded(scale.light.back(), 8));
    }
    if (s.display.dots) add_gain(*s.display.dots, response);
    steps.push_back(std::move(response));
  }
  StepReport dither{
      "dither " + dither_name(s.options.dither), "", dither_source(s.options.dither), {}};
  if (!std::holds_alternative<NoDither>(s.options.dither)) {
    dither.numbers.emplace_back("mixed in",
                                s.options.mix == Mix::kLight ? "light" : "encoded numbers");
  }
  if (s.options.parameters.strength != 1) {
    dither.numbers.emplace_back("strength", shortest(s.options.parameters.strength));
  }
  if (const auto* kernel = std::get_if<DiffusionKernel>(&s.options.dither)) {
    const DiffusionOptions told = diffusion_options(*kernel, s.options.parameters);
    dither.numbers.emplace_back("serpentine", told.serpentine ? "yes" : "no");
    if (passed_on(*kernel) < 1) {
      dither.numbers.emplace_back(
          "passes on", shortest(passed_on(*kernel)) + " of the error: gains contrast, loses tone");
    }
    if (told.jitter > 0) dither.numbers.emplace_back("jitter", shortest(told.jitter));
  }
  steps.push_back(std::move(dither));
  return steps;
}

}  // namespace tristim
