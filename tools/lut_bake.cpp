#include <algorithm>

#include "tools/lut.h"
#include "tools/lut_source.h"
#include "tools/report.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/lut/shaper.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kExamples =
    "  tristim lut bake --device crt-p22 -o crt.cube\n"
    "  tristim lut bake --device srgb --exposure 1 --tone-map reinhard:8 --range 0,16 -o "
    "look.cube\n"
    "  tristim lut bake --from-device crt-p22 --device srgb --size 65 -o monitors.cube\n"
    "  tristim lut bake --device srgb --exposure -1 -o darker.cube --max-error .5\n"
    "  tristim lut bake --device crt-p22 --curves 1024 -o crt.spi1d\n"
    "  tristim lut bake --from rgb:bt2020/pq --to rgb:srgb --explain -o pq.csp\n";

constexpr double kFine = 0.1;        // the difference whose size of cube is told
constexpr int kUsualEntries = 4096;  // of a shaper over about [0, 1]
constexpr int kMostEntries = 65536;  // and over wider ranges
constexpr double kWide = 2;

struct Options {
  LutOutput output;
  LutWay way;
  std::vector<GivenSetting> settings;
  std::optional<int> size, curves;
  std::string shaper = "auto";
  LutRange range;
  const LutInterpolation* interpolation = &kLutInterpolations[0];
  std::string title;
  std::optional<double> max_error;
  int threads = 0;
  bool explain = false, json = false;
};

LutRange range_option(const std::string& text) {
  std::vector<double> ends;
  for (const std::string_view part : split(text, ',')) {
    const auto end = parse_number(part);
    if (end) ends.push_back(*end);
  }
  if (ends.size() == 2) ends = {ends[0], ends[1], ends[0], ends[1], ends[0], ends[1]};
  LutRange range;
  const bool whole = ends.size() == 6 && split(text, ',').size() % 2 == 0;
  for (std::size_t c = 0; whole && c < 3; ++c) {
    range.low[c] = ends[2 * c];
    range.high[c] = ends[2 * c + 1];
  }
  const bool sound = whole && std::ranges::all_of(std::array{0, 1, 2}, [&](int c) {
                       const double width = range.high[static_cast<std::size_t>(c)] -
                                            range.low[static_cast<std::size_t>(c)];
                       return width > 0 && width < 1e30;
                     });
  if (sound) return range;
  throw Error(ErrorKind::kMisuse, "--range", "'" + text + "' is no range",
              "give low and high, for all channels or for each: 0,16");
}

void declare(CommandLine& line, Options& options) {
  declare_lut_output(line, options.output);
  line.option(
      "--size", "N", "points of a cube's edge, 2 to 256; default: 33",
      [&](const std::string& v) { options.size = integer_option("--size", v, 2, kMostCubeSize); });
  line.option("--curves", "N", "curves of N entries instead of a cube: what greys become",
              [&](const std::string& v) {
                options.curves = integer_option("--curves", v, 2, kMostCurveSize);
              });
  line.option(
      "--shaper", "auto|none|N",
      "curves in front of the cube, of N entries, that give darks more room; default: auto, "
      "where the format has them",
      options.shaper);
  line.option("--range", "LOW,HIGH", "of the input, for all channels or six numbers; default: 0,1",
              [&](const std::string& v) { options.range = range_option(v); });
  line.option("--interpolation", list_names(kLutInterpolations, "|"),
              "that errors are measured with; default: tetrahedral",
              [&](const std::string& v) { options.interpolation = &interpolation_option(v); });
  line.option("--title", "TEXT", "of the table, where the format has one", options.title);
  line.option(
      "--max-error", "E", "exit code 4, and no file, where the largest CIEDE2000 is beyond",
      [&](const std::string& v) { options.max_error = number_option("--max-error", v, 0, 1000); });
  line.option(
      "--threads", "N", "default: one for each processor; the result is the same",
      [&](const std::string& v) { options.threads = integer_option("--threads", v, 0, 256); });
  line.flag("--explain", "print every step of the chain", options.explain);
  line.flag("--json", "print the report as JSON", options.json);
  line.section("From what to what");
  declare_lut_way(line, options.way);
  declare_lut_settings(line, options.settings);
}

void check(const Options& options, const LutFormat& format) {
  if (options.size && options.curves) {
    throw Error(ErrorKind::kMisuse, "--curves", "does not go with --size", "give one of them");
  }
  if (options.output.path == "-" && (options.json || options.explain)) {
    throw Error(ErrorKind::kMisuse, options.json ? "--json" : "--explain",
                "standard output is taken by the table", "write the table to a file");
  }
  if (!options.curves && format.holds.cube == 0 && !format.holds.any) {
    throw Error(ErrorKind::kMisuse, "format " + std::string(format.name), "has no cubes",
                "give --curves N, or another format");
  }
}

// Over a wide range darks are a small part of equal steps.
bool is_wide(const LutRange& range) {
  double width = 0;
  for (std::size_t c = 0; c < 3; ++c) width = std::max(width, range.high[c] - range.low[c]);
  return width > kWide;
}

// Of the shaper; 0: there is none.
int shaper_entries(const Options& options, const LutFormat& format) {
  const bool has = format.holds.shaper > 0 || format.holds.any;
  if (same_name(options.shaper, "none")) return 0;
  if (!same_name(options.shaper, "auto")) {
    const int entries = integer_option("--shaper", options.shaper, 2, kMostCurveSize);
    if (has) return entries;
    throw Error(ErrorKind::kMisuse, "--shaper",
                "format " + std::string(format.name) + " has no curves in front of a cube",
                "use --shaper none, or another format");
  }
  if (!has) return 0;
  const int entries = is_wide(options.range) && !format.holds.points ? kMostEntries : kUsualEntries;
  return format.holds.shaper > 0 ? std::min(entries, format.holds.shaper) : entries;
}

