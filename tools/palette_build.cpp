#include <algorithm>
#include <fstream>

#include "tools/outputs.h"
#include "tools/palette_actions.h"
#include "tools/palette_source.h"
#include "tools/process_palette.h"
#include "tools/report.h"
#include "tools/setting_options.h"
#include "tristim/color/primaries.h"
#include "tristim/color/transfer.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/device/display_file.h"
#include "tristim/palette/histogram_text.h"
#include "tristim/palette/io/file.h"
#include "tristim/palette/stable_order.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kExamples =
    "  tristim render spheres -o a.exr && tristim render spheres --size 640x360 -o b.exr\n"
    "  tristim palette build a.exr b.exr -n 16 -o shared.gpl\n"
    "  tristim palette build a.exr -n 8 --method median-cut --fixed black,white\n"
    "  tristim palette build a.exr --histogram-out a.hist\n"
    "  tristim palette build b.exr --histogram-out b.hist\n"
    "  tristim palette build -n 16 --merge-histograms a.hist b.hist -o merged.gpl\n"
    "  tristim palette build b.exr -n 16 --previous shared.gpl -o next.gpl\n"
    "  tristim palette build a.exr -n 16 --weights contrast --alpha entries --mask a.exr\n";

// What of the pipeline lies in front of a palette.
constexpr std::string_view kPictureSettings[] = {"layer",  "size",       "fit",      "filter",
                                                 "rotate", "background", "exposure", "tone-map",
                                                 "adapt",  "gamut-map"};

constexpr std::string_view kHistogramMark = "tristim histogram";

struct Options {
  std::vector<std::string> inputs, histograms;
  std::string method = std::string(kPaletteMethods[0].name);
  std::string output, format, histogram_out, device = "srgb", fixed, previous, order, metric;
  std::string transparent, alpha, weights;
  Counting counting;
  int colors = 0;
  int threads = 0;
  Settings settings;
  bool json = false, force = false;
};

