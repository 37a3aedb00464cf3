#include <unistd.h>

#include "tools/commands.h"
#include "tools/compare_picture.h"
#include "tools/convert_rows.h"
#include "tools/report.h"
#include "tristim/color/conversion.h"
#include "tristim/color/difference.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;
using Values = std::array<double, 3>;

constexpr std::string_view kExamples =
    "  tristim compare '#ff0000' '#fe0000'\n"
    "  tristim compare --difference cmc:1.5:1 navy midnightblue\n"
    "  tristim compare --from lab --difference ciede2000 50 2.5 0 61 -5 29\n"
    "  printf '50 0 0\\n51 0 0\\n' | tristim compare --from lab --json\n"
    "  tristim compare --list\n"
    "  tristim render spheres -o spheres.exr && tristim process spheres.exr -d srgb -o screen.png\n"
    "  tristim process spheres.exr -d srgb --palette best:64 -o few.png\n"
    "  tristim compare screen.png few.png\n"
    "  tristim compare screen.png few.png --spd 60 --gate scielab_mean@60=3,hvs_snr@60=25\n"
    "  tristim compare screen.png few.png --rapsd --plot texture.svg --json\n";

struct Options {
  std::string from, difference;  // "": rgb:srgb, and all
  std::vector<std::string> words;
  bool json = false, list = false;
};

void list_formulas(bool json) {
  Json all = Json::array();
  std::string text;
  for (const DifferenceFormula& formula : kDifferenceFormulas) {
    const std::string_view reference =
        formula.symmetric ? "symmetric" : "the first is the reference";
    all.push_back({{"difference", formula.name},
                   {"of", formula.model},
                   {"symmetric", formula.symmetric},
                   {"factors", formula.factor_count},
                   {"formula", formula.formula},
                   {"source", formula.source}});
    std::string name(formula.name);
    name.resize(16, ' ');
    text += name + std::string(formula.formula) + "; " + std::string(reference) + " " +
            std::string(formula.source) + "\n";
  }
  print(json ? json_line(all) : text);
}

std::vector<ColorRow> read_colors(const Options& options, const ModelReference& from) {
  if (!options.words.empty()) return read_color_arguments(options.words, from);
  if (isatty(STDIN_FILENO) == 1) {
    throw Error(ErrorKind::kMisuse, "compare", "no colours are given",
                "give two, or pipe rows into standard input");
  }
  return read_color_rows(read_text_file("-"), "standard input", from);
}

// A difference of the list, with the way to the model that it is measured in.
struct Measure {
  DifferenceReference difference;
  ColorConversion conversion;

  double operator()(const ColorRow& reference, const ColorRow& sample) const {
    const Components a = conversion(reference.values);
    const Components b = conversion(sample.values);
    return difference(Values{a[0], a[1], a[2]}, Values{b[0], b[1], b[2]});
  }
};

std::vector<Measure> measures_of(const Options& options, const ModelReference& from) {
  std::vector<DifferenceReference> wanted;
  if (!options.difference.empty()) {
    wanted.push_back(parse_difference(options.difference, "--difference"));
  } else {
    for (const DifferenceFormula& f : kDifferenceFormulas) wanted.push_back({&f, f.factors});
  }
  std::vector<Measure> measures;
  for (const DifferenceReference& difference : wanted) {
    const ModelReference model = parse_model(difference.formula->model, "--difference");
    measures.push_back({difference, ColorConversion(from, model, Adaptation::kBradford)});
  }
  return measures;
}

std::string line_of(const Measure& measure, double difference, bool only_one) {
  std::string name;
  if (!only_one) {
    name = measure.difference.formula->name;
    name.resize(16, ' ');
  }
  return name + shortest(difference) + "\n";
}

void compare(const Options& options) {
  const std::string model = options.from.empty() ? "rgb:srgb" : options.from;
  const ModelReference from = parse_model(model, "--from");
  const std::vector<Measure> measures = measures_of(options, from);
  const std::vector<ColorRow> colors = read_colors(options, from);
  if (colors.empty() || colors.size() % 2 != 0) {
    throw Error(ErrorKind::kContent, "compare",
                std::to_string(colors.size()) + " colours are no pairs",
                "give two colours for each difference");
  }
  Json pairs = Json::array();
  std::string text;
  for (std::size_t i = 0; i < colors.size(); i += 2) {
    Json pair;
    if (i > 0 && measures.size() > 1) text += "\n";
    for (const Measure& measure : measures) {
      const double difference = measure(colors[i], colors[i + 1]);
      pair[std::string(measure.difference.formula->name)] = number_json(difference);
      text += line_of(measure, difference, measures.size() == 1);
    }
    pairs.push_back(pair);
  }
  print(options.json ? json_line(Json{{"from", model}, {"pairs", pairs}}) : text);
}

void refuse_picture_options(const PictureComparison& pictures) {
  if (pictures.given.empty() && !pictures.figures.texture) return;
  throw Error(ErrorKind::kMisuse, pictures.given.empty() ? "--rapsd" : pictures.given.front(),
              "is for pictures", "give the files of a reference and a result");
}

void refuse_color_options(const Options& options) {
  if (options.from.empty() && options.difference.empty()) return;
  throw Error(ErrorKind::kMisuse, options.from.empty() ? "--difference" : "--from",
              "is for colours, not for pictures", "leave it out");
}

}  // namespace

void run_compare(Arguments arguments) {
  Options options;
  PictureComparison pictures;
  CommandLine line(*find_by_name(kCommands, "compare"), kExamples);
  line.positional(
      "PICTURES|COLORS...",
      "two pictures, a reference and what became of it; or pairs of colours, a reference "
      "and a sample: numbers, #rrggbb, CSS names; without any: rows of standard input, a "
      "colour each",
      options.words, 0, 1 << 20);
  line.option("--from", "MODEL", "of the numbers; default: rgb:srgb", options.from);
  line.option("--difference", "NAME",
              list_names(kDifferenceFormulas, "|") +
                  ", with factors as in ciede2000:L:C:H and cmc:L:C; default: all",
              options.difference);
  line.flag("--json", "print the differences as JSON", options.json);
  line.flag("--list", "print the differences with their formulas and sources", options.list);
  declare_picture_options(line, pictures);
  if (!line.parse(arguments)) return;
  if (options.list) return list_formulas(options.json);
  if (!are_pictures(options.words)) {
    refuse_picture_options(pictures);
    return compare(options);
  }
  refuse_color_options(options);
  pictures.pair.reference = options.words[0];
  pictures.pair.result = options.words[1];
  pictures.json = options.json;
  compare_pictures(pictures);
}

}  // namespace tristim::tools
