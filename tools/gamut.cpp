#include "tristim/color/gamut.h"
#include "tools/commands.h"
#include "tools/diagram.h"
#include "tools/gamut_report.h"
#include "tools/report.h"
#include "tristim/color/conversion.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kExamples =
    "  tristim gamut srgb display-p3 bt2020\n"
    "  tristim gamut srgb 0.65,0.32,0.28,0.62,0.15,0.05,0.3127,0.329 --json\n"
    "  tristim gamut srgb ntsc1953 --colors tomato,teal,#00ff40\n"
    "  tristim gamut srgb --from xyy --colors 0.2,0.7,0.5\n"
    "  tristim gamut srgb bt2020 --colors orange,teal --diagram gamuts.svg\n"
    "  tristim gamut bt709 --limits 20,50,80 --ellipses --diagram-plane 1976 --diagram uv.svg\n";

struct Options {
  std::vector<std::string> sets;
  std::string from = "rgb:srgb", colors;
  std::string illuminant = "d65";
  Adaptation adaptation = Adaptation::kBradford;
  DiagramOptions diagram;
  bool json = false, force = false;
};

const Illuminant& illuminant_option(const std::string& name) {
  const Illuminant* illuminant = find_by_name(illuminants(), name);
  if (illuminant != nullptr) return *illuminant;
  throw Error(ErrorKind::kMisuse, "--illuminant", "unknown illuminant '" + name + "'",
              name_hint(illuminants(), name));
}

Adaptation adaptation_option(const std::string& name) {
  const AdaptationMethod* method = find_by_name(kAdaptations, name);
  if (method != nullptr) return method->method;
  throw Error(ErrorKind::kMisuse, "--adapt", "unknown adaptation '" + name + "'",
              name_hint(kAdaptations, name));
}

void declare(CommandLine& line, Options& options) {
  line.positional("SET...",
                  "primaries: names (convert --list shows all), or the chromaticities of red, "
                  "green, blue and white: xr,yr,xg,yg,xb,yb,xw,yw",
                  options.sets, 1, 1 << 10);
  line.option("--colors", "COLOUR,...", "say which are outside of each set, and by how much",
              options.colors);
  line.option("--from", "MODEL", "of the colours; default: rgb:srgb", options.from);
  line.option("--adapt", list_names(kAdaptations, "|"),
              "from the colours' white to each set's; default: bradford",
              [&](const std::string& v) { options.adaptation = adaptation_option(v); });
  line.option("--illuminant", "NAME", "of the MacAdam limits of the colours; default: d65",
              options.illuminant);
  line.flag("--json", "print as JSON", options.json);
  line.flag("--force", "replace an existing diagram", options.force);
  declare_diagram(line, options.diagram);
}

std::vector<DiagramGamut> sets_of(const Options& options) {
  std::vector<DiagramGamut> sets;
  for (const std::string& text : options.sets) {
    sets.push_back(named_gamut(text, "SET"));
    xyz_from_rgb(sets.back().primaries);  // throws where they lie on a line
  }
  return sets;
}

void add_colors(GamutQuestion& question, const std::vector<ColorRow>& rows,
                const std::vector<std::string>& labels, const ModelReference& model) {
  const ColorConversion to_xyz(model, parse_model("xyz", "colour"), Adaptation::kNone);
  question.white = to_xyz.from_white();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Components xyz = to_xyz(rows[i].values);
    question.colors.push_back({labels[i], {xyz[0], xyz[1], xyz[2]}});
  }
}

}  // namespace

void run_gamut(Arguments arguments) {
  Options options;
  CommandLine line(*find_by_name(kCommands, "gamut"), kExamples);
  declare(line, options);
  if (!line.parse(arguments)) return;
  GamutQuestion question{.sets = sets_of(options), .adaptation = options.adaptation};
  question.illuminant = &illuminant_option(options.illuminant);
  const ModelReference model = parse_model(options.from, "--from");
  ChromaticityDiagram diagram;
  if (!options.colors.empty()) {
    const std::vector<ColorRow> rows = read_color_arguments({options.colors}, model);
    std::vector<std::string> words;
    for (const std::string_view word : split(options.colors, ',')) words.emplace_back(word);
    const std::vector<std::string> labels = color_labels(words, rows.size());
    add_colors(question, rows, labels, model);
    diagram = diagram_of(rows, labels, model);
  }
  diagram.gamuts = question.sets;
  if (!options.diagram.output.empty()) write_diagram(diagram, options.diagram, options.force);
  if (options.diagram.output == "-") return;  // the drawing alone
  print(options.json ? json_line(gamut_json(question)) : gamut_text(question));
}

}  // namespace tristim::tools
