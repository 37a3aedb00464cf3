#include "tristim/pipeline/proof.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "lib/pipeline/printed_dots.h"
#include "tristim/color/difference.h"
#include "tristim/color/lab.h"
#include "tristim/color/models.h"
#include "tristim/color/rows.h"

namespace tristim {
namespace {

// A row of pixels that is filled with light and then becomes L*a*b*: within 4e-5, ten times as fast
// as colour by colour.
class LabRow {
 public:
  explicit LabRow(int width) : values_(static_cast<std::size_t>(width) * 3) {}

  void set(int x, const Eigen::Vector3d& srgb_light) noexcept {
    const Eigen::Vector3f c = srgb_light.cwiseMax(0).cwiseMin(1).cast<float>();
    for (int i = 0; i < 3; ++i) at(x, i) = c[i];
  }
  void convert() {
    static const RowConversion to_lab(parse_model("linear:srgb", "proof"),
                                      parse_model("lab", "proof"), Adaptation::kNone);
    to_lab(values_, 3, values_, 3);
  }
  Lab lab(int x) noexcept { return {at(x, 0), at(x, 1), at(x, 2)}; }

 private:
  float& at(int x, int i) noexcept { return values_[static_cast<std::size_t>(x * 3 + i)]; }

  std::vector<float> values_;
};

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

// Light of a device as 8-bit sRGB.
class SrgbSink final : public RowSink {
 public:
  SrgbSink(const Display& display, CodeSink& sink)
      : reducer_(Display{}, {}, 0),
        to_primaries_(ConvertPrimaries{srgb_from(display.primaries, Adaptation::kBradford),
                                       display.primaries, Primaries{}, Adaptation::kBradford}),
        sink_(&sink) {}
  void write(ImageView<const float> rows) override {
    Image light(rows.width, rows.height, 3);
    for (int y = 0; y < rows.height; ++y) {
      std::ranges::copy(rows.row(y), light.view().row(y).begin());
    }
    StageCounts ignored;
    apply(to_primaries_, {light.view()}, ignored);
    Raster<std::uint16_t> srgb(rows.width, rows.height, 3);
    reducer_.reduce({light.view()}, srgb.view());
    sink_->write(srgb.view());
  }
  void finish() override { sink_->finish(); }

 private:
  Reducer reducer_;
  Stage to_primaries_;
  CodeSink* sink_;
};

}  // namespace

SeenDots seen_dots(const Display& display, const ReduceOptions& options) {
  const bool dithered = !std::holds_alternative<NoDither>(options.dither);
  const bool gains = display.press || (is_monochrome(display) && dithered);
  SeenDots dots;
  if (!display.dots || !gains) return dots;
  dots.gain = display.dots->gain;
  const ScreenParameters& screen = options.parameters.screen;
  if (screen.dpi > 0) {
    constexpr double kMostReach = 1000;
    const double cell = screen.dpi / (screen.lpi > 0 ? screen.lpi : usual_lpi(screen.dpi));
    dots.reach = std::max(dots.reach, static_cast<int>(std::ceil(std::min(cell, kMostReach))));
  }
  return dots;
}

ProofObserver::ProofObserver(const Display& display, CodeSink& sink, const SeenDots& dots)
    : decode_(decoding_sink(display, std::make_unique<SrgbSink>(display, sink), dots)) {}

void ProofObserver::seen(ImageView<const float> /*light*/, ImageView<const std::uint16_t> codes) {
  decode_->write(codes);
}

void ProofObserver::finish() { decode_->finish(); }

DifferenceObserver::DifferenceObserver(const Primaries& picture, Adaptation adaptation,
                                       const Display& display, int scene_stages)
    : decoder_(display),
      srgb_from_picture_(srgb_from(picture, adaptation)),
      srgb_from_device_(srgb_from(display.primaries, Adaptation::kBradford)),
      scene_stages_(scene_stages) {}

void DifferenceObserver::seen(ImageView<const float> light, ImageView<const std::uint16_t> codes) {
  const int samples = codes.channels;
  LabRow asked(codes.width);
  LabRow shown(codes.width);
  for (int y = 0; y < codes.height; ++y) {
    const float* picture = light.row(y).data();
    const std::uint16_t* code = codes.row(y).data();
    for (int x = 0; x < codes.width; ++x, picture += 3, code += samples) {
      const Rgb device = decoder_.light(code);
      asked.set(x, srgb_from_picture_ * Eigen::Vector3d(picture[0], picture[1], picture[2]));
      shown.set(x, srgb_from_device_ * Eigen::Vector3d(device.r, device.g, device.b));
    }
    asked.convert();
    shown.convert();
    for (int x = 0; x < codes.width; ++x) sum_ += ciede2000(asked.lab(x), shown.lab(x));
  }
  pixels_ += static_cast<std::uint64_t>(codes.width) * static_cast<std::uint64_t>(codes.height);
}

std::unique_ptr<CodeSink> decoding_sink(const Display& display, std::unique_ptr<RowSink> light,
                                        const SeenDots& dots) {
  if (!std::holds_alternative<NoGain>(dots.gain)) {
    return std::make_unique<detail::PrintedDotsSink>(display, dots, std::move(light));
  }
  return std::make_unique<DecodingSink>(display, std::move(light));
}

}  // namespace tristim