bool is_histogram(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(kHistogramMark.size(), '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  return file && head == kHistogramMark;
}

Histogram count_inputs(const Options& options, const Display& display) {
  Histogram all;
  for (const std::string& path : options.histograms) {
    merge_histogram_text(read_text_file(path), path, all);
  }
  for (const std::string& input : options.inputs) {
    if (input != "-" && is_histogram(input)) {
      merge_histogram_text(read_text_file(input), input, all);
    } else {
      all.merge(count_colors(options.settings, display, input, options.threads, options.counting));
    }
  }
  return all;
}

// A member of a list by its name; the first where there is no name.
template <typename List>
const auto& choice(std::string_view option, const List& list, const std::string& name) {
  const auto* item = name.empty() ? &*std::begin(list) : find_by_name(list, name);
  if (item != nullptr) return *item;
  throw Error(ErrorKind::kMisuse, std::string(option), "unknown name '" + name + "'",
              name_hint(list, name));
}

Color8 color8(const EncodedRgb& color) {
  const auto [r, g, b] = color_codes8(color);
  return {r, g, b};
}

std::vector<Color8> fixed_colors(const Options& options) {
  if (options.fixed.empty()) return {};
  std::vector<std::string> words;
  for (const std::string_view word : split(options.fixed, ',')) words.emplace_back(word);
  std::vector<Color8> colors;
  for (const PaletteColor& entry : load_palette(words, "--fixed").palette.colors) {
    colors.push_back(color8(entry.color));
  }
  return colors;
}

PaletteOptions palette_options(const Options& options) {
  PaletteOptions wanted;
  wanted.colors = options.colors > 0 ? options.colors : wanted.colors;
  wanted.fixed = fixed_colors(options);
  wanted.order = choice("--order", kPaletteOrders, options.order).order;
  if (!options.metric.empty()) wanted.metric = &choice("--metric", kMetrics, options.metric);
  if (wanted.fixed.size() > static_cast<std::size_t>(wanted.colors)) {
    throw Error(ErrorKind::kMisuse, "--fixed",
                std::to_string(wanted.fixed.size()) + " colours are more than the " +
                    std::to_string(wanted.colors) + " of the palette",
                "fix fewer, or give a larger -n");
  }
  if (options.transparent.empty()) return wanted;
  const int last = wanted.colors - 1;
  wanted.transparent = same_name(options.transparent, "last")
                           ? last
                           : integer_option("--transparent", options.transparent, 0, last);
  return wanted;
}

// Colours that were counted in a device's primaries, as sRGB.
Palette srgb_palette(const std::vector<Color8>& colors, const Display& display) {
  const Eigen::Matrix3d matrix =
      rgb_from_rgb(Primaries{}, display.primaries, Adaptation::kBradford);
  const bool srgb = display.primaries == Primaries{};
  Palette palette;
  for (const Color8 c : colors) {
    EncodedRgb color{c.r / 255.0, c.g / 255.0, c.b / 255.0};
    if (!srgb) {
      const Eigen::Vector3d light =
          matrix *
          Eigen::Vector3d(srgb_decode(color.r), srgb_decode(color.g), srgb_decode(color.b));
      color = {srgb_encode(light.x()), srgb_encode(light.y()), srgb_encode(light.z())};
    }
    palette.colors.push_back({color, {}, c.a / 255.0});
  }
  return palette;
}

// The colours in the places that they had in the palette of the picture before.
void keep_places(Palette& palette, const Options& options, const PaletteOptions& wanted) {
  if (options.previous.empty()) return;
  const PaletteSource previous = load_palette({options.previous}, "--previous");
  std::vector<PaletteColor> all = std::move(palette.colors);
  std::optional<PaletteColor> transparent;
  if (wanted.transparent) {
    transparent = all[static_cast<std::size_t>(*wanted.transparent)];
    all.erase(all.begin() + *wanted.transparent);
  }
  Palette before = previous.palette;
  if (wanted.transparent && static_cast<std::size_t>(*wanted.transparent) < before.colors.size()) {
    before.colors.erase(before.colors.begin() + *wanted.transparent);
  }
  const std::vector<std::size_t> order =
      stable_order(palette_light(before), palette_light({"", all}), wanted.fixed.size());
  palette.colors.clear();
  for (const std::size_t i : order) palette.colors.push_back(all[i]);
  if (transparent) {
    palette.colors.insert(palette.colors.begin() + *wanted.transparent, *transparent);
  }
}

void write_file(const std::string& path, const std::string& bytes, bool replace) {
  OutputFile file(path, replace);
  file.write(bytes);
  file.commit();
}

void declare(CommandLine& line, Options& options, std::vector<GivenSetting>& given) {
  line.positional("IN...", "pictures, or histograms of --histogram-out; - is standard input",
                  options.inputs, 0, 1 << 20);
  line.option("-n,--colors", "N", "colours at most, 1 to 65536; default: 256",
              [&](const std::string& v) {
                options.colors = integer_option("--colors", v, 1, kMostColors);
              });
  line.option("--method", list_names(kPaletteMethods, "|"), "default: best", options.method);
  line.option("-o,--output", "OUT",
              "palette, in the format of its extension (see tristim palette convert); default: the "
              "colours as text on standard output",
              options.output);
  line.option("--format", "F", "of the palette, whatever its name", options.format);
  line.option("--histogram-out", "H", "the counted colours, to be merged with those of others",
              options.histogram_out);
  line.option("--merge-histograms", "H...", "counted colours to add to those of the pictures",
              [&](const std::string& v) { options.histograms.push_back(v); });
  line.option("--previous", "P", "palette whose colours keep their places", options.previous);
  line.option("--fixed", "COLORS", "first in the palette: black,white, or a palette file",
              options.fixed);
  line.option("--transparent", "N|last", "position of an entry that no colour takes",
              options.transparent);
  line.option("--order", list_names(kPaletteOrders, "|"), "of the colours; default: found",
              options.order);
  line.option("--metric", list_names(kMetrics, "|"), "in which methods measure; default: balanced",
              options.metric);
  line.option(
      "--alpha", list_names(kAlphaModes, "|"),
      "translucent pixels: over the background, half covered ones alone, or as entries with "
      "alpha; default: premultiplied",
      options.alpha);
  line.option("--weights", list_names(kPaletteWeights, "|"),
              "what makes a colour count: its pixels, or those in flat areas more; default: count",
              options.weights);
  line.option("--mask", "PICTURE", "how much each pixel counts: black not at all, white most",
              options.counting.mask);
  line.option("-d,--device", "D", "for whose response colours are counted; default: srgb",
              options.device);
  line.option(
      "--threads", "N", "default: one for each processor; the result is the same",
      [&](const std::string& v) { options.threads = integer_option("--threads", v, 0, 256); });
  line.flag("--json", "print the facts as JSON", options.json);
  line.flag("-f,--force", "replace existing files", options.force);
  line.section("Settings of the pictures");
  declare_settings(line, given, kPictureSettings);
}

void check(const Options& options) {
  if (options.inputs.empty() && options.histograms.empty()) {
    throw Error(ErrorKind::kMisuse, "palette build", "no pictures are given",
                "give pictures, or histograms");
  }
  if (options.json && options.output == "-") {
    throw Error(ErrorKind::kMisuse, "--json", "standard output is taken by the palette",
                "write the palette to a file");
  }
  std::vector<std::string> outputs;
  for (const std::string* path : {&options.output, &options.histogram_out}) {
    if (!path->empty()) outputs.push_back(*path);
  }
  refuse_missing_inputs(options.inputs);
  if (!options.counting.mask.empty()) refuse_missing_inputs({options.counting.mask});
  refuse_inputs_as_outputs(options.inputs, outputs);
  refuse_taken_outputs(outputs, options.force);
}

// Two hexadecimal digits; none where a colour is opaque.
std::string alpha_digits(double alpha) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  const auto code = static_cast<unsigned>(alpha * 255 + 0.5);
  if (code >= 255) return "";
  return {kDigits[code >> 4], kDigits[code & 15]};
}

