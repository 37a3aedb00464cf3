#include "tristim/pipeline/dither_trial.h"

#include <algorithm>
#include <cmath>

#include "tristim/color/transfer.h"
#include "tristim/core/find.h"
#include "tristim/image/memory.h"
#include "tristim/measure/tone.h"
#include "tristim/measure/vision.h"
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

// What the codes look like where picture black is the display's, as the reducer has it.
void decode(const Display& display, ImageView<const std::uint16_t> codes, ImageView<float> light) {
  const std::vector<Rgb> palette = palette_light(display, BlackPoint::kRelative);
  if (palette.empty()) return Decoder(display).decode(codes, light);
  for (int y = 0; y < codes.height; ++y) {
    for (int x = 0; x < codes.width; ++x) {
      const Rgb& color = palette[*codes.pixel(x, y)];
      float* to = light.pixel(x, y);
      to[0] = static_cast<float>(color.r);
      to[1] = static_cast<float>(color.g);
      to[2] = static_cast<float>(color.b);
    }
  }
}

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
  Reducer reducer(trial.display, options, light.width);
  DitheredPicture result{Raster<std::uint16_t>(light.width, light.height, reducer.samples()),
                         Image(light.width, light.height, 3)};
  CodeCollector collector(result.codes);
  run(source, {}, reducer, collector);
  decode(trial.display, result.codes.view(), result.light.view());
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
      for (int i = 0; i < 3; ++i) p[i] = static_cast<float>(std::clamp(c[i], 0.0, 1.0));
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
