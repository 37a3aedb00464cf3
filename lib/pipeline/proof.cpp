#include "tristim/pipeline/proof.h"

#include <algorithm>

#include "tristim/color/difference.h"
#include "tristim/color/lab.h"

namespace tristim {
namespace {

Lab srgb_lab(const Eigen::Vector3d& light) {
  static const Eigen::Matrix3d matrix = xyz_from_rgb(Primaries{});
  const Eigen::Vector3d c = light.cwiseMax(0).cwiseMin(1);
  return rgb_to_lab({c.x(), c.y(), c.z()}, matrix);
}

Eigen::Matrix3d srgb_from(const Primaries& primaries, Adaptation adaptation) {
  return rgb_from_rgb(Primaries{}, primaries, adaptation);
}

class DecodingSink : public CodeSink {
 public:
  DecodingSink(const Display& display, std::unique_ptr<RowSink> light)
      : decoder_(display), light_(std::move(light)) {}
  void write(ImageView<const std::uint16_t> rows) override {
    Image light(rows.width, rows.height, 3);
    decoder_.decode(rows, light.view());
    light_->write(light.view());
  }
  void finish() override { light_->finish(); }

 private:
  Decoder decoder_;
  std::unique_ptr<RowSink> light_;
};

}  // namespace

ProofObserver::ProofObserver(const Display& display, CodeSink& sink)
    : decoder_(display),
      to_srgb_(Display{}, {}, 0),
      to_srgb_primaries_(ConvertPrimaries{srgb_from(display.primaries, Adaptation::kBradford),
                                          display.primaries, Primaries{}, Adaptation::kBradford}),
      sink_(&sink) {}

void ProofObserver::seen(ImageView<const float> /*light*/, ImageView<const std::uint16_t> codes) {
  Image light(codes.width, codes.height, 3);
  decoder_.decode(codes, light.view());
  StageCounts ignored;
  apply(to_srgb_primaries_, {light.view(), y_}, ignored);
  Raster<std::uint16_t> srgb(codes.width, codes.height, 3);
  to_srgb_.reduce({light.view(), y_}, srgb.view());
  sink_->write(srgb.view());
  y_ += codes.height;
}

DifferenceObserver::DifferenceObserver(const Primaries& picture, Adaptation adaptation,
                                       const Display& display, int scene_stages)
    : decoder_(display),
      srgb_from_picture_(srgb_from(picture, adaptation)),
      srgb_from_device_(srgb_from(display.primaries, Adaptation::kBradford)),
      scene_stages_(scene_stages) {}

void DifferenceObserver::seen(ImageView<const float> light, ImageView<const std::uint16_t> codes) {
  const int samples = codes.channels;
  for (int y = 0; y < codes.height; ++y) {
    const float* asked = light.row(y).data();
    const std::uint16_t* code = codes.row(y).data();
    for (int x = 0; x < codes.width; ++x, asked += 3, code += samples) {
      const Rgb shown = decoder_.light(code);
      sum_ +=
          ciede2000(srgb_lab(srgb_from_picture_ * Eigen::Vector3d(asked[0], asked[1], asked[2])),
                    srgb_lab(srgb_from_device_ * Eigen::Vector3d(shown.r, shown.g, shown.b)));
    }
  }
  pixels_ += static_cast<std::uint64_t>(codes.width) * static_cast<std::uint64_t>(codes.height);
}

std::unique_ptr<CodeSink> decoding_sink(const Display& display, std::unique_ptr<RowSink> light) {
  return std::make_unique<DecodingSink>(display, std::move(light));
}

}  // namespace tristim
