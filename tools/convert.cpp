#include <unistd.h>

#include <filesystem>
#include <optional>

#include "tools/commands.h"
#include "tools/convert_gamut.h"
#include "tools/convert_list.h"
#include "tools/convert_picture.h"
#include "tools/convert_print.h"
#include "tools/convert_rows.h"
#include "tools/convert_spectrum.h"
#include "tools/diagram.h"
#include "tristim/color/conversion.h"
#include "tristim/color/interpolate.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kExamples =
    "  tristim convert --to lab '#ff8000' rebeccapurple\n"
    "  tristim convert --from rgb:ntsc1953 --to yiq:fcc1953 1 0.5 0 --explain\n"
    "  tristim convert --from lab@d50 --to rgb:display-p3/gamma2.2 60 40 -20\n"
    "  tristim convert --from rgb:0.63,0.34,0.31,0.595,0.155,0.07,0.3127,0.329 --to hsv 1 0.5 0\n"
    "  tristim convert --from linear:bt2020 --to rgb:srgb --gamut-map desaturate 0 1 0\n"
    "  tristim convert --to cmyk:normalised:gcr=0.5:limit=3 navy\n"
    "  tristim convert --mix hsv --arc longer --steps 5 --to rgb red lime\n"
    "  printf '0.2 0.3 0.4  # a row\\n1,1,1\\n' | tristim convert --from linear:bt2020 --to xyy\n"
    "  tristim convert --from planckian --to rgb 1900 2856 6500 10000\n"
    "  tristim convert --to wavelength@d65 tomato navy\n"
    "  tristim spectrum f11 | tristim convert --from spectrum --to cct\n"
    "  printf '400 .05\\n550 .3\\n700 .1\\n' | tristim convert --from spectrum --to lab "
    "--illuminant d65\n"
    "  tristim convert --to munsell-notation '#ff8000'\n"
    "  tristim convert --from munsell --to rgb '7.5YR 5/12'\n"
    "  tristim convert --from cns --to rgb 'light vivid purplish red'\n"
    "  tristim convert --to iscc-nbs tomato\n"
    "  tristim render spheres -o spheres.exr\n"
    "  tristim convert --to oklch spheres.exr -o oklch.exr\n"
    "  tristim convert --from linear:bt2020 --to rgb:bt2020/pq 0.01 0.02 0.005\n"
    "  tristim convert --to all tomato\n"
    "  tristim convert tomato teal gold --diagram colours.svg --gamuts bt2020\n"
    "  tristim convert --list\n";

struct Options {
  PrintOptions print{.from = {}, .to = {}};
  Adaptation adaptation = Adaptation::kBradford;
  std::optional<GamutMethod> gamut_map;
  std::vector<std::string> words;
  std::string input;
  std::string output;
  bool keep_undefined = false;
  std::string mix;
  HueArc arc = HueArc::kShorter;
  int steps = 5;
  std::optional<double> at;  // one colour at this point instead of `steps`
  SpectrumSettings spectrum;
  DiagramOptions diagram;
  bool list = false, force = false;
};

// The member of a list that an option names.
template <typename List>
const auto& chosen(const List& list, std::string_view option, std::string_view what,
                   const std::string& name) {
  const auto* member = find_by_name(list, name);
  if (member != nullptr) return *member;
  throw Error(ErrorKind::kMisuse, option, "unknown " + std::string(what) + " '" + name + "'",
              name_hint(list, name));
}

bool keeps_undefined(const std::string& text) {
  if (text == "0" || same_name(text, "nan")) return text != "0";
  throw Error(ErrorKind::kMisuse, "--undefined", "cannot be '" + text + "'", "give 0 or nan");
}

