#include "tristim/pipeline/reduce.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "lib/color/curve_table.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

using ChannelReducer = std::variant<NearestLevel, OrderedDither, LevelDiffusion>;

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

ChannelReducer channel_reducer(const LevelScale& scale, const ReduceOptions& options, int width) {
  if (std::holds_alternative<NoDither>(options.dither)) {
    return NearestLevel(scale.threshold, scale.nearest);
  }
  MixLevels levels{scale.light, scale.code};
  if (options.mix == Mix::kEncoded) {
    for (float& light : levels.light) light = detail::srgb_encode_table()(light);
  }
  if (const auto* recipe = std::get_if<MatrixRecipe>(&options.dither)) {
    return OrderedDither(std::move(levels), make_matrix(*recipe));
  }
  const auto& kernel = std::get<DiffusionKernel>(options.dither);
  return LevelDiffusion(levels, width, {.kernel = &kernel, .serpentine = options.serpentine});
}

// Coverage of dots that looks like an asked tone where dots gain [Murray36]: the parabola a + 4 g a
// (1 - a), solved for a.
float tone_before_gain(float tone, float gain) {
  const float ink = 1 - std::clamp(tone, 0.0F, 1.0F);
  const float b = 1 + 4 * gain;
  return 1 - (b - std::sqrt(b * b - 16 * gain * ink)) / (8 * gain);
}

std::string dither_name(const DitherMethod& method) {
  if (const auto* recipe = std::get_if<MatrixRecipe>(&method)) return std::string(recipe->name);
  if (const auto* kernel = std::get_if<DiffusionKernel>(&method)) return std::string(kernel->name);
  return "none";
}

std::string dither_source(const DitherMethod& method) {
  if (const auto* recipe = std::get_if<MatrixRecipe>(&method)) return std::string(recipe->source);
  if (const auto* kernel = std::get_if<DiffusionKernel>(&method))
    return std::string(kernel->source);
  return "";
}

}  // namespace

const std::vector<NamedDither>& dither_methods() {
  static const std::vector<NamedDither> methods = [] {
    std::vector<NamedDither> all{{"none", NoDither{}, "the nearest code"}};
    for (const MatrixRecipe& recipe : kMatrixRecipes)
      all.push_back({recipe.name, recipe, recipe.source});
    for (const DiffusionKernel& kernel : kDiffusionKernels) {
      all.push_back({kernel.name, kernel, kernel.source});
    }
    return all;
  }();
  return methods;
}

const NamedDither& default_dither(const Display& display) {
  const bool holds_dots = !display.dots || display.dots->isolated;
  const Packing& packing = display.frame.packing;
  const int least_bits = packing.samples == 3
                             ? *std::min_element(packing.bits.begin(), packing.bits.end())
                             : packing.bits[0];
  const char* name = "floyd-steinberg";
  if (!holds_dots) name = "clustered8";
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
  std::optional<ThresholdMatrix> matrix;
  std::optional<PaletteDiffusion> diffusion;
  Eigen::RowVector3f luminance;
  Eigen::Matrix3f srgb_from_device;
  float gain = 0;

  State(const Display& d, const ReduceOptions& o) : display(d), options(o) {}

  void set_up_palette(int width);
  void reduce_palette_row(std::span<float> rgb, int y, std::span<std::uint16_t> out);
  void reduce_grey_row(std::span<float> rgb, int y, std::span<std::uint16_t> out);
  void reduce_rgb_row(std::span<float> rgb, int y, std::span<std::uint16_t> out);
  void reduce_channel(std::size_t channel, ChannelRow<float> in, int y,
                      ChannelRow<std::uint16_t> out);
};

void Reducer::State::set_up_palette(int width) {
  const Eigen::Matrix3d to_srgb =
      rgb_from_rgb(Primaries{}, display.primaries, Adaptation::kBradford);
  std::vector<Rgb> entries;
  for (const Rgb& c : palette_light(display, options.black_point)) {
    const Eigen::Vector3d srgb = to_srgb * Eigen::Vector3d(c.r, c.g, c.b);
    entries.push_back({srgb.x(), srgb.y(), srgb.z()});
  }
  palette.emplace(entries, options.metric, options.mix);
  srgb_from_device = to_srgb.cast<float>();
  if (const auto* recipe = std::get_if<MatrixRecipe>(&options.dither))
    matrix = make_matrix(*recipe);
  if (const auto* kernel = std::get_if<DiffusionKernel>(&options.dither)) {
    diffusion.emplace(*palette, width,
                      DiffusionOptions{.kernel = kernel, .serpentine = options.serpentine});
  }
}

