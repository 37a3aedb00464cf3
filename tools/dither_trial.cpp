#include "tools/dither_trial.h"

#include <algorithm>
#include <cmath>

#include "tristim/color/transfer.h"
#include "tristim/core/find.h"
#include "tristim/image/memory.h"
#include "tristim/measure/tone.h"
#include "tristim/measure/vision.h"
#include "tristim/pipeline/run.h"

namespace tristim::tools {
namespace {

constexpr int kPatches = 17;
constexpr int kPatchWidth = 64;
constexpr int kPatchHeight = 192;
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

void set_grey(ImageView<float> picture, int x, int y, double srgb) {
  std::fill_n(picture.pixel(x, y), 3, static_cast<float>(srgb_decode(srgb)));
}

Image grey_patches() {
  Image patches(kPatches * kPatchWidth, kPatchHeight, 3);
  for (int y = 0; y < kPatchHeight; ++y) {
    for (int x = 0; x < kPatches * kPatchWidth; ++x) {
      set_grey(patches.view(), x, y, x / kPatchWidth / (kPatches - 1.0));
    }
  }
  return patches;
}

// The largest difference in L* over the patches.
double tone_error(const Display& display, const NamedDither& dither) {
  const Image patches = grey_patches();
  const Dithered result = dither_picture(patches.view(), display, dither);
  double largest = 0;
  const Image asked = shown_light(patches.view(), display);
  for (const TonePoint& point :
       patch_tones(luminance(asked.view()), luminance(result.light.view()), kPatches)) {
    largest = std::max(largest, std::fabs(lstar_difference(point)));
  }
  return largest;
}

}  // namespace

Dithered dither_picture(ImageView<const float> light, const Display& display,
                        const NamedDither& dither) {
  ImageSource source(copy_of(light));
  ReduceOptions options;
  options.dither = dither.method;
  Reducer reducer(display, options, light.width);
  Dithered result{Raster<std::uint16_t>(light.width, light.height, reducer.samples()),
                  Image(light.width, light.height, 3)};
  CodeCollector collector(result.codes);
  run(source, {}, reducer, collector);
  Decoder(display).decode(result.codes.view(), result.light.view());
  result.light = shown_light(result.light.view(), display);
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

DitherFigures judge_dither(ImageView<const float> light, const Dithered& result,
                           const Display& display, const NamedDither& dither) {
  const Image asked = shown_light(light, display);
  const PicturePair pictures{asked.view(), result.light.view()};
  const Viewing viewing{&kVisionFilters[0], kSamplesPerDegree};
  DitherFigures figures;
  figures.tone_max = tone_error(display, dither);
  figures.hvs_snr =
      hvs_snr(luminance(pictures.reference), luminance(pictures.result), {&viewing, 1})[0];
  figures.scielab_mean = scielab(pictures, kSamplesPerDegree).mean;
  return figures;
}

Image grey_ramp(int width, int height) {
  Image ramp(width, height, 3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      set_grey(ramp.view(), x, y, static_cast<double>(x) / std::max(width - 1, 1));
    }
  }
  return ramp;
}

Display one_bit_display() {
  Display display;
  display.name = "1 bit, black and white";
  display.frame.packing = *find_by_name(kPackings, "mono1");
  display.response = LinearResponse{};
  return display;
}

}  // namespace tristim::tools
