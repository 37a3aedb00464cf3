#include "tools/compare_picture.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "tools/compare_plot.h"
#include "tools/gates.h"
#include "tools/outputs.h"
#include "tools/report.h"
#include "tristim/color/lab.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDigits = 6;  // of figures: a processor's last bits do not show

Json figure_json(double value) {
  if (!std::isfinite(value)) return number_json(value);
  return parse_number(rounded(value, kDigits)).value_or(value);
}

Json patches_json(const std::vector<TonePoint>& patches) {
  Json list = Json::array();
  for (const TonePoint& p : patches) {
    list.push_back(
        {figure_json(p.reference), figure_json(p.result), figure_json(lstar_difference(p))});
  }
  return list;
}

Json spectrum_json(const RadialSpectrum& spectrum) {
  Json list = Json::array();
  for (const RadialSpectrum::Ring& ring : spectrum.rings) {
    list.push_back(
        {figure_json(ring.frequency), figure_json(ring.power), figure_json(ring.anisotropy)});
  }
  return list;
}

Json json_of(const JudgedPair& pair, const Figures& figures) {
  Json json{{"unique", pair.colors}};
  for (const Figure& f : figures.list) json[f.name] = figure_json(f.value);
  if (!figures.patches.empty()) json["patches"] = patches_json(figures.patches);
  if (figures.texture) json["spectrum"] = spectrum_json(figures.texture->spectrum);
  return json;
}

std::string line_of(std::string name, const std::string& value) {
  name.resize(std::max<std::size_t>(name.size() + 1, 24), ' ');
  return name + value + "\n";
}

std::string patches_text(const std::vector<TonePoint>& patches) {
  std::string text = "patch   reference  result     dL*\n";
  for (std::size_t i = 0; i < patches.size(); ++i) {
    std::string line = std::to_string(i);
    line.resize(8, ' ');
    line += rounded(patches[i].reference, 5);
    line.resize(19, ' ');
    line += rounded(patches[i].result, 5);
    line.resize(30, ' ');
    text += line + rounded(lstar_difference(patches[i]), 3) + "\n";
  }
  return text;
}

std::string text_of(const JudgedPair& pair, const Figures& figures) {
  std::string text = line_of("unique", std::to_string(pair.colors));
  for (const Figure& f : figures.list) text += line_of(f.name, rounded(f.value, kDigits));
  if (!figures.patches.empty()) text += patches_text(figures.patches);
  return text;
}

// ".png", ".npy": letters behind the last point, as no number has them.
bool has_extension(const std::string& word) {
  const std::string extension = std::filesystem::path(word).extension().string();
  return extension.size() > 1 && std::isalpha(static_cast<unsigned char>(extension[1])) != 0;
}

bool is_file(const std::string& word) {
  std::error_code ignored;
  return std::filesystem::exists(word, ignored);
}

std::vector<double> parse_viewers(const std::string& text) {
  std::vector<double> viewers;
  for (const std::string_view part : split(text, ',')) {
    viewers.push_back(number_option("--spd", part, 1, 1000));
  }
  return viewers;
}

std::vector<Gate> gates_of(const PictureComparison& comparison) {
  std::vector<Gate> gates;
  if (!comparison.gates.empty()) gates = parse_gates(comparison.gates);
  if (!comparison.max_error.empty()) {
    const double bound = number_option("--max-error", comparison.max_error, 0, 1000);
    gates.push_back({"de00_mean", bound});
  }
  return gates;
}

void check_plot(const PictureComparison& comparison) {
  if (comparison.plot.empty()) return;
  refuse_other_drawings(comparison.plot);
  refuse_inputs_as_outputs({comparison.pair.reference, comparison.pair.result}, {comparison.plot});
  refuse_taken_outputs({comparison.plot}, comparison.force);
}

void write_plot(const PictureComparison& comparison, const Figures& figures) {
  const std::string name = std::filesystem::path(comparison.pair.result).filename().string();
  OutputFile file(comparison.plot, comparison.force);
  file.write(compare_plot(figures, name));
  file.commit();
}

}  // namespace

void declare_picture_options(CommandLine& line, PictureComparison& comparison) {
  const auto option = [&](const std::string& name, const std::string& argument,
                          const std::string& help, auto set) {
    line.option(name, argument, help, [&comparison, name, set](const std::string& value) {
      comparison.given.push_back(name);
      set(comparison, value);
    });
  };
  using C = PictureComparison;
  using Text = const std::string&;
  line.section("For pictures");
  option("--ref-transfer", "CURVE",
         "of the reference's codes: srgb, linear, g2.2, ...; default: as the file says",
         [](C& c, Text v) { c.pair.reference_transfer = v; });
  option("--out-transfer", "CURVE", "of the result's; .npy: srgb unless named",
         [](C& c, Text v) { c.pair.result_transfer = v; });
  option("--spd", "N,...", "samples per degree of the viewers; default: 40,20",
         [](C& c, Text v) { c.figures.samples_per_degree = parse_viewers(v); });
  option("--border", "N", "pixels at each edge that do not count; default: 0",
         [](C& c, Text v) { c.pair.border = integer_option("--border", v, 0, 1 << 20); });
  option("--patches", "N", "the pictures are N columns of one tone: the tone of each",
         [](C& c, Text v) { c.figures.patches = integer_option("--patches", v, 1, 4096); });
  line.flag("--rapsd", "the result is one tone: judge its texture", comparison.figures.texture);
  option("--plot", "OUT.svg", "draw the tone curve, with --rapsd the spectrum",
         [](C& c, Text v) { c.plot = v; });
  option("--max-error", "E", "exit with 4 where de00_mean is beyond E",
         [](C& c, Text v) { c.max_error = v; });
  option("--gate", "NAME=BOUND,...",
         "exit with 4 where a figure is beyond its bound (psnr, hvs_snr: below)",
         [](C& c, Text v) { c.gates = v; });
  line.flag("-f,--force", "replace an existing drawing", comparison.force);
}

bool are_pictures(const std::vector<std::string>& words) {
  if (words.size() != 2) return false;
  return (is_file(words[0]) && is_file(words[1])) || has_extension(words[0]) ||
         has_extension(words[1]);
}

void compare_pictures(const PictureComparison& comparison) {
  const std::vector<Gate> gates = gates_of(comparison);
  check_plot(comparison);
  const JudgedPair pair = read_pair(comparison.pair);
  const PicturePair pictures = pair.pictures();
  if (comparison.figures.patches > pictures.reference.width) {
    throw Error(ErrorKind::kMisuse, "--patches",
                std::to_string(comparison.figures.patches) + " do not fit into " +
                    std::to_string(pictures.reference.width) + " columns",
                "give the number of columns of one tone");
  }
  const Figures figures = all_figures(pictures, comparison.figures);
  if (!comparison.plot.empty()) write_plot(comparison, figures);
  print(comparison.json ? json_line(json_of(pair, figures)) : text_of(pair, figures));
  check_gates(gates, figures.list, comparison.pair.result);
}

}  // namespace tristim::tools
