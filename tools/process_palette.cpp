#include "tools/process_palette.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "tools/cli.h"
#include "tools/palette_source.h"
#include "tools/process_output.h"
#include "tools/process_report.h"
#include "tools/spool.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/image/io/read.h"
#include "tristim/palette/mixing.h"
#include "tristim/pipeline/chain.h"

namespace tristim::tools {
namespace {

constexpr const PaletteMethod& kUsualMethod = kPaletteMethods[0];
static_assert(kUsualMethod.name == "best");

// The palette to choose for the picture; nothing where the device's own codes serve.
std::optional<PaletteChoice> choice_of(const Display& display, const Settings& settings) {
  PaletteChoice choice = settings.palette;
  if (choice.colors == 0) choice.colors = settings.colors;
  const bool has_codes = !display.palette.empty() || !display.frame.packing.indexed;
  const bool asked = choice.method != nullptr || settings.colors > 0 || settings.transparent;
  if (has_codes && !asked) return std::nullopt;
  if (!display.palette.empty() && choice.method == nullptr) {
    throw Error(ErrorKind::kMisuse, settings.transparent ? "--transparent" : "--colors",
                "is for a palette that is chosen, and the device has one of its own",
                "give --palette best too, or leave it out");
  }
  if (choice.method == nullptr) choice.method = &kUsualMethod;
  return choice;
}

// RGB codes make room for indices where the format has them.
Display with_indices(Display display) {
  display.frame = FrameLayout{};
  display.frame.packing = *find_by_name(kPackings, "index8");
  display.levels.reset();
  return display;
}

// `palette` without its first entry of alpha 0, which `position` gets.
Palette without_transparent(Palette palette, std::optional<int>& position) {
  for (std::size_t i = 0; i < palette.colors.size(); ++i) {
    if (!palette.colors[i].code) palette.colors[i].code = static_cast<std::uint16_t>(i);
  }
  const auto found = std::ranges::find(palette.colors, 0.0, &PaletteColor::alpha);
  if (found == palette.colors.end()) return palette;
  position = static_cast<int>(found - palette.colors.begin());
  palette.colors.erase(found);
  return palette;
}

PaletteDisplay palette_of_file(const ProcessOptions& options, const Display& device) {
  const std::string& file = options.settings.palette.file;
  const PaletteSource source = load_palette({file}, "--palette");
  const Packing& packing = device.frame.packing;
  const std::size_t most = std::size_t{1} << packing.bits[0];
  if (source.palette.colors.size() > most) {
    throw Error(ErrorKind::kMisuse, file,
                "a palette of " + std::to_string(source.palette.colors.size()) +
                    " colours, but packing " + std::string(packing.name) + " holds at most " +
                    std::to_string(most),
                "use fewer colours or a device with a wider packing");
  }
  PaletteDisplay result;
  const Palette opaque = without_transparent(source.palette, result.transparent);
  if (opaque.colors.empty()) {
    throw Error(ErrorKind::kContent, file, "has no colour that is not transparent");
  }
  result.display = with_palette(device, opaque);
  result.step = StepReport{"palette of " + one_line(file), "", "", {}};
  result.step->numbers.emplace_back("colours", std::to_string(source.palette.colors.size()));
  return result;
}

Histogram count_inputs(const ProcessOptions& options, const Display& device,
                       const std::vector<std::string>& inputs) {
  Histogram all;
  for (const std::string& input : inputs) {
    all.merge(count_colors(options.settings, device, input, options.threads));
  }
  return all;
}

// Where the transparent entry of `colors` is to be; nothing where there is none.
std::optional<int> reserved_position(const Settings& settings, int colors) {
  if (!settings.transparent) return std::nullopt;
  const int position = *settings.transparent < 0 ? colors - 1 : *settings.transparent;
  if (position < colors && colors > 1) return position;
  throw Error(ErrorKind::kMisuse, "--transparent",
              "position " + std::to_string(position) + " leaves no room among " +
                  std::to_string(colors) + " colours",
              "give a smaller position or more colours");
}

PaletteDisplay palette_of_choice(const ProcessOptions& options, const Display& device,
                                 const PaletteChoice& choice,
                                 const std::vector<std::string>& inputs) {
  const int colors = palette_colors(device, choice);
  PaletteDisplay result;
  result.transparent = reserved_position(options.settings, colors);
  const bool counts = choice.method->needs_histogram;
  const Histogram counted = counts ? count_inputs(options, device, inputs) : Histogram{};
  PaletteOptions wanted{.colors = colors, .metric = options.settings.metric, .bits = choice.bits};
  if (!choice.inks.empty()) wanted.inks = choice.inks;
  wanted.transparent = result.transparent;
  std::vector<Color8> palette = build_palette(counted, *choice.method, wanted);
  if (result.transparent) palette.erase(palette.begin() + *result.transparent);
  const bool dithered = !std::holds_alternative<NoDither>(
      reduce_options(with_palette(device, palette), options.settings).dither);
  const bool free = choice.method->name == "best";  // the others are what their sources say
  if (dithered && free) palette = refine_for_mixing(counted, std::move(palette));
  result.display = with_palette(device, palette);
  for (CodeColor& entry : result.display.palette) {
    if (result.transparent && entry.code >= *result.transparent) ++entry.code;
  }
  result.step = palette_step(choice, colors);
  return result;
}

/// A picture's alpha as light.
class CoverageRows final : public RowSource {
 public:
  explicit CoverageRows(std::unique_ptr<RowSource> picture)
      : picture_(std::move(picture)), info_(picture_->info()) {
    info_.channels = 3;
    info_.primaries = {};
  }