void Reducer::State::reduce_palette_row(std::span<float> rgb, int y, std::span<std::uint16_t> out) {
  if (!srgb_from_device.isIdentity(0)) {
    for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) {
      const Eigen::Vector3f c = srgb_from_device * Eigen::Vector3f(rgb[i], rgb[i + 1], rgb[i + 2]);
      for (std::size_t k = 0; k < 3; ++k) rgb[i + k] = c[static_cast<Eigen::Index>(k)];
    }
  }
  if (diffusion) return diffusion->row(rgb, out);
  if (matrix) return palette_ordered_row(*palette, *matrix, y, rgb, out);
  palette_nearest_row(*palette, rgb, out);
}

void Reducer::State::reduce_channel(std::size_t channel, ChannelRow<float> in, int y,
                                    ChannelRow<std::uint16_t> out) {
  const bool dithered = !std::holds_alternative<NoDither>(options.dither);
  if (dithered && options.mix == Mix::kEncoded) {
    const detail::CurveTable& encode = detail::srgb_encode_table();
    for (int x = 0; x < in.width; ++x) in[x] = encode(in[x]);
  }
  const ChannelRow<const float> light{in.data, in.width, in.step};
  ChannelReducer& reducer = channels[channel];
  if (auto* nearest = std::get_if<NearestLevel>(&reducer)) return nearest->row(light, out);
  if (auto* ordered = std::get_if<OrderedDither>(&reducer)) return ordered->row(light, y, out);
  std::get<LevelDiffusion>(reducer).row(light, out);
}

void Reducer::State::reduce_grey_row(std::span<float> rgb, int y, std::span<std::uint16_t> out) {
  const bool dithered = !std::holds_alternative<NoDither>(options.dither);
  const auto width = static_cast<int>(out.size());
  for (std::size_t x = 0; x < out.size(); ++x) {  // into the row itself: x never overtakes 3 x
    const float* p = &rgb[3 * x];
    const float grey = luminance[0] * p[0] + luminance[1] * p[1] + luminance[2] * p[2];
    rgb[x] = gain > 0 && dithered ? tone_before_gain(grey, gain) : grey;
  }
  reduce_channel(0, {rgb.data(), width, 1}, y, {out.data(), width, 1});
}

void Reducer::State::reduce_rgb_row(std::span<float> rgb, int y, std::span<std::uint16_t> out) {
  const auto width = static_cast<int>(out.size() / 3);
  for (std::size_t c = 0; c < 3; ++c) {
    reduce_channel(c, {rgb.data() + c, width, 3}, y, {out.data() + c, width, 3});
  }
}

Reducer::Reducer(const Display& display, const ReduceOptions& options, int width)
    : state_(std::make_unique<State>(display, options)) {
  State& s = *state_;
  const Packing& packing = s.display.frame.packing;
  s.samples = packing.samples;
  s.luminance = xyz_from_rgb(s.display.primaries).row(1).cast<float>();
  s.gain = s.display.dots ? static_cast<float>(s.display.dots->gain) : 0;
  if (packing.indexed) {
    if (s.display.palette.empty()) {
      throw std::invalid_argument("display: an indexed packing needs a palette");
    }
    s.set_up_palette(width);
    return;
  }
  for (int c = 0; c < packing.samples; ++c) {
    const LevelScale scale = s.display.palette.empty()
                                 ? level_scale(s.display, packing.bits[static_cast<std::size_t>(c)],
                                               s.options.black_point)
                                 : palette_scale(s.display, s.options);
    s.channels.push_back(channel_reducer(scale, s.options, width));
    s.scales.push_back(scale);
  }
}

Reducer::Reducer(Reducer&&) noexcept = default;
Reducer::~Reducer() = default;

int Reducer::samples() const noexcept { return state_->samples; }

bool Reducer::in_order() const noexcept {
  return std::holds_alternative<DiffusionKernel>(state_->options.dither);
}

void Reducer::reduce(Band band, ImageView<std::uint16_t> codes) {
  for (int i = 0; i < band.view.height; ++i) {
    const int y = band.y0 + i;
    if (state_->palette) {
      state_->reduce_palette_row(band.view.row(i), y, codes.row(i));
    } else if (state_->samples == 1) {
      state_->reduce_grey_row(band.view.row(i), y, codes.row(i));
    } else {
      state_->reduce_rgb_row(band.view.row(i), y, codes.row(i));
    }
  }
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
  if (s.palette) {
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
    if (s.gain > 0) response.numbers.emplace_back("dot gain", shortest(s.display.dots->gain));
    steps.push_back(std::move(response));
  }
  StepReport dither{
      "dither " + dither_name(s.options.dither), "", dither_source(s.options.dither), {}};
  if (!std::holds_alternative<NoDither>(s.options.dither)) {
    dither.numbers.emplace_back("mixed in",
                                s.options.mix == Mix::kLight ? "light" : "encoded numbers");
  }
  if (in_order()) dither.numbers.emplace_back("serpentine", s.options.serpentine ? "yes" : "no");
  steps.push_back(std::move(dither));
  return steps;
}

}  // namespace tristim
