#include "tristim/pipeline/dither_trial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "tristim/color/transfer.h"
#include "tristim/core/find.h"
#include "tristim/image/memory.h"
#include "tristim/measure/tone.h"
#include "tristim/measure/vision.h"
#include "tristim/pipeline/chain.h"
#include "tristim/pipeline/proof.h"
#include "tristim/pipeline/run.h"

namespace tristim {
namespace {

constexpr int kPatches = 17;
constexpr int kPatchWidth = 256;
constexpr int kPatchHeight = 256;
constexpr int kTextureSide = 512;
constexpr float kTextureLight = 0.0625F;
constexpr double kSamplesPerDegree = 40;

Image copy_of(ImageView<const float> picture) {
  Image copy(picture.width, picture.height, picture.channels);
  for (int y = 0; y < picture.height; ++y) {
    std::copy(picture.row(y).begin(), picture.row(y).end(), copy.view().row(y).begin());
  }
  return copy;
}

// Keeps the codes that a picture becomes.
class CodeCollector : public CodeSink {
 public:
  explicit CodeCollector(Raster<std::uint16_t>& codes) : codes_(codes) {}
  void write(ImageView<const std::uint16_t> rows) override {
    for (int y = 0; y < rows.height; ++y, ++next_) {
      std::copy(rows.row(y).begin(), rows.row(y).end(), codes_.view().row(next_).begin());
    }
  }
  void finish() override {}

 private:
  Raster<std::uint16_t>& codes_;
  int next_ = 0;
};

// The light that picture black becomes, as the reducer has it.
Rgb black_light(const Display& display) {
  if (display.press) return darkest_print(*display.press);
  if (!display.palette_has_white) return {};
  const Eigen::RowVector3d weights = xyz_from_rgb(display.primaries).row(1);
  const auto luminance = [&](const Rgb& c) -> double {
    return weights * Eigen::Vector3d(c.r, c.g, c.b);
  };
  const std::vector<Rgb> palette = palette_light(display, BlackPoint::kAbsolute);
  return palette.empty() ? Rgb{} : *std::ranges::min_element(palette, {}, luminance);
}

// Takes light of a display into a picture where that of picture black is 0.
class RelativeLightSink final : public RowSink {
 public:
  RelativeLightSink(Rgb black, Image& picture)
      : black_{black.r, black.g, black.b}, picture_(&picture) {}
  void write(ImageView<const float> rows) override {
    for (int y = 0; y < rows.height; ++y, ++next_) {
      const std::span<const float> from = rows.row(y);
      const std::span<float> to = picture_->view().row(next_);
      for (std::size_t i = 0; i < from.size(); ++i) {
        const double black = black_[i % 3];
        to[i] = static_cast<float>((from[i] - black) / (black < kNoRange ? 1 - black : 1));
      }
    }
  }
  void finish() override {}

 private:
  static constexpr double kNoRange = 1 - 1e-6;  // a channel in which black is as bright as white

  std::array<double, 3> black_;
  Image* picture_;
  int next_ = 0;
};

// A picture whose columns are greys: srgb(x) is the code of column x, [0, 1].
template <typename Code>
Image grey_columns(int width, int height, Code&& srgb) {
  Image image(width, height, 3);
  for (int x = 0; x < width; ++x) {
    std::fill_n(image.view().pixel(x, 0), 3, static_cast<float>(srgb_decode(srgb(x))));
  }
  const auto first = image.view().row(0);
  for (int y = 1; y < height; ++y) {
    std::copy(first.begin(), first.end(), image.view().row(y).begin());
  }
  return image;
}

Image grey_patches() {
  return grey_columns(kPatches * kPatchWidth, kPatchHeight,
                      [](int x) { return x / kPatchWidth / (kPatches - 1.0); });
}

}  // namespace

DitheredPicture dither_picture(ImageView<const float> light, const DitherTrial& trial) {
  ImageSource source(copy_of(light));
  ReduceOptions options;
  options.dither = trial.dither.method;
  options.parameters = trial.parameters;
  options.parameters.screen = screen_parameters(trial.display, trial.parameters.screen);
  Reducer reducer(trial.display, options, light.width);
  DitheredPicture result{Raster<std::uint16_t>(light.width, light.height, reducer.samples()),
                         Image(light.width, light.height, 3)};
  CodeCollector collector(result.codes);
  run(source, {}, reducer, collector);
  const auto decode = decoding_sink(
      trial.display, std::make_unique<RelativeLightSink>(black_light(trial.display), result.light),
      seen_dots(trial.display, options));
  decode->write(result.codes.view());
  decode->finish();
  result.light = shown_light(result.light.view(), trial.display);
  return result;
}

Image shown_light(ImageView<const float> light, const Display& display) {
  const Eigen::Matrix3d matrix = rgb_from_rgb({}, display.primaries, Adaptation::kBradford);
  const Eigen::Vector3d weights = xyz_from_rgb({}).row(1);
  const bool grey = is_monochrome(display);
  Image shown = copy_of(light);
  for (int y = 0; y < light.height; ++y) {
    for (int x = 0; x < light.width; ++x) {
      float* p = shown.view().pixel(x, y);
      Eigen::Vector3d c = matrix * Eigen::Vector3d(p[0], p[1], p[2]);
      if (grey) c.setConstant(weights.dot(c));
      for (int i = 0; i < 3; ++i) p[i] = static_cast<float>(c[i]);
    }
  }
  return shown;
}

DitherFigures judge_dither(ImageView<const float> light, const DitheredPicture& result,
                           const DitherTrial& trial) {
  const Image asked = shown_light(light, trial.display);
  const PicturePair pictures{asked.view(), result.light.view()};
  const Viewing viewing{&kVisionFilters[0], kSamplesPerDegree};
  DitherFigures figures;
  figures.tone_lstar = dither_tone(trial);
  figures.hvs_snr_db =
      hvs_snr(luminance(pictures.reference), luminance(pictures.result), {&viewing, 1})[0];
  figures.scielab_mean = scielab(pictures, kSamplesPerDegree).mean;
  return figures;
}

double dither_tone(const DitherTrial& trial) {
  const Image patches = grey_patches();
  const DitheredPicture result = dither_picture(patches.view(), trial);
  const Image asked = shown_light(patches.view(), trial.display);
  double largest = 0;
  for (const TonePoint& point :
       patch_tones(luminance(asked.view()), luminance(result.light.view()), kPatches)) {
    largest = std::max(largest, std::fabs(lstar_difference(point)));
  }
  return largest;
}

std::optional<TextureFigures> dither_texture(const DitherTrial& trial) {
  Image tone(kTextureSide, kTextureSide, 3);
  for (int y = 0; y < kTextureSide; ++y) {
    std::fill(tone.view().row(y).begin(), tone.view().row(y).end(), kTextureLight);
  }
  return texture_figures(luminance(dither_picture(tone.view(), trial).light.view()));
}

Image grey_ramp(int width, int height) {
  return grey_columns(width, height,
                      [width](int x) { return static_cast<double>(x) / std::max(width - 1, 1); });
}

Display one_bit_display() {
  Display display;
  display.name = "1 bit, black and white";
  display.frame.packing = *find_by_name(kPackings, "mono1");
  display.response = LinearResponse{};
  return display;
}

}  // namespace tristim
