#include "tools/convert_list.h"

#include "tools/cli.h"
#include "tools/report.h"
#include "tristim/color/illuminant.h"
#include "tristim/color/models.h"
#include "tristim/color/observer.h"
#include "tristim/color/spectrum_text.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size() + 2), ' ');
  return text;
}

std::string row(std::string_view name, std::string_view middle, std::string_view end) {
  return "  " + padded(std::string(name), 22) + padded(std::string(middle), 12) + std::string(end) +
         "\n";
}

std::string chromaticity_text(Chromaticity c) { return shortest(c.x) + "," + shortest(c.y); }

Json chromaticity_json(Chromaticity c) { return {c.x, c.y}; }

// What can stand behind a model's name.
std::string suffix(const ColorModel& model) {
  std::string text;
  for (const ModelParameter& p : model.parameters) text += "[:" + std::string(p.name) + "=N]";
  if (takes_curve(model)) return "[:SET[/CURVE]]" + text;
  if (takes_primaries(model)) return "[:SET]" + text;
  return takes_white(model) ? "[@WHITE]" + text : text;
}

std::string_view direction(const ColorModel& model) {
  if (model.base.empty()) return "both";
  if (model.to_base == nullptr) return "target only";
  return model.from_base == nullptr ? "source only" : "both";
}

std::string models_text() {
  std::string text = "Models: components, ranges, source\n";
  for (const ColorModel& model : color_models()) {
    text += row(model.name, model.components,
                std::string(model.ranges) + "  " + std::string(model.source));
    std::string more = suffix(model);
    if (direction(model) != "both")
      more += (more.empty() ? "" : "; ") + std::string(direction(model));
    if (!more.empty()) text += row("", "", more);
    for (const ModelParameter& p : model.parameters) {
      text += row("", "",
                  std::string(p.name) + " " + shortest(p.least) + ".." + shortest(p.most) + ", " +
                      shortest(p.value) + " unless given: " + std::string(p.meaning));
    }
  }
  return text + "  The first of several variants, as of yiq, is meant where none is named.\n";
}

std::string seen_by(const Observer& observer) {
  return std::string(observer.table->title) + "  " + std::string(observer.table->source);
}

std::string context_text() {
  std::string text = "\nSET: red, green, blue, white; curve; source\n";
  for (const NamedPrimaries& set : primaries_list()) {
    const Primaries& p = set.primaries;
    text += "  " + padded(std::string(set.name), 22) + chromaticity_text(p.red) + "  " +
            chromaticity_text(p.green) + "  " + chromaticity_text(p.blue) + "  " +
            chromaticity_text(p.white) + "; " + std::string(set.transfer) + "; " +
            std::string(set.source) + "\n";
  }
  text +=
      "  or numbers: xr,yr,xg,yg,xb,yb,xw,yw, or with luminances xr,yr,xg,yg,xb,yb,Yr,Yg,Yb\n"
      "\nWHITE: chromaticity, source\n";
  for (const WhitePoint& white : kWhitePoints) {
    text += row(white.name, chromaticity_text(white.chromaticity), white.source);
  }
  text += "  or a chromaticity: lab@0.31,0.33\n\nCURVE: formula, source\n";
  for (const TransferFunction& curve : kTransferFunctions) {
    text += row(curve.name, "",
                std::string(curve.formula) + "; " + std::string(curve.domain) + "  " +
                    std::string(curve.source));
  }
  text += row("bt1886,W,B", "", "white W and black B in cd/m2: rgb:bt709/bt1886,100,0.1");
  text += row("gammaN", "", "E = L^(1/N); N as 2.2 or 563/256") + "\n--adapt: source\n";
  for (const AdaptationMethod& method : kAdaptations) text += row(method.name, "", method.source);
  text += "\n--from spectrum FILE: how light is seen\n--observer: functions, source\n";
  for (const Observer& o : observers()) {
    text += row(std::string(o.name) + ", " + std::string(o.field_deg), "", seen_by(o));
  }
  text += "--illuminant: what it is, source\n";
  for (const Illuminant& light : illuminants()) {
    text += row(light.name, "", std::string(light.title) + "  " + std::string(light.table->source));
  }
  for (const ThermalLight& light : thermal_lights()) {
    text += row(std::string(light.name) + ":KELVINS", "", light.title);
  }
  return text;
}

Json models_json() {
  Json models = Json::array();
  for (const ColorModel& model : color_models()) {
    Json parameters = Json::array();
    for (const ModelParameter& p : model.parameters) {
      parameters.push_back({{"name", p.name},
                            {"default", p.value},
                            {"least", p.least},
                            {"most", p.most},
                            {"meaning", p.meaning}});
    }
    models.push_back({{"model", model.name},
                      {"components", model.components},
                      {"ranges", model.ranges},
                      {"base", model.base},
                      {"direction", direction(model)},
                      {"takes", suffix(model)},
                      {"parameters", parameters},
                      {"formula", model.formula},
                      {"source", model.source}});
  }
  return models;
}

Json illuminants_json() {
  Json lights = Json::array();
  for (const Illuminant& light : illuminants()) {
    lights.push_back(
        {{"name", light.name}, {"title", light.title}, {"source", light.table->source}});
  }
  return lights;
}

Json lists_json() {
  Json sets = Json::array();
  for (const NamedPrimaries& set : primaries_list()) {
    sets.push_back({{"name", set.name},
                    {"red", chromaticity_json(set.primaries.red)},
                    {"green", chromaticity_json(set.primaries.green)},
                    {"blue", chromaticity_json(set.primaries.blue)},
                    {"white", chromaticity_json(set.primaries.white)},
                    {"curve", set.transfer},
                    {"source", set.source}});
  }
  Json whites = Json::array();
  for (const WhitePoint& white : kWhitePoints) {
    whites.push_back({{"name", white.name},
                      {"xy", chromaticity_json(white.chromaticity)},
                      {"source", white.source}});
  }
  Json curves = Json::array();
  for (const TransferFunction& curve : kTransferFunctions) {
    curves.push_back({{"name", curve.name},
                      {"domain", curve.domain},
                      {"formula", curve.formula},
                      {"source", curve.source}});
  }
  Json adaptations = Json::array();
  for (const AdaptationMethod& method : kAdaptations) {
    adaptations.push_back({{"name", method.name}, {"source", method.source}});
  }
  return {{"models", models_json()},    {"primaries", sets},
          {"whites", whites},           {"curves", curves},
          {"adaptations", adaptations}, {"illuminants", illuminants_json()}};
}

}  // namespace

void list_color_models(bool json) {
  print(json ? json_line(lists_json()) : models_text() + context_text());
}

}  // namespace tristim::tools
