#include "tools/diagram.h"

#include "tools/outputs.h"
#include "tristim/color/conversion.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

const ChromaticityPlane& plane_option(const std::string& name) {
  const ChromaticityPlane* plane = find_by_name(kChromaticityPlanes, name);
  if (plane != nullptr) return *plane;
  throw Error(ErrorKind::kMisuse, "--diagram-plane", "unknown diagram '" + name + "'",
              "use one of: " + list_names(kChromaticityPlanes));
}

std::vector<double> limits_option(std::string_view list) {
  std::vector<double> limits;
  for (const std::string_view part : split(list, ',')) {
    limits.push_back(number_option("--limits", part, 0, 100) / 100);
  }
  return limits;
}

// The set that one of the parts of a model's name is, or nullptr: "hsv:ntsc1953", "rgb:bt2020/pq".
const NamedPrimaries* set_in(std::string_view model) {
  for (std::string_view part : split(model, ':')) {
    part = part.substr(0, part.find_first_of("/@"));
    const NamedPrimaries* set = find_by_name(primaries_list(), part);
    if (set != nullptr) return set;
  }
  return nullptr;
}

// The corners, of primaries without a name.
std::string corners_text(const Primaries& primaries) {
  std::string text;
  for (const Chromaticity c : {primaries.red, primaries.green, primaries.blue}) {
    text += (text.empty() ? "" : ", ") + rounded(c.x, 4) + " " + rounded(c.y, 4);
  }
  return text;
}

// A white with its name where it has one, else with its numbers.
DiagramColor named_white(Chromaticity white) {
  for (const WhitePoint& point : kWhitePoints) {
    if (point.chromaticity != white) continue;
    std::string name(point.name);
    name[0] = static_cast<char>(name[0] - 'a' + 'A');
    return {name, white};
  }
  return {rounded(white.x, 4) + " " + rounded(white.y, 4), white};
}

void add_once(std::vector<DiagramGamut>& gamuts, const DiagramGamut& gamut) {
  for (const DiagramGamut& known : gamuts) {
    if (known.name == gamut.name && known.primaries == gamut.primaries) return;
  }
  gamuts.push_back(gamut);
}

}  // namespace

void declare_diagram(CommandLine& line, DiagramOptions& options) {
  line.section("Chromaticity diagram");
  line.option("--diagram", "OUT.svg", "draw the colours and gamuts", options.output);
  line.option("--diagram-plane", list_names(kChromaticityPlanes, "|"),
              "CIE x y or u' v'; default: 1931",
              [&](const std::string& v) { options.plane = &plane_option(v); });
  line.option("--limits", "Y,...", "with the MacAdam limits of luminances, in percent",
              [&](const std::string& v) { options.limits = limits_option(v); });
  line.option("--gamuts", "SET,...", "with the gamuts of these sets of primaries",
              [&](const std::string& v) {
                for (const std::string_view name : split(v, ',')) {
                  options.gamuts.push_back(named_gamut(name, "--gamuts"));
                }
              });
  line.flag("--ellipses", "with MacAdam's ellipses of 1942", options.ellipses);
}

DiagramGamut named_gamut(std::string_view text, std::string_view option) {
  return *gamut_of("linear:" + std::string(text), option);
}

std::optional<DiagramGamut> gamut_of(std::string_view model, std::string_view option) {
  const std::optional<Primaries> primaries = parse_model(model, option).primaries;
  if (!primaries) return std::nullopt;
  const NamedPrimaries* set = set_in(model);
  return DiagramGamut{set != nullptr ? std::string(set->name) : corners_text(*primaries),
                      *primaries};
}

std::vector<std::string> color_labels(const std::vector<std::string>& words, std::size_t count) {
  if (words.size() == count) return words;
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < count; ++i) labels.push_back(std::to_string(i + 1));
  return labels;
}

ChromaticityDiagram diagram_of(const std::vector<ColorRow>& rows,
                               const std::vector<std::string>& labels,
                               const ModelReference& model) {
  const ColorConversion to_xyy(model, parse_model("xyy", "colour"), Adaptation::kNone);
  ChromaticityDiagram diagram;
  diagram.white = named_white(to_xyy.from_white());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Components xyy = to_xyy(rows[i].values);
    diagram.colors.push_back({labels[i], {xyy[0], xyy[1]}});
  }
  return diagram;
}

void add_gamut(ChromaticityDiagram& diagram, std::string_view model, std::string_view option) {
  if (const auto gamut = gamut_of(model, option)) add_once(diagram.gamuts, *gamut);
}

void write_diagram(ChromaticityDiagram diagram, const DiagramOptions& options, bool force) {
  refuse_other_drawings(options.output);
  refuse_taken_outputs({options.output}, force);
  diagram.plane = options.plane;
  diagram.limits = options.limits;
  diagram.ellipses = options.ellipses;
  for (const DiagramGamut& gamut : options.gamuts) add_once(diagram.gamuts, gamut);
  OutputFile file(options.output, force);
  file.write(chromaticity_diagram(diagram));
  file.commit();
}

}  // namespace tristim::tools