void print_facts(const Options& options, const Histogram& counted, const Palette& palette) {
  nlohmann::ordered_json json{
      {"output", options.output}, {"method", options.method}, {"distinct", counted.size()}};
  json["colors"] = nlohmann::ordered_json::array();
  for (const PaletteColor& entry : palette.colors) {
    json["colors"].push_back(hex_text(entry.color) + alpha_digits(entry.alpha));
  }
  print(json_line(json));
}

}  // namespace

void run_palette_build(Arguments arguments) {
  Options options;
  std::vector<GivenSetting> given;
  CommandLine line(palette_action("build"), kExamples);
  declare(line, options, given);
  if (!line.parse(arguments)) return;
  apply_settings(options.settings, given);
  check(options);
  const PaletteMethod& method = choice("--method", kPaletteMethods, options.method);
  const PaletteOptions wanted = palette_options(options);
  options.counting.alpha = choice("--alpha", kAlphaModes, options.alpha).mode;
  options.settings.palette_weights = choice("--weights", kPaletteWeights, options.weights).weights;
  const bool text = options.output.empty();
  const PaletteFormat& format =
      palette_format_of(options.output, text && options.format.empty() ? "hex" : options.format);
  const Display display = load_display(options.device);

  const Histogram counted = count_inputs(options, display);
  Palette palette = srgb_palette(build_palette(counted, method, wanted), display);
  keep_places(palette, options, wanted);
  const std::string bytes = palette_bytes(palette, format, text ? "palette build" : options.output);
  if (!options.histogram_out.empty()) {
    write_file(options.histogram_out, histogram_text(counted), options.force);
  }
  if (!text) write_file(options.output, bytes, options.force);
  const bool only_histogram = text && !options.histogram_out.empty();
  if (options.json) return print_facts(options, counted, palette);
  if (text && !only_histogram) print(bytes);
}

}  // namespace tristim::tools