  const PictureInfo& info() const noexcept override { return info_; }

  void read(ImageView<float> rows) override {
    Image four(rows.width, rows.height, 4);
    picture_->read(four.view());
    for (int y = 0; y < rows.height; ++y) {
      for (int x = 0; x < rows.width; ++x) {
        std::fill_n(rows.pixel(x, y), 3, four.view().pixel(x, y)[3]);
      }
    }
  }

 private:
  std::unique_ptr<RowSource> picture_;
  PictureInfo info_;
};

/// A picture's colours as they are where they are seen at all: not premultiplied.
class UncoveredRows final : public RowSource {
 public:
  explicit UncoveredRows(std::unique_ptr<RowSource> picture)
      : picture_(std::move(picture)), info_(picture_->info()) {
    info_.channels = 3;
  }

  const PictureInfo& info() const noexcept override { return info_; }

  void read(ImageView<float> rows) override {
    Image four(rows.width, rows.height, 4);
    picture_->read(four.view());
    for (int y = 0; y < rows.height; ++y) {
      for (int x = 0; x < rows.width; ++x) {
        const float* const from = four.view().pixel(x, y);
        for (int c = 0; c < 3; ++c) {
          rows.pixel(x, y)[c] = from[3] > 0 ? from[c] / from[3] : 0.0F;
        }
      }
    }
  }

