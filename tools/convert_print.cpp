#include "tools/convert_print.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "tools/cli.h"
#include "tools/report.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

std::string color_text(const ColorModel& model, const Components& c, bool odd) {
  if (model.to_text != nullptr) return model.to_text(c);
  std::string text;
  for (std::size_t i = 0; i < component_count(model); ++i) {
    text += i > 0 ? " " : "";
    text += std::isnan(c[i]) && !odd ? "none" : shortest(c[i]);
  }
  return text;
}

Json color_json(const ColorModel& model, const Components& c) {
  if (model.to_text != nullptr) return model.to_text(c);
  Json numbers = Json::array();
  for (std::size_t i = 0; i < component_count(model); ++i) numbers.push_back(number_json(c[i]));
  return numbers;
}

// A colour and what each step makes of it.
struct Station {
  const ColorModel* model;
  Components values;
};

bool has_nan(const Components& c) {
  return std::any_of(c.begin(), c.end(), [](double x) { return std::isnan(x); });
}

// Where a colour that is one has no value in the next model, says why.
void refuse_none(const ConversionStep& step, const Components& before, const Components& after) {
  const bool up = base_of(*step.from) == step.to;
  const auto why = up ? step.from->why_none_to_base : step.to->why_none_from_base;
  for (std::size_t i = 0; i < component_count(*step.to); ++i) {
    if (!std::isnan(after[i])) return;
  }
  if (why == nullptr) return;
  throw Error(ErrorKind::kContent,
              std::string(step.from->name) + " " + color_text(*step.from, before, false),
              why(before));
}

std::vector<Station> way_of(const Components& color, const ColorConversion& conversion) {
  std::vector<Station> way{{&conversion.from(), color}};
  for (const ConversionStep& step : conversion.steps()) {
    const Components& before = way.back().values;
    const Components after = step.apply(before, step.context);
    if (!has_nan(color)) refuse_none(step, before, after);
    way.push_back({step.to, after});
  }
  return way;
}

std::string way_text(const std::vector<Station>& way, bool odd) {
  std::string text;
  for (const Station& station : way) {
    text += (text.empty() ? "" : " -> ") + std::string(station.model->name) + " " +
            color_text(*station.model, station.values, odd);
  }
  return text + "\n";
}

Json way_json(const std::vector<Station>& way) {
  Json json = Json::array();
  for (const Station& station : way) {
    json.push_back(
        {{"model", station.model->name}, {"values", color_json(*station.model, station.values)}});
  }
  return json;
}

std::vector<std::string> explained_steps(const ColorConversion& conversion,
                                         const PrintOptions& options) {
  std::vector<std::string> steps = conversion.explain();
  if (!options.origin.empty()) steps.insert(steps.begin(), options.origin);
  return steps;
}

// Conversions of `from` to every model that can be reached and is relative to the same primaries
// and white where it can be.
std::vector<ColorConversion> all_conversions(const ModelReference& from, Adaptation adaptation) {
  std::vector<ColorConversion> all;
  for (const ColorModel& model : color_models()) {
    if (model.from_base == nullptr && !model.base.empty()) continue;
    all.emplace_back(from, parse_model(model.name, "--to"), adaptation);
  }
  return all;
}

}  // namespace

void print_colors(std::span<const ColorRow> rows, const ColorConversion& conversion,
                  const PrintOptions& options) {
  Json colors = Json::array();
  Json ways = Json::array();
  std::string text;
  std::string explanation;
  for (const std::string& step : explained_steps(conversion, options)) explanation += step + "\n";
  for (const ColorRow& row : rows) {
    const std::vector<Station> way = way_of(row.values, conversion);
    const Components& out = way.back().values;
    explanation += options.explain && !options.json ? way_text(way, row.odd) : "";
    if (options.json && options.explain) ways.push_back(way_json(way));
    if (options.json) colors.push_back(color_json(conversion.to(), out));
    text += color_text(conversion.to(), out, row.odd) + "\n";
  }
  if (!options.json) return print(options.explain ? explanation + text : text);
  Json json{{"from", options.from}, {"to", options.to}, {"rows", colors}};
  if (!options.origin.empty()) json[options.from] = options.origin_facts;
  if (options.explain) json["steps"] = explained_steps(conversion, options);
  if (options.explain) json["ways"] = ways;
  print(json_line(json));
}

void print_all_models(std::span<const ColorRow> rows, const ModelReference& from,
                      Adaptation adaptation, const PrintOptions& options) {
  const std::vector<ColorConversion> conversions = all_conversions(from, adaptation);
  std::size_t width = 0;
  for (const ColorConversion& conversion : conversions) {
    width = std::max(width, conversion.to().components.size() + 2);
  }
  Json json = Json::array();
  std::string text;
  for (const ColorRow& row : rows) {
    Json models = Json::object();
    if (!text.empty()) text += "\n";
    for (const ColorConversion& conversion : conversions) {
      const ColorModel& model = conversion.to();
      const Components out = conversion(row.values);
      std::string name(model.name);
      name.resize(30, ' ');
      std::string components(model.components);
      components.resize(width, ' ');
      text += name + components + color_text(model, out, row.odd) + "\n";
      if (options.json) models[std::string(model.name)] = color_json(model, out);
    }
    json.push_back(models);
  }
  if (!options.json) return print(text);
  print(json_line(Json{{"from", options.from}, {"to", "all"}, {"rows", json}}));
}

}  // namespace tristim::tools
