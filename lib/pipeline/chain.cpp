#include "tristim/pipeline/chain.h"

#include <algorithm>

#include "tristim/color/transfer.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/image/repeat.h"
#include "tristim/palette/weights.h"

namespace tristim {
namespace {

// A colour of the command line, encoded sRGB, as light in the picture's primaries.
Rgb background_light(const EncodedRgb& color, const Primaries& picture) {
  const Eigen::Vector3d srgb(srgb_decode(color.r), srgb_decode(color.g), srgb_decode(color.b));
  const Eigen::Vector3d light = rgb_from_rgb(picture, Primaries{}, Adaptation::kBradford) * srgb;
  return {light.x(), light.y(), light.z()};
}

// How many cells make a side of the result; 0 stays 0.
int cells_of(int pixels, int cell) {
  if (pixels % cell == 0) return pixels / cell;
  throw Error(ErrorKind::kMisuse, "--cells",
              "a side of " + std::to_string(pixels) + " pixels is no multiple of cells of " +
                  std::to_string(cell),
              "give another size, or cells that divide it");
}

// The first channel of the next rows of a source.
class ChannelRows {
 public:
  explicit ChannelRows(RowSource* source) : source_(source) {}

  bool given() const noexcept { return source_ != nullptr; }

  void next(int rows) {
    const PictureInfo& info = source_->info();
    rows_ = Image(info.width, rows, info.channels);
    source_->read(rows_.view());
  }

  // 0 .. 255.
  std::uint16_t code(int x, int y) {
    return static_cast<std::uint16_t>(std::clamp(rows_.view().pixel(x, y)[0], 0.0F, 1.0F) * 255 +
                                      0.5F);
  }

 private:
  RowSource* source_;
  Image rows_;
};

// Counts codes instead of writing them.
class HistogramSink : public CodeSink {
 public:
  HistogramSink(Histogram& histogram, const CountOptions& options)
      : histogram_(histogram),
        options_(options),
        mask_(options.mask),
        coverage_(options.alpha == AlphaMode::kOver ? nullptr : options.coverage) {}

  void write(ImageView<const std::uint16_t> rows) override {
    const bool by_contrast = options_.weights == PaletteWeights::kContrast;
    if (!by_contrast && !mask_.given() && !coverage_.given()) return histogram_.add(rows);
    Raster<std::uint16_t> weights(rows.width, rows.height, 1);
    std::fill_n(weights.view().data, rows.width * rows.height, std::uint16_t{1});
    if (by_contrast) weigh_by_contrast(rows, weights.view());
    if (mask_.given()) {
      mask_.next(rows.height);
      for_each_pixel(rows, [&](int x, int y) {
        std::uint16_t& weight = *weights.view().pixel(x, y);
        weight = static_cast<std::uint16_t>(weight * mask_.code(x, y));
      });
    }
    if (!coverage_.given()) return histogram_.add(rows, weights.view());
    count_covered(rows, weights.view());
  }

  void finish() override {}

 private:
  template <typename F>
  static void for_each_pixel(ImageView<const std::uint16_t> rows, F&& f) {
    for (int y = 0; y < rows.height; ++y) {
      for (int x = 0; x < rows.width; ++x) f(x, y);
    }
  }

  void weigh_by_contrast(ImageView<const std::uint16_t> rows, ImageView<std::uint16_t> weights) {
    contrast_weights(rows, above_, weights);
    const auto last = rows.row(rows.height - 1);
    above_.assign(last.begin(), last.end());
  }

  void count_covered(ImageView<const std::uint16_t> rows, ImageView<const std::uint16_t> weights) {
    coverage_.next(rows.height);
    Histogram counted;
    for_each_pixel(rows, [&](int x, int y) {
      const std::uint16_t* const p = rows.pixel(x, y);
      const auto code = [](std::uint16_t value) { return static_cast<std::uint8_t>(value); };
      counted.add({code(p[0]), code(p[1]), code(p[2]), code(coverage_.code(x, y))},
                  *weights.pixel(x, y));
    });
    histogram_.merge(with_alpha(counted, options_.alpha));
  }