 private:
  std::unique_ptr<RowSource> picture_;
  PictureInfo info_;
};

// How much each pixel counts, turned and fitted as the picture is; null where nothing is named.
std::unique_ptr<RowSource> open_mask(const std::string& mask, const Display& display,
                                     const Settings& settings, const PictureInfo& picture,
                                     int threads) {
  if (mask.empty()) return nullptr;
  auto rows = prepare(open_picture(mask, {.threads = threads}), display, settings, nullptr);
  const PictureInfo& info = rows->info();
  if (info.width == picture.width && info.height == picture.height) return rows;
  throw Error(ErrorKind::kContent, mask,
              "is " + std::to_string(info.width) + "x" + std::to_string(info.height) +
                  " where the picture is " + std::to_string(picture.width) + "x" +
                  std::to_string(picture.height),
              "give a mask of the picture's size, or --size");
}

}  // namespace

PaletteDisplay choose_palette(const ProcessOptions& options, const Display& device,
                              const std::vector<std::string>& inputs, bool indexed) {
  const Settings& settings = options.settings;
  const bool asked = !settings.palette.file.empty() || choice_of(device, settings);
  const bool holds_palette = device.frame.packing.indexed;
  const bool makes_room = indexed && !holds_palette && device.frame.packing.samples == 3;
  const bool only_indices = makes_room && is_indexed_only(options, options.output);
  if (!asked && !only_indices) return {device, {}, {}};
  const Display display = makes_room ? with_indices(device) : device;
  if (!settings.palette.file.empty()) {
    if (settings.transparent) {
      throw Error(ErrorKind::kMisuse, "--transparent", "does not go with a palette of a file",
                  "give that an entry of alpha 0");
    }
    (void)palette_colors(display, {});
    return palette_of_file(options, display);
  }
  return palette_of_choice(options, display, *choice_of(display, settings), inputs);
}

Histogram count_colors(const Settings& settings, const Display& display, const std::string& input,
                       int threads, const Counting& counting) {
  make_rereadable(input);
  CountOptions options{.weights = settings.palette_weights, .alpha = counting.alpha};
  auto source = open_picture(input, {.layer = settings.layer, .threads = threads});
  std::unique_ptr<RowSource> coverage;
  if (counting.alpha != AlphaMode::kOver && source->info().channels == 4) {
    coverage = open_coverage(input, display, settings, threads);
    source = std::make_unique<UncoveredRows>(std::move(source));
  }
  const auto picture = prepare(std::move(source), display, settings, nullptr);
  const auto mask = open_mask(counting.mask, display, settings, picture->info(), threads);
  options.coverage = coverage.get();
  options.mask = mask.get();
  const StageList stages = stage_list(picture->info(), display, settings);
  return histogram(*picture, stages, display, {.threads = threads}, options);
}

FrameInfo palette_frame_info(const PaletteDisplay& palette, int width, int height) {
  FrameInfo info = frame_info(palette.display, width, height);
  if (!palette.transparent) return info;
  PaletteEntry entry;
  entry.code = static_cast<std::uint16_t>(*palette.transparent);
  entry.alpha = 0;
  info.palette.insert(info.palette.begin() + *palette.transparent, entry);
  return info;
}

TransparentSink::TransparentSink(CodeSink& file, int transparent,
                                 std::unique_ptr<RowSource> coverage)
    : file_(&file),
      transparent_(static_cast<std::uint16_t>(transparent)),
      coverage_(std::move(coverage)) {}

void TransparentSink::write(ImageView<const std::uint16_t> rows) {
  codes_.resize(static_cast<std::size_t>(rows.width) * static_cast<std::size_t>(rows.height));
  const ImageView<std::uint16_t> out{codes_.data(), rows.width, rows.height, 1, rows.width};
  if (coverage_) {
    light_ = Image(rows.width, rows.height, 3);
    coverage_->read(light_.view());
  }
  for (int y = 0; y < rows.height; ++y) {
    for (int x = 0; x < rows.width; ++x) {
      const std::uint16_t code = *rows.pixel(x, y);
      const bool clear = coverage_ && !(light_.view().pixel(x, y)[0] >= 0.5F);
      *out.pixel(x, y) = clear                  ? transparent_
                         : code >= transparent_ ? static_cast<std::uint16_t>(code + 1)
                                                : code;
    }
  }
  file_->write(out);
}

std::unique_ptr<RowSource> open_coverage(const std::string& input, const Display& display,
                                         Settings settings, int threads) {
  auto picture = open_picture(input, {.layer = settings.layer, .threads = threads});
  if (picture->info().channels != 4) return nullptr;
  settings.background = {};  // beside a fitted picture nothing is covered
  return prepare(std::make_unique<CoverageRows>(std::move(picture)), display, settings, nullptr);
}

}  // namespace tristim::tools