void declare(CommandLine& line, Options& options) {
  line.positional("VALUES...",
                  "colours: numbers, #rrggbb, CSS names; or one file of rows; without any: rows of "
                  "standard input, a colour each, comments from # on",
                  options.words, 0, 1 << 20);
  line.option(
      "--from", "MODEL",
      "default: rgb:srgb, of a picture the light of the file; spectrum reads files of spectra",
      options.print.from);
  line.option("--to", "MODEL", "such as lab, xyz@d50, linear:display-p3, or all; see --list",
              options.print.to);
  line.option("--input", "FILE", "rows of a file; - is standard input", options.input);
  line.option("--adapt", list_names(kAdaptations, "|"), "from white to white; default: bradford",
              [&](const std::string& v) {
                options.adaptation = chosen(kAdaptations, "--adapt", "adaptation", v).method;
              });
  line.option("--gamut-map", list_names(kGamutMethods, "|"),
              "colours outside the gamut of --to, a model of RGB; default: they stay outside",
              [&](const std::string& v) {
                options.gamut_map = chosen(kGamutMethods, "--gamut-map", "gamut map", v);
              });
  line.flag("--explain", "print the way between the models, and each colour on it, first",
            options.print.explain);
  line.flag("--json", "print the colours as JSON", options.print.json);
  line.flag("--list", "print models, primaries, whites and curves with ranges and sources",
            options.list);
  line.flag("-f,--force", "replace an existing file", options.force);
  declare_spectrum_options(line, options.spectrum);
  line.section("Pictures: each pixel is a colour of --from, as the file has it");
  line.option(
      "-o,--output", "OUT.exr",
      "the picture IN in the model --to, floats in R G B order, alpha carried over; codes of "
      "integer files count as 0..1",
      options.output);
  line.option("--undefined", "0|nan",
              "for components without a value, as hues of greys; default: 0",
              [&](const std::string& v) { options.keep_undefined = keeps_undefined(v); });
  line.section("Mixing");
  line.option("--mix", "MODEL", "mix each pair of colours in this model", options.mix);
  line.option("--arc", list_names(kHueArcs, "|"), "which way round hues go; default: shorter",
              [&](const std::string& v) { options.arc = chosen(kHueArcs, "--arc", "arc", v).arc; });
  line.option(
      "--steps", "N", "colours from one to the other, both included; default: 5",
      [&](const std::string& v) { options.steps = integer_option("--steps", v, 2, 1 << 16); });
  line.option("--at", "T", "only the colour there, from 0 (the first) to 1",
              [&](const std::string& v) { options.at = number_option("--at", v, 0, 1); });
  declare_diagram(line, options.diagram);
}

// A sole argument that is no colour but a file, or named like one, is one of rows.
bool is_row_file(const Options& options, const ModelReference& from) {
  if (options.words.size() != 1 || is_color_text(options.words[0], from)) return false;
  std::error_code ignored;
  const std::filesystem::path path(options.words[0]);
  const std::string extension = path.extension().string();
  return std::filesystem::exists(path, ignored) || same_name(extension, ".csv") ||
         same_name(extension, ".txt");
}

void refuse_terminal_input(const std::string& what, const std::string& instead) {
  if (isatty(STDIN_FILENO) != 1) return;
  throw Error(ErrorKind::kMisuse, "convert", what + " are given",
              "give " + instead + ", or pipe rows into standard input");
}

std::vector<ColorRow> read_rows(const Options& options, const ModelReference& from) {
  std::string input = options.input;
  if (!input.empty() && !options.words.empty()) {
    throw Error(ErrorKind::kMisuse, "--input", "there are colours in the arguments as well",
                "give one or the other");
  }
  if (is_row_file(options, from)) {
    input = options.words[0];
  } else if (!options.words.empty()) {
    return read_color_arguments(options.words, from);
  }
  if (input.empty()) refuse_terminal_input("no colours", "numbers or names");
  const bool standard_input = input.empty() || input == "-";
  return read_color_rows(read_text_file(standard_input ? "-" : input),
                         standard_input ? "standard input" : input, from);
}

// Colours of `mix` between each pair.
std::vector<ColorRow> mixed(const std::vector<ColorRow>& rows, const ColorConversion& to_mix,
                            const Options& options) {
  if (rows.size() < 2 || rows.size() % 2 != 0) {
    throw Error(ErrorKind::kContent, "--mix", std::to_string(rows.size()) + " colours are no pairs",
                "give two colours for each mixture");
  }
  std::vector<ColorRow> mixtures;
  for (std::size_t i = 0; i < rows.size(); i += 2) {
    const Components first = to_mix(rows[i].values);
    const Components last = to_mix(rows[i + 1].values);
    for (int step = 0; step < (options.at ? 1 : options.steps); ++step) {
      const double t = options.at.value_or(static_cast<double>(step) / (options.steps - 1));
      mixtures.push_back({.values = interpolate(to_mix.to(), first, last, t, options.arc),
                          .odd = rows[i].odd || rows[i + 1].odd});
    }
  }
  return mixtures;
}

