#include "tools/shade_list.h"

#include "tools/report.h"

namespace tristim::tools {
namespace {

std::string joined(std::span<const Column> columns) {
  std::string text;
  for (const std::string& name : column_names(columns)) text += (text.empty() ? "" : " ") + name;
  return text;
}

// Words after a heading, in lines of 100 characters.
std::string paragraph(std::string_view heading, const std::string& words) {
  constexpr std::size_t kIndent = 11;
  constexpr std::size_t kWidth = 100;
  std::string text;
  std::string line = "  " + std::string(heading);
  line.resize(kIndent, ' ');
  std::size_t at = 0;
  while (at < words.size()) {
    const std::size_t end = std::min(words.find(' ', at), words.size());
    if (line.size() > kIndent && line.size() + 1 + end - at > kWidth) {
      text += line + "\n";
      line.assign(kIndent, ' ');
    }
    if (line.size() > kIndent) line += ' ';
    line += words.substr(at, end - at);
    at = end + 1;
  }
  return text + line + "\n";
}

}  // namespace

std::string model_text(const ShadeModel& model) {
  return std::string(model.name) + (model.evaluate != nullptr ? "  (CSV)\n" : "  (JSON)\n") +
         paragraph("inputs", joined(model.inputs)) + paragraph("outputs", joined(model.outputs)) +
         paragraph("formula", std::string(model.formula)) +
         paragraph("source", std::string(model.source));
}

void list_shade_models(bool json) {
  Json all = Json::array();
  std::string text;
  for (const ShadeModel& model : shade_models()) {
    all.push_back({{"model", model.name},
                   {"form", model.evaluate != nullptr ? "csv" : "json"},
                   {"inputs", column_names(model.inputs)},
                   {"outputs", column_names(model.outputs)},
                   {"formula", model.formula},
                   {"source", model.source}});
    text += model_text(model);
  }
  print(json ? json_line(all) : text);
}

}  // namespace tristim::tools
