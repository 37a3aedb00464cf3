#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "tools/lut.h"
#include "tools/outputs.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/frame/io/write.h"
#include "tristim/image/io/exr.h"
#include "tristim/image/io/read.h"
#include "tristim/lut/compose.h"
#include "tristim/lut/rows.h"
#include "tristim/pipeline/reduce.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kExamples =
    "  tristim render spheres -o spheres.exr\n"
    "  tristim lut bake --device crt-p22 -o crt.cube\n"
    "  tristim lut apply spheres.exr crt.cube -o spheres.png\n"
    "  tristim lut apply spheres.exr crt.cube -o spheres-16.png --bits 16\n"
    "  tristim lut apply spheres.exr crt.cube -o coded.exr --interpolation trilinear\n";

struct Options {
  std::vector<std::string> names;  // the picture, then tables
  std::string output;
  const LutInterpolation* interpolation = &kLutInterpolations[0];
  int bits = 8;
  int threads = 0;
  bool light = false, force = false;
};

bool is_exr(const std::string& path) {
  return same_name(std::filesystem::path(path).extension().string(), ".exr");
}

std::unique_ptr<RowSink> exr_sink(const Options& options, PictureInfo info) {
  info.grey = false;
  return open_exr_sink(options.output, info, {.pixel = ExrPixel::kFloat, .replace = options.force});
}

// Codes of three channels, [0, 1] being all of them: rounded half up, what is beyond clipped.
class RoundingSink final : public RowSink {
 public:
  RoundingSink(const Options& options, const PictureInfo& info)
      : most_(static_cast<float>((1 << options.bits) - 1)) {
    Display display;
    display.frame.packing = *find_by_name(kPackings, options.bits == 16 ? "rgb48" : "rgb888");
    FrameInfo frame = frame_info(display, info.width, info.height);
    frame.srgb = false;  // what the codes are, the table knows
    sink_ = open_code_sink(options.output, frame,
                           {.format = options.output == "-" ? "png" : "",
                            .replace = options.force,
                            .threads = options.threads});
  }

  void write(ImageView<const float> rows) override {
    Raster<std::uint16_t> codes(rows.width, rows.height, 3);
    for (int y = 0; y < rows.height; ++y) {
      std::uint16_t* to = codes.view().row(y).data();
      for (int x = 0; x < rows.width; ++x) {
        for (int c = 0; c < 3; ++c) *to++ = code(rows.pixel(x, y)[c]);
      }
    }
    sink_->write(codes.view());
  }

  void finish() override { sink_->finish(); }

 private:
  std::uint16_t code(float x) const {
    const float inside = std::min(std::max(0.0F, x), 1.0F);  // NaN becomes 0
    return static_cast<std::uint16_t>(std::floor(double{inside} * most_ + 0.5));
  }

  float most_;
  std::unique_ptr<CodeSink> sink_;
};

Lut read_tables(const Options& options) {
  std::vector<Lut> luts;
  for (std::size_t i = 1; i < options.names.size(); ++i) luts.push_back(read_lut(options.names[i]));
  return compose(luts);
}

void declare(CommandLine& line, Options& options) {
  line.positional("IN", "picture", options.names, 2, 1 << 10);
  line.option("-o,--output", "OUT",
              "EXR of floats, or codes: PNG, TIFF, PPM; - is standard output, a PNG",
              options.output);
  line.option("--interpolation", list_names(kLutInterpolations, "|"),
              "between the points of cubes; default: tetrahedral",
              [&](const std::string& v) { options.interpolation = &interpolation_option(v); });
  line.option("--bits", "8|16", "of codes; default: 8", [&](const std::string& v) {
    options.bits = integer_option("--bits", v, 8, 16);
    if (options.bits == 8 || options.bits == 16) return;
    throw Error(ErrorKind::kMisuse, "--bits", "'" + v + "' is neither 8 nor 16",
                "give one of them");
  });
  line.flag("--light", "decode the codes of integer pictures to light first", options.light);
  line.option(
      "--threads", "N", "default: one for each processor; the result is the same",
      [&](const std::string& v) { options.threads = integer_option("--threads", v, 0, 256); });
  line.flag("-f,--force", "replace an existing file", options.force);
}

}  // namespace

void run_lut_apply(Arguments arguments) {
  Options options;
  CommandLine line(*lut_job("apply"), kExamples);
  declare(line, options);
  if (!line.parse(arguments)) return;
  if (options.output.empty()) {
    throw Error(ErrorKind::kMisuse, "--output", "is missing",
                "give -o result.exr, or another name");
  }
  refuse_missing_inputs(options.names);
  refuse_inputs_as_outputs(options.names, {options.output});
  refuse_taken_outputs({options.output}, options.force);
  refuse_terminal(options.output);
  const LutRows rows(read_tables(options), *options.interpolation);
  const auto picture =
      open_picture(options.names[0], {.threads = options.threads, .codes = !options.light});
  const PictureInfo& info = picture->info();
  std::unique_ptr<RowSink> sink;
  if (is_exr(options.output)) {
    sink = exr_sink(options, info);
  } else {
    sink = std::make_unique<RoundingSink>(options, info);
  }
  const int band_rows = std::clamp(info.chunk_rows, 16, 256);
  Image band(info.width, band_rows, info.channels);
  for (int y = 0; y < info.height; y += band_rows) {
    const ImageView<float> part = band.view().rows(0, std::min(band_rows, info.height - y));
    picture->read(part);
    apply(rows, part, part, options.threads);
    sink->write(part);
  }
  sink->finish();
}

}  // namespace tristim::tools
