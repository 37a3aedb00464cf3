#include "tools/halftone.h"
#include "tools/outputs.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"
#include "tristim/frame/io/write.h"
#include "tristim/image/io/read.h"
#include "tristim/image/repeat.h"
#include "tristim/pipeline/chain.h"
#include "tristim/pipeline/run.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kExamples =
    "  tristim render spheres -o s.exr && tristim halftone cells s.exr -o s.png\n"
    "  tristim render spheres -o s.exr && tristim halftone cells s.exr --matrix d3 --bits 2 -o "
    "s.png\n"
    "  tristim render spheres -o s.exr && tristim halftone cells s.exr --bits 3,3,2 -o s.png\n";

struct Options {
  std::vector<std::string> inputs;
  std::string output, matrix = "d2";
  MatrixOptions of_matrix;
  std::array<int, 3> bits{1, 0, 0};
  int channels = 1;
  bool force = false;
};

void set_bits(Options& options, const std::string& text) {
  const std::vector<std::string_view> parts = split(text, ',');
  if (parts.size() != 1 && parts.size() != 3) {
    throw Error(ErrorKind::kMisuse, "--bits", "'" + text + "' is for no device",
                "give the bits of a grey, or of red, green and blue: 3,3,2");
  }
  options.channels = static_cast<int>(parts.size());
  options.bits = {};
  for (std::size_t c = 0; c < parts.size(); ++c) {
    options.bits[c] = integer_option("--bits", parts[c], 1, 16);
  }
}

// A device whose values are intensities: value v of m bits is v / (2^m - 1) of its white.
Display linear_device(const Options& options) {
  Display display;
  display.name = "cells";
  display.response = LinearResponse{};
  Packing& packing = display.frame.packing;
  packing = {"", options.channels, options.bits, false, false};
  for (const Packing& known : kPackings) {
    const bool same = known.samples == packing.samples && known.bits == packing.bits;
    if (same && !known.indexed && !known.blue_first) packing = known;
  }
  return display;
}

}  // namespace

void run_halftone_cells(Arguments arguments) {
  Options options;
  CommandLine line(*halftone_job("cells"), kExamples);
  line.positional("IN", "a picture", options.inputs, 1, 1);
  line.option("-o,--output", "OUT", "the device's pixels: .png, .pbm, .pgm, .ppm, ...",
              options.output);
  line.option("--matrix", "NAME|FILE", "the cell; default: d2", options.matrix);
  declare_matrix_options(line, options.of_matrix);
  line.option("--bits", "M|R,G,B", "bits of the device, whose values are intensities; default: 1",
              [&options](const std::string& v) { set_bits(options, v); });
  line.flag("-f,--force", "replace an existing file", options.force);
  if (!line.parse(arguments)) return;
  if (options.output.empty()) {
    throw Error(ErrorKind::kMisuse, "--output", "is missing", "give -o cells.png");
  }
  const std::string& input = options.inputs.front();
  refuse_missing_inputs({input});
  refuse_inputs_as_outputs({input}, {options.output});
  refuse_taken_outputs({options.output}, options.force);
  refuse_terminal(options.output);

  const ThresholdMatrix matrix = halftone_matrix(options.matrix, options.of_matrix);
  const Display display = linear_device(options);
  const auto picture = repeat_pixels(prepare(open_picture(input), display, {}, nullptr),
                                     matrix.width, matrix.height);
  const PictureInfo& info = picture->info();
  Settings settings;
  settings.dither = NamedDither{matrix.name, matrix, matrix.source};
  const StageList stages = stage_list(info, display, settings);
  Reducer reducer(display, reduce_options(display, settings), info.width);
  const auto sink = open_code_sink(options.output, frame_info(display, info.width, info.height),
                                   {.replace = options.force});
  run(*picture, stages.stages, reducer, *sink);
  sink->finish();
}

}  // namespace tristim::tools