PictureJob picture_job(const Options& options) {
  if (options.words.size() != 1 || !options.mix.empty() || !options.input.empty()) {
    throw Error(ErrorKind::kMisuse, "--output", "takes one picture to convert",
                "give IN.exr -o OUT.exr, or leave out -o for colours");
  }
  if (options.gamut_map) {
    throw Error(ErrorKind::kMisuse, "--gamut-map", "is for colours", "use process for pictures");
  }
  if (options.print.json) {
    throw Error(ErrorKind::kMisuse, "--json", "is for colours", "leave it out, or leave out -o");
  }
  return {.input = options.words[0],
          .output = options.output,
          .from = options.print.from,
          .to = options.print.to,
          .adaptation = options.adaptation,
          .keep_undefined = options.keep_undefined,
          .replace = options.force,
          .explain = options.print.explain};
}

// Colours and the model that they are in.
struct Source {
  std::vector<ColorRow> rows;
  ModelReference model;
};

std::vector<std::string> spectrum_files(const Options& options) {
  std::vector<std::string> files = options.words;
  if (!options.input.empty()) files.push_back(options.input);
  if (files.empty()) {
    refuse_terminal_input("no spectra", "files of spectra");
    files.emplace_back("-");
  }
  return files;
}

// `options` gets to know what the colours were made of.
Source read_source(Options& options) {
  if (same_name(options.print.from, "spectrum")) {
    SpectrumColors colors = read_spectrum_colors(spectrum_files(options), options.spectrum);
    options.print.origin = std::move(colors.explanation);
    options.print.origin_facts = std::move(colors.facts);
    return {std::move(colors.rows), colors.model};
  }
  if (options.spectrum.given) {
    throw Error(ErrorKind::kMisuse, "--from", "'" + options.print.from + "' is no spectrum",
                "--illuminant, --observer, --rule and --white-luminance go with --from spectrum");
  }
  const ModelReference model = parse_model(options.print.from, "--from");
  return {read_rows(options, model), model};
}

void draw(const Source& source, const Options& options) {
  ChromaticityDiagram diagram =
      diagram_of(source.rows, color_labels(options.words, source.rows.size()), source.model);
  if (!same_name(options.print.from, "spectrum")) {
    add_gamut(diagram, options.print.from, "--from");
  }
  if (!options.print.to.empty() && !same_name(options.print.to, "all")) {
    add_gamut(diagram, options.print.to, "--to");
  }
  write_diagram(diagram, options.diagram, options.force);
}

void convert(Options& options) {
  Source source = read_source(options);
  if (!options.mix.empty()) {
    const ModelReference mix = parse_model(options.mix, "--mix");
    if (mix.model->to_text != nullptr) {
      throw Error(ErrorKind::kMisuse, "--mix", "the colours of '" + options.mix + "' are words",
                  "give a model of numbers such as oklch");
    }
    const ColorConversion to_mix(source.model, mix, options.adaptation);
    source = {mixed(source.rows, to_mix, options), to_mix.to_reference()};
  }
  if (!options.diagram.output.empty()) draw(source, options);
  if (options.print.to.empty() || options.diagram.output == "-") return;
  if (same_name(options.print.to, "all")) {
    if (options.gamut_map) {
      throw Error(ErrorKind::kMisuse, "--gamut-map", "'all' models have no gamut",
                  "give colours and --to a model of RGB");
    }
    return print_all_models(source.rows, source.model, options.adaptation, options.print);
  }
  const ColorConversion conversion(source.model, parse_model(options.print.to, "--to"),
                                   options.adaptation);
  std::optional<GamutMapping> gamut;
  if (options.gamut_map) {
    gamut.emplace(source.model, conversion, options.adaptation, *options.gamut_map);
  }
  print_colors(source.rows, conversion, gamut ? &*gamut : nullptr, options.print);
}

}  // namespace

void run_convert(Arguments arguments) {
  Options options;
  CommandLine line(*find_by_name(kCommands, "convert"), kExamples);
  declare(line, options);
  if (!line.parse(arguments)) return;
  if (options.list) return list_color_models(options.print.json);
  if (options.print.to.empty() && options.diagram.output.empty()) {
    throw Error(ErrorKind::kMisuse, "--to", "is missing",
                "give a model such as lab or hsv; convert --list shows all");
  }
  if (!options.output.empty()) return convert_picture(picture_job(options));
  if (options.print.from.empty()) options.print.from = "rgb:srgb";
  convert(options);
}

}  // namespace tristim::tools
