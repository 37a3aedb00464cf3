#include "tools/report.h"

#include <algorithm>
#include <cmath>

namespace tristim::tools {

std::string steps_text(const std::vector<StepReport>& steps) {
  std::string text;
  int number = 0;
  for (const StepReport& step : steps) {
    text += std::to_string(++number) + ". " + step.name;
    if (!step.formula.empty()) text += ": " + step.formula;
    if (!step.source.empty()) text += "  " + step.source;
    text += "\n";
    std::size_t width = 0;
    for (const auto& [name, value] : step.numbers) width = std::max(width, name.size());
    for (const auto& [name, value] : step.numbers) {
      text += "     " + name;
      text.append(width - name.size() + 2, ' ');
      text += value + "\n";
    }
  }
  return text;
}

nlohmann::ordered_json steps_json(const std::vector<StepReport>& steps) {
  auto list = nlohmann::ordered_json::array();
  for (const StepReport& step : steps) {
    nlohmann::ordered_json entry{
        {"name", step.name}, {"formula", step.formula}, {"source", step.source}};
    auto& numbers = entry["numbers"] = nlohmann::ordered_json::object();
    for (const auto& [name, value] : step.numbers) numbers[name] = value;
    list.push_back(std::move(entry));
  }
  return list;
}

std::string json_line(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

nlohmann::ordered_json number_json(double value) {
  if (std::isnan(value)) return nullptr;
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}

}  // namespace tristim::tools
