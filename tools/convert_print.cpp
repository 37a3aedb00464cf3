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
void refuse_none(const ConversionStep& step, const Components& before, const Components& after,
                 const std::string& place) {
  const bool up = base_of(*step.from) == step.to;
  const auto why = up ? step.from->why_none_to_base : step.to->why_none_from_base;
  for (std::size_t i = 0; i < component_count(*step.to); ++i) {
    if (!std::isnan(after[i])) return;
  }
  if (why == nullptr) return;
  throw Error(ErrorKind::kContent,
              (place.empty() ? "" : place + ": ") + std::string(step.from->name) + " " +
                  color_text(*step.from, before, false),
              why(before));
}

// `place` is that of the colour, for messages.
void go_on(std::vector<Station>& way, const ColorConversion& conversion, const std::string& place) {
  const bool defined = !has_nan(way.back().values);
  for (const ConversionStep& step : conversion.steps()) {
    const Components before = way.back().values;
    const Components after = step.apply(before, step.context);
    if (defined) refuse_none(step, before, after, place);
    way.push_back({step.to, after});
  }
}

std::vector<Station> way_of(const ColorRow& row, const ColorConversion& conversion) {
  std::vector<Station> way{{&conversion.from(), row.values}};
  go_on(way, conversion, row.place);
  return way;
}

// Colours on their way, and how many of them were brought inside.
struct GamutCount {
  const GamutMapping* mapping = nullptr;  // nullptr: none is
  std::size_t outside = 0, changed = 0;
};

std::vector<Station> way_of(const ColorRow& row, const ColorConversion& conversion,
                            GamutCount& gamut) {
  if (gamut.mapping == nullptr) return way_of(row, conversion);
  std::vector<Station> way = way_of(row, gamut.mapping->to_light());
  const Components& light = way.back().values;
  const auto mapped = (*gamut.mapping)(light);
  if (!has_nan(light) && !in_gamut({light[0], light[1], light[2]})) ++gamut.outside;
  if (!mapped) return way_of(row, conversion);
  ++gamut.changed;
  way.push_back({&gamut.mapping->from_light().from(), *mapped});
  go_on(way, gamut.mapping->from_light(), row.place);
  return way;
}

void say_count(const GamutCount& gamut, std::size_t colors) {
  const std::string outside = std::to_string(gamut.outside) + " of " + std::to_string(colors) +
                              (colors == 1 ? " colour" : " colours") + " outside the gamut";
  note("note: " + outside + ", " + std::to_string(gamut.changed) + " changed by " +
       std::string(gamut.mapping->method().name));
}

std::string step_text(const GamutMethod& method) {
  return "gamut map " + std::string(method.name) +
         ", between linear and linear: " + std::string(method.formula) + " " +
         std::string(method.source);
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
                                         const GamutMapping* gamut, const PrintOptions& options) {
  std::vector<std::string> steps = conversion.explain();
  if (gamut != nullptr) {
    steps = gamut->to_light().explain();
    steps.push_back(step_text(gamut->method()));
    for (std::string& step : gamut->from_light().explain()) steps.push_back(std::move(step));
  }
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
                  const GamutMapping* gamut, const PrintOptions& options) {
  const std::vector<std::string> steps = explained_steps(conversion, gamut, options);
  GamutCount count{.mapping = gamut};
  Json colors = Json::array();
  Json ways = Json::array();
  std::string text;
  std::string explanation;
  for (const std::string& step : steps) explanation += step + "\n";
  for (const ColorRow& row : rows) {
    const std::vector<Station> way = way_of(row, conversion, count);
    const Components& out = way.back().values;
    explanation += options.explain && !options.json ? way_text(way, row.odd) : "";
    if (options.json && options.explain) ways.push_back(way_json(way));
    if (options.json) colors.push_back(color_json(conversion.to(), out));
    text += color_text(conversion.to(), out, row.odd) + "\n";
  }
  if (gamut != nullptr) say_count(count, rows.size());
  if (!options.json) return print(options.explain ? explanation + text : text);
  Json json{{"from", options.from}, {"to", options.to}, {"rows", colors}};
  if (gamut != nullptr) {
    json["gamut_map"] = {
        {"method", gamut->method().name}, {"outside", count.outside}, {"changed", count.changed}};
  }
  if (!options.origin.empty()) json[options.from] = options.origin_facts;
  if (options.explain) json["steps"] = steps;
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