  Histogram& histogram_;
  CountOptions options_;
  ChannelRows mask_;
  ChannelRows coverage_;
  std::vector<std::uint16_t> above_;  // the row before the next ones
};

}  // namespace

std::unique_ptr<RowSource> prepare(std::unique_ptr<RowSource> picture, const Display& display,
                                   const Settings& settings, OddValues* counts) {
  const Rgb background = background_light(settings.background, picture->info().primaries);
  FitOptions options;
  options.width = settings.width;
  options.height = settings.height;
  if (settings.width == 0 && settings.height == 0 && display.panel) {
    options.width = display.panel->width;
    options.height = display.panel->height;
  }
  options.mode = settings.fit;
  options.filter = settings.filter;
  options.background = background;
  options.rotate_deg = settings.rotate_deg;
  options.width = cells_of(options.width, settings.cell_width);
  options.height = cells_of(options.height, settings.cell_height);
  return repeat_pixels(fit(flatten(std::move(picture), background, counts), options),
                       settings.cell_width, settings.cell_height);
}

StageList stage_list(const PictureInfo& picture, const Display& display, const Settings& settings) {
  StageList list;
  if (settings.exposure_stops != 0) list.stages.emplace_back(Exposure{settings.exposure_stops});
  if (settings.tone != nullptr) {
    list.stages.emplace_back(
        ToneMap{*settings.tone, settings.tone_white, xyz_from_rgb(picture.primaries).row(1)});
  }
  list.scene_stages = static_cast<int>(list.stages.size());
  list.stages.emplace_back(
      ConvertPrimaries{rgb_from_rgb(display.primaries, picture.primaries, settings.adaptation),
                       picture.primaries, display.primaries, settings.adaptation});
  list.stages.emplace_back(GamutMap{
      settings.gamut, rgb_from_rgb(Primaries{}, display.primaries, Adaptation::kBradford)});
  return list;
}

ScreenParameters screen_parameters(const Display& display, const ScreenParameters& asked) {
  ScreenParameters screen = asked;
  if (display.dots && screen.dpi == 0) screen.dpi = display.dots->dpi;
  if (display.dots && screen.lpi == 0) screen.lpi = display.dots->lpi;
  if (display.press && screen.angles_deg.empty()) {
    screen.angles_deg = display.press->angles_deg;
  }
  return screen;
}

ReduceOptions reduce_options(const Display& display, const Settings& settings) {
  const ScreenParameters& asked = settings.dither_parameters.screen;
  const bool screened = asked.lpi > 0 || !asked.angles_deg.empty() || asked.spot ||
                        asked.smallest_dot > 0 || asked.single_cell;
  const NamedDither& usual_dither =
      screened ? *find_by_name(dither_methods(), "screen") : default_dither(display);
  const NamedDither& dither = settings.dither ? *settings.dither : usual_dither;
  const bool dithered = !std::holds_alternative<NoDither>(dither.method);
  const bool chosen = settings.palette.method != nullptr;
  const Metric* usual = find_by_name(kMetrics, dithered ? "oklab-toe"
                                               : chosen ? "balanced"
                                                        : "oklab");
  DitherParameters parameters = settings.dither_parameters;
  if (!parameters.serpentine && display.frame.packing.indexed && !display.press) {
    parameters.serpentine = false;  // as good for palettes, and many rows go at once
  }
  parameters.screen = screen_parameters(display, asked);
  return {.dither = dither.method,
          .parameters = parameters,
          .metric = settings.metric != nullptr ? *settings.metric : *usual,
          .mix = settings.mix,
          .black_point = settings.black_point};
}

Histogram histogram(RowSource& picture, const StageList& stages, const Display& display,
                    const RunOptions& options, const CountOptions& counting) {
  Display counted;                        // sRGB codes of 8 bits ...
  counted.primaries = display.primaries;  // ... in the device's primaries
  Reducer reducer(counted, {}, picture.info().width);
  Histogram result;
  HistogramSink sink(result, counting);
  run(picture, stages.stages, reducer, sink, {}, options);
  return result;
}

Display with_palette(Display display, const std::vector<Color8>& palette) {
  const Eigen::Matrix3d matrix = xyz_from_rgb(display.primaries);
  display.palette.clear();
  display.press.reset();
  display.palette_has_white = false;
  display.viewing_white = display.primaries.white;
  for (const Color8& c : palette) {
    const Eigen::Vector3d light(srgb_decode(c.r / 255.0), srgb_decode(c.g / 255.0),
                                srgb_decode(c.b / 255.0));
    const Eigen::Vector3d xyz = matrix * light;
    const auto code = static_cast<std::uint16_t>(display.palette.size());
    display.palette.push_back({code, {xyz.x(), xyz.y(), xyz.z()}, {}});
  }
  return display;
}

Display with_palette(Display display, const Palette& palette) {
  const Eigen::Matrix3d matrix = xyz_from_rgb(Primaries{});
  display.palette.clear();
  display.palette_has_white = false;
  display.viewing_white = kD65;
  for (const PaletteColor& entry : palette.colors) {
    const EncodedRgb& c = entry.color;
    const Eigen::Vector3d xyz =
        matrix * Eigen::Vector3d(srgb_decode(c.r), srgb_decode(c.g), srgb_decode(c.b));
    const auto position = static_cast<std::uint16_t>(display.palette.size());
    display.palette.push_back(
        {entry.code.value_or(position), {xyz.x(), xyz.y(), xyz.z()}, entry.name});
  }
  return display;
}

int palette_colors(const Display& display, const PaletteChoice& choice) {
  const Packing& packing = display.frame.packing;
  if (!packing.indexed) {
    throw Error(ErrorKind::kMisuse, "--palette",
                "packing " + std::string(packing.name) + " has no palette",
                "choose a device with an indexed packing, or leave --palette out");
  }
  const int most = 1 << packing.bits[0];
  const int always = choice.method != nullptr ? choice.method->always : 0;
  const int wanted = always > 0 ? always : choice.colors;
  if (wanted > most) {
    throw Error(ErrorKind::kMisuse, "--palette",
                std::to_string(wanted) + " colours do not fit packing " + std::string(packing.name),
                "ask for " + std::to_string(most) + " or less");
  }
  return wanted == 0 ? most : wanted;
}

}  // namespace tristim
