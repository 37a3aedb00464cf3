#include <algorithm>
#include <cmath>
#include <random>

#include "tools/lut.h"
#include "tools/report.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"
#include "tristim/lut/compose.h"
#include "tristim/lut/invert.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kExamples =
    "  tristim lut bake --from-device crt-p22 --to linear --curves 256 -o light.spi1d\n"
    "  tristim lut invert light.spi1d -o codes.spi1d\n"
    "  tristim lut bake --device crt-p22 --from rgb:srgb -o crt.cube\n"
    "  tristim lut invert crt.cube -o back.cube --size 65\n";

constexpr int kProbes = 20'000;  // colours that are sent there and back

struct Options {
  LutOutput output;
  std::string look = "rgb:srgb";
  std::vector<std::string> names;
  int size = 0, curves = 0;
  bool json = false;
};

// Colours by chance that go into a table; what comes out of it can be inverted.
std::vector<Rgb> inputs_of(const Lut& lut) {
  const LutRange range = input_range(lut);
  std::mt19937_64 random(1976);
  const auto part = [&](std::size_t c) {
    const double at = static_cast<double>(random() >> 11) * 0x1p-53;
    return range.low[c] + (range.high[c] - range.low[c]) * at;
  };
  std::vector<Rgb> inputs;
  for (int i = 0; i < kProbes; ++i) {
    const double r = part(0);
    const double g = part(1);
    inputs.push_back({r, g, part(2)});
  }
  return inputs;
}

// What the results of a table reach from and to: [0, 1] where that holds them.
LutRange results_of(const Lut& lut, const std::vector<Rgb>& results) {
  LutRange range;
  const auto widen = [&](std::size_t c, double x) {
    range.low[c] = std::min(range.low[c], x);
    range.high[c] = std::max(range.high[c], x);
  };
  for (const Rgb& c : results) {
    widen(0, c.r);
    widen(1, c.g);
    widen(2, c.b);
  }
  if (const auto* cube = std::get_if<Lut3D>(&lut.steps.back())) {
    for (std::size_t i = 0; i < cube->rgb.size(); ++i) widen(i % 3, cube->rgb[i]);
  }
  return range;
}

int cube_size_of(const Lut& lut) {
  int size = 2;
  for (const LutStep& step : lut.steps) {
    if (const auto* cube = std::get_if<Lut3D>(&step)) size = std::max(size, cube->size);
  }
  return size;
}

Lut inverted_steps(const Lut& lut, const LutFormat& format, const Options& options) {
  const Lut exact = invert(lut);
  if (holds(format, exact) && options.curves == 0) return exact;
  LutSampling sampling;
  if (const auto* curves = std::get_if<Lut1D>(&lut.steps.front())) {
    sampling.curves = std::max(sampling.curves, curves->size);
  }
  if (options.curves > 0) sampling.curves = options.curves;
  if (options.size > 0) sampling.cube = options.size;
  return sampled_lut(exact, format, sampling, options.output.path);
}

Lut inverted_cube(const Lut& lut, const Look& look, const LutRange& range, int size) {
  const LutInverse inverse(lut);
  return bake_cube(CallableSource(inverse, look), {range, {}}, size);
}

// There and back: what comes out of the table, through its inverse and through the table again.
BakeError round_trip(const Lut& lut, const Lut& inverse, const Look& look,
                     const std::vector<Rgb>& results) {
  const auto same = [](Rgb c) { return c; };
  const Lut both[] = {inverse, lut};
  return bake_error(CallableSource(same, look), compose(both), results);
}

void declare(CommandLine& line, Options& options) {
  line.positional("LUT", "a table whose curves rise or fall throughout", options.names, 1, 1);
  declare_lut_output(line, options.output);
  line.option(
      "--size", "N", "points of the inverse of a cube; default: as many as it has",
      [&](const std::string& v) { options.size = integer_option("--size", v, 2, kMostCubeSize); });
  line.option("--curves", "N",
              "entries of the inverse of curves, where the format has no points of "
              "its own; default: 4096, or as many as they have",
              [&](const std::string& v) {
                options.curves = integer_option("--curves", v, 2, kMostCurveSize);
              });
  line.option("--look", "MODEL", "what the table's results are, for errors; default: rgb:srgb",
              options.look);
  line.flag("--json", "print the report as JSON", options.json);
}

Lut read_sound(const std::string& name) {
  Lut lut = read_lut(name);
  if (!lut.steps.empty()) return lut;
  throw Error(ErrorKind::kContent, name, "is the identity: it undoes itself");
}

// What the library says of a table that has no inverse is the file's fault.
template <typename Invert>
Lut of_content(const std::string& name, Invert&& inverse) {
  try {
    return inverse();
  } catch (const std::invalid_argument& error) {
    throw Error(ErrorKind::kContent, name, error.what());
  }
}

}  // namespace

void run_lut_invert(Arguments arguments) {
  Options options;
  CommandLine line(*lut_job("invert"), kExamples);
  declare(line, options);
  if (!line.parse(arguments)) return;
  const LutFormat& format = check_lut_output(options.output, options.names);
  const std::string& name = options.names[0];
  const Look look = look_of(options.look, "--look");
  const Lut lut = read_sound(name);
  std::vector<Rgb> results = inputs_of(lut);
  for (Rgb& c : results) c = evaluate(lut, c);
  const bool exact = inverts_exactly(lut);
  const Lut inverse = of_content(name, [&] {
    if (exact) return inverted_steps(lut, format, options);
    const int size = options.size > 0 ? options.size : cube_size_of(lut);
    return inverted_cube(lut, look, results_of(lut, results), size);
  });
  const LutFile file = lut_file(inverse, format, options.output);
  const BakeError error = round_trip(lut, file.stored, look, results);
  write_lut_file(file, options.output);
  if (options.json) {
    return print(json_line({{"output", options.output.path},
                            {"format", format.name},
                            {"table", lut_words(file.stored)},
                            {"exact", exact && holds(format, invert(lut))},
                            {"ciede2000_largest", number_json(error.largest)},
                            {"ciede2000_mean", number_json(error.mean)}}));
  }
  const std::string text = options.output.path + ": " + lut_words(file.stored) +
                           "; CIEDE2000 after there and back again: largest " +
                           rounded(error.largest, 3) + ", mean " + rounded(error.mean, 3);
  options.output.path == "-" ? note(text) : print(text + "\n");
}

}  // namespace tristim::tools
