#include <algorithm>

#include "tools/lut.h"
#include "tools/report.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"
#include "tristim/lut/compose.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kExamples =
    "  tristim lut bake --from-device crt-p22 --to linear --curves 1024 -o light.spi1d\n"
    "  tristim lut bake --device srgb --tone-map reinhard:2 -o look.cube\n"
    "  tristim lut compose light.spi1d look.cube -o both.cube\n";

struct Options {
  LutOutput output;
  std::vector<std::string> names;
  std::string look = "rgb:srgb";
  int size = 0, curves = 0;
  bool json = false;
};

// The most points and entries of a table's steps, so that sampling loses little.
LutSampling sampling_of(const Lut& lut) {
  LutSampling most;
  for (const LutStep& step : lut.steps) {
    if (const auto* cube = std::get_if<Lut3D>(&step)) most.cube = std::max(most.cube, cube->size);
    if (const auto* curves = std::get_if<Lut1D>(&step)) {
      most.curves = std::max(most.curves, curves->size);
    }
  }
  return most;
}

Lut fitted(const Lut& lut, const LutFormat& format, const Options& options) {
  if (holds(format, lut) && options.size == 0 && options.curves == 0) return lut;
  LutSampling sampling = sampling_of(lut);
  if (options.curves > 0) sampling.curves = options.curves;
  if (options.size > 0) sampling.cube = options.size;
  return sampled_lut(lut, format, sampling, options.output.path);
}

void declare(CommandLine& line, Options& options) {
  line.positional("LUT...", "tables, the first to be applied first", options.names, 1, 1 << 10);
  declare_lut_output(line, options.output);
  line.option(
      "--size", "N",
      "points of a cube where the result is sampled; default: the most of "
      "the tables, 33 at least",
      [&](const std::string& v) { options.size = integer_option("--size", v, 2, kMostCubeSize); });
  line.option("--curves", "N",
              "entries of curves where the result is sampled; default likewise, "
              "4096 at least",
              [&](const std::string& v) {
                options.curves = integer_option("--curves", v, 2, kMostCurveSize);
              });
  line.option("--look", "MODEL", "what the results are, for errors; default: rgb:srgb",
              options.look);
  line.flag("--json", "print the report as JSON", options.json);
}

}  // namespace

void run_lut_compose(Arguments arguments) {
  Options options;
  CommandLine line(*lut_job("compose"), kExamples);
  declare(line, options);
  if (!line.parse(arguments)) return;
  const LutFormat& format = check_lut_output(options.output, options.names);
  const Look look = look_of(options.look, "--look");
  std::vector<Lut> luts;
  for (const std::string& name : options.names) luts.push_back(read_lut(name));
  const Lut exact = compose(luts);
  const LutFile file = lut_file(fitted(exact, format, options), format, options.output);
  const auto all = [&exact](Rgb c) { return evaluate(exact, c); };
  const CallableSource source(all, look);
  const BakeError error = bake_error(source, file.stored, {input_range(exact), {}});
  write_lut_file(file, options.output);
  if (options.json) {
    return print(json_line({{"output", options.output.path},
                            {"format", format.name},
                            {"table", lut_words(file.stored)},
                            {"ciede2000_largest", number_json(error.largest)},
                            {"ciede2000_mean", number_json(error.mean)}}));
  }
  const std::string text = options.output.path + ": " + lut_words(file.stored) +
                           "; CIEDE2000 to the tables one by one: largest " +
                           rounded(error.largest, 3) + ", mean " + rounded(error.mean, 3);
  options.output.path == "-" ? note(text) : print(text + "\n");
}

}  // namespace tristim::tools
