#include "tools/measured_primaries.h"

#include <cmath>
#include <optional>

#include "tools/csv_lines.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

struct Light {
  std::string_view name;
  std::optional<Xyz> xyz;
};

[[noreturn]] void fail(const std::string& file, std::size_t line, const std::string& wrong,
                       const std::string& remedy) {
  throw Error(ErrorKind::kContent, file + ":" + std::to_string(line), wrong, remedy);
}

double figure(const std::string& cell, const std::string& file, std::size_t line) {
  const auto value = parse_number(cell);
  if (value && std::isfinite(*value)) return *value;
  fail(file, line, "'" + cell + "' is no finite number", "give numbers with decimal points");
}

Xyz light_of(const std::vector<std::string>& cells, bool chromaticity, const std::string& file,
             std::size_t line) {
  const double a = figure(cells[1], file, line);
  const double b = figure(cells[2], file, line);
  const double c = figure(cells[3], file, line);
  if (!chromaticity) return {a, b, c};
  if (b == 0) fail(file, line, "y is 0", "give the chromaticity x,y and the luminance Y");
  return xyy_to_xyz({a, b, c});
}

bool is_heading(const std::vector<std::string>& cells) {
  for (const std::string& cell : cells) {
    if (parse_number(cell)) return false;
  }
  return true;
}

}  // namespace

MeasuredPrimaries read_measured_primaries(const std::string& file) {
  Light lights[] = {{"red", {}}, {"green", {}}, {"blue", {}}, {"white", {}}, {"black", {}}};
  TextLines lines(file);
  std::string line;
  bool chromaticity = false;
  while (lines.next(line)) {
    const std::vector<std::string> cells = csv_cells(line);
    if (line.empty() || line[0] == '#' || (cells.size() == 1 && cells[0].empty())) continue;
    if (cells.size() != 4) {
      fail(file, lines.number(), "has " + std::to_string(cells.size()) + " columns",
           "give name,X,Y,Z");
    }
    if (is_heading(cells)) {
      chromaticity = cells[1] == "x";
      continue;
    }
    const Light* named = find_by_name(lights, cells[0]);
    if (named == nullptr) {
      fail(file, lines.number(), "unknown light '" + cells[0] + "'", name_hint(lights, cells[0]));
    }
    lights[named - lights].xyz = light_of(cells, chromaticity, file, lines.number());
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (!lights[i].xyz) {
      throw Error(ErrorKind::kContent, file, std::string(lights[i].name) + " is missing",
                  "give rows of red, green and blue, and of white and black where measured");
    }
  }
  return {*lights[0].xyz, *lights[1].xyz, *lights[2].xyz, lights[3].xyz, lights[4].xyz};
}

}  // namespace tristim::tools
