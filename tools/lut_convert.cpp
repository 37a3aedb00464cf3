#include <algorithm>
#include <cmath>
#include <random>

#include "tools/lut.h"
#include "tools/outputs.h"
#include "tools/report.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/device/display_file.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kExamples =
    "  tristim lut bake --device srgb -o srgb.cube && tristim lut convert srgb.cube srgb.clf\n"
    "  tristim lut convert srgb.cube srgb.3dl --size 33 --bits 16\n"
    "  tristim lut bake --device crt-p22 --curves 4096 -o crt.spi1d\n"
    "  tristim lut convert crt.spi1d crt.ramp --size 1024\n"
    "  tristim lut convert crt.spi1d crt.icc --size 256 --device crt-p22\n"
    "  tristim lut convert crt.spi1d crt.h --size 256 --bits 8 --progmem\n";

constexpr int kProbes = 20'000;  // colours that are compared

struct Options {
  std::vector<std::string> paths;
  LutOutput output;
  LutFileOptions input;
  std::string from, device;
  LutFitSizes sizes;
  bool one_curve = false, cube = false, json = false;
};

void declare(CommandLine& line, Options& options) {
  line.positional("IN OUT",
                  "a table, and the file to write, in the format of its extension; - is standard "
                  "input or output",
                  options.paths, 2, 2);
  line.option("--format", "F", "of the result: " + list_names(lut_formats()),
              options.output.format);
  line.option("--size", "N",
              "sample the table anew: N entries where each channel depends on itself alone and the "
              "format has curves, else N points an edge",
              [&](const std::string& v) {
                options.sizes.curves = integer_option("--size", v, 2, kMostCurveSize);
                options.sizes.cube = options.sizes.curves;
              });
  line.option("--curves", "N", "with --size: entries of the curves before a cube",
              [&](const std::string& v) {
                options.sizes.shaper = integer_option("--curves", v, 2, kMostCurveSize);
              });
  line.option(
      "--bits", "8..16", "of the result's integers; default: the format's own",
      [&](const std::string& v) { options.output.file.bits = integer_option("--bits", v, 8, 16); });
  line.flag("--progmem", "C arrays lie in the program memory of AVR microcontrollers",
            options.output.file.progmem);
  line.option("--device", "D", "the display whose profile an ICC file is; default: srgb",
              options.device);
  line.section("What the input does not say");
  line.option("--from", "F", "its format, where neither bytes nor name tell it", options.from);
  line.option(
      "--from-bits", "8..16", "bits of its integers, of raw and 3dl",
      [&](const std::string& v) { options.input.bits = integer_option("--from-bits", v, 8, 16); });
  line.flag("--cube", "raw bytes are a cube; else they are curves", options.cube);
  line.flag("--one-curve", "raw bytes are one curve for all channels, in and out",
            options.one_curve);
  line.section("Other options");
  line.flag("--json", "print the facts as JSON", options.json);
  line.flag("-f,--force", "replace an existing file", options.output.force);
}

// Where colours make sense: what goes into the first step.
LutRange probed_range(const Lut& lut) {
  if (!lut.steps.empty()) {
    if (const auto* curves = std::get_if<Lut1D>(&lut.steps[0])) return curves->range;
    if (const auto* cube = std::get_if<Lut3D>(&lut.steps[0])) return cube->range;
  }
  return {};
}

// The largest difference of a channel, over colours by chance and greys.
double largest_difference(const Lut& a, const Lut& b) {
  const LutRange range = probed_range(a);
  std::mt19937_64 random(1976);
  double most = 0;
  for (int i = 0; i < kProbes; ++i) {
    std::array<double, 3> in{};
    const double grey = i / double(kProbes - 1);
    for (std::size_t c = 0; c < 3; ++c) {
      const double part = i % 4 == 0 ? grey : static_cast<double>(random() >> 11) * 0x1p-53;
      in[c] = range.low[c] + (range.high[c] - range.low[c]) * part;
    }
    const Rgb x = evaluate(a, {in[0], in[1], in[2]});
    const Rgb y = evaluate(b, {in[0], in[1], in[2]});
    most = std::max({most, std::fabs(x.r - y.r), std::fabs(x.g - y.g), std::fabs(x.b - y.b)});
  }
  return most;
}

// What became of the table, in words; empty where every bit is kept.
std::string change_words(const Lut& lut, const Lut& fitted, const LutFormat& format,
                         const LutFileOptions& options) {
  std::string words;
  if (fitted.steps != lut.steps) words = "sampled as " + lut_words(fitted);
  const int bits = options.bits != 0 ? options.bits : format.holds.bits;
  if (bits != 0) {
    words +=
        (words.empty() ? "" : ", ") + std::string("rounded to ") + std::to_string(bits) + " bits";
  }
  return words;
}

void report(const Options& options, const LutFormat& format, const Lut& lut, const LutFile& file,
            const std::string& change) {
  const double difference = largest_difference(lut, file.stored);
  if (options.json) {
    print(json_line({{"input", options.paths[0]},
                     {"output", options.output.path},
                     {"format", format.name},
                     {"table", lut_words(lut)},
                     {"stored", lut_words(file.stored)},
                     {"largest_difference", number_json(difference)}}));
  } else if (!change.empty()) {
    note(options.output.path + ": note: " + change + "; values differ by up to " +
         rounded(difference, 2));
  }
}

}  // namespace

void run_lut_convert(Arguments arguments) {
  Options options;
  CommandLine line(*lut_job("convert"), kExamples);
  declare(line, options);
  if (!line.parse(arguments)) return;
  LutOutput& output = options.output;
  output.path = options.paths[1];
  if (output.path == "-" && options.json) {
    throw Error(ErrorKind::kMisuse, "--json", "standard output is taken by the table",
                "write the table to a file");
  }
  const LutFormat& format = check_lut_output(output, {options.paths[0]});
  Display display;
  if (!options.device.empty()) {
    display = load_display(options.device);
    output.file.display = &display;
  }
  options.input.cube = options.cube;
  options.input.one_curve = output.file.one_curve = options.one_curve;
  const Lut lut = read_lut(options.paths[0], options.from, options.input);
  const Lut fitted =
      options.sizes.cube > 0 ? fit_lut(lut, format, options.sizes, output.path) : lut;
  const LutFile file = lut_file(fitted, format, output);
  write_lut_file(file, output);
  report(options, format, lut, file, change_words(lut, fitted, format, output.file));
}

}  // namespace tristim::tools