// A table with where it was sampled.
struct Baked {
  Lut lut;
  BakeGrid grid;
  std::string shaper = "none";
};

Baked bake(const Options& options, const LutFormat& format, const BakeSource& source) {
  Baked baked{{}, {options.range, {}}, "none"};
  if (options.curves) {
    baked.lut.steps = {bake_curves(source, options.range, *options.curves, options.threads)};
    return baked;
  }
  const int size = options.size.value_or(33);
  if (const int entries = shaper_entries(options, format); entries > 0) {
    const bool points = format.holds.points && is_wide(options.range);
    const Shaper shaper = choose_shaper(source, options.range, size, entries, points,
                                        *options.interpolation, options.threads);
    baked.shaper = describe(shaper);
    if (shaper.shape != nullptr) baked.grid.shaper = shaper_step(shaper, entries, points);
  }
  baked.lut = bake_cube(source, baked.grid, size, options.threads);
  return baked;
}

struct Findings {
  BakeError all, greys;
  std::optional<int> fine_size;  // of cubes
};

Findings measure(const Options& options, const BakeSource& source, const Baked& baked,
                 const Lut& stored) {
  const auto& how = *options.interpolation;
  Findings found;
  found.all = bake_error(source, stored, baked.grid, how, options.threads);
  found.greys = grey_error(source, stored, baked.grid, how, options.threads);
  if (!options.curves) {
    found.fine_size = cube_size_for(source, baked.grid, kFine, how, options.threads);
  }
  return found;
}

std::string color_text(Rgb c) {
  return rounded(c.r, 4) + " " + rounded(c.g, 4) + " " + rounded(c.b, 4);
}

std::string fine_text(const Findings& found) {
  if (!found.fine_size) {
    return "no cube of up to " + std::to_string(kMostCubeSize) + " points reaches " +
           shortest(kFine);
  }
  return "a cube of " + std::to_string(*found.fine_size) + " points would reach " + shortest(kFine);
}

std::string report_text(const Options& options, const Baked& baked, const Lut& stored,
                        const Findings& found) {
  const LutRange& range = options.range;
  std::string text = options.output.path + ": " + lut_words(stored) + ", from " +
                     color_text({range.low[0], range.low[1], range.low[2]}) + " to " +
                     color_text({range.high[0], range.high[1], range.high[2]}) + "\n";
  if (!options.curves) text += "  shaper: " + baked.shaper + "\n";
  text += "  CIEDE2000 to the exact chain: largest " + rounded(found.all.largest, 3) + " at " +
          color_text(found.all.worst) + ", mean " + rounded(found.all.mean, 3) + ", over " +
          std::to_string(found.all.colors) + " colours; largest of greys " +
          rounded(found.greys.largest, 3) + "\n";
  if (!options.curves) text += "  " + fine_text(found) + "\n";
  return text;
}

Json error_json(const BakeError& error) {
  return {{"largest", number_json(error.largest)},
          {"mean", number_json(error.mean)},
          {"worst", {error.worst.r, error.worst.g, error.worst.b}},
          {"colors", error.colors}};
}

Json report_json(const Options& options, const LutFormat& format, const Baked& baked,
                 const Lut& stored, const Findings& found, const std::vector<StepReport>& steps) {
  Json json{{"output", options.output.path},
            {"format", format.name},
            {"table", lut_words(stored)},
            {"low", options.range.low},
            {"high", options.range.high},
            {"shaper", baked.shaper},
            {"interpolation", options.interpolation->name},
            {"ciede2000", error_json(found.all)},
            {"ciede2000_greys", error_json(found.greys)}};
  if (!options.curves) {
    json["size_for_0.1"] = found.fine_size ? Json(*found.fine_size) : Json(nullptr);
  }
  if (options.explain) json["steps"] = steps_json(steps);
  return json;
}

void check_error(const Options& options, const Findings& found) {
  if (!options.max_error || found.all.largest <= *options.max_error) return;
  throw Error(ErrorKind::kGate, options.output.path,
              "the largest CIEDE2000 is " + rounded(found.all.largest, 3) + ", beyond " +
                  shortest(*options.max_error),
              options.curves ? "bake a cube, or curves of more entries" : fine_text(found));
}

}  // namespace

void run_lut_bake(Arguments arguments) {
  Options options;
  CommandLine line(*lut_job("bake"), kExamples);
  declare(line, options);
  if (!line.parse(arguments)) return;
  const LutFormat& format = check_lut_output(options.output, {});
  check(options, format);
  const LutSource chain = make_lut_source(options.way, options.settings);
  Baked baked = bake(options, format, *chain.source);
  baked.lut.title = options.title;
  if (options.curves && !holds(format, baked.lut)) {
    baked.lut = sampled_lut(baked.lut, format, {.curves = *options.curves}, options.output.path);
  }
  const LutFile file = lut_file(baked.lut, format, options.output);
  const Findings found = measure(options, *chain.source, baked, file.stored);
  if (options.json) {
    print(json_line(report_json(options, format, baked, file.stored, found, chain.steps)));
  } else {
    const std::string text = (options.explain ? steps_text(chain.steps) : "") +
                             report_text(options, baked, file.stored, found);
    options.output.path == "-" ? note(text.substr(0, text.size() - 1)) : print(text);
  }
  check_error(options, found);
  write_lut_file(file, options.output);
}

}  // namespace tristim::tools
