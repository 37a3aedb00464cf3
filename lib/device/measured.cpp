#include "tristim/device/measured.h"

#include <algorithm>
#include <cmath>

#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

constexpr std::size_t kLargestFile = std::size_t{1} << 22;  // 65536 rows of three channels
constexpr std::size_t kMostRows = 65536;

[[noreturn]] void fail(const std::string& file, int line, const std::string& wrong,
                       std::string_view remedy) {
  throw Error(ErrorKind::kContent, file + ":" + std::to_string(line), wrong, remedy);
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

char separator_of(std::string_view line) {
  for (const char separator : {';', '\t'}) {
    if (line.find(separator) != std::string_view::npos) return separator;
  }
  return ',';
}

bool has_number(const std::vector<std::string_view>& cells) {
  return std::any_of(cells.begin(), cells.end(),
                     [](std::string_view cell) { return parse_number(trimmed(cell)).has_value(); });
}

double figure(std::string_view cell, const std::string& file, int line) {
  const auto value = parse_number(cell);
  if (value && std::isfinite(*value)) return *value;
  fail(file, line, "'" + std::string(cell) + "' is no finite number",
       "give numbers with decimal points: 64,12.5");
}

// A row's place among the columns of the table; the first row decides how many there are.
void add_row(MeasuredTable& table, const std::vector<std::string_view>& cells, int line) {
  if (table.luminance.empty()) table.luminance.resize(cells.size() == 4 ? 3 : 1);
  if (cells.size() != table.luminance.size() + 1) {
    const bool pairs = table.luminance.size() == 1;
    fail(table.file, line,
         "has " + std::to_string(cells.size()) + (cells.size() == 1 ? " column" : " columns"),
         pairs ? "give code,luminance (or code,red,green,blue) in every row"
               : "give code,red,green,blue in every row");
  }
  if (table.code.size() == kMostRows) fail(table.file, line, "is beyond 65536 rows", "");
  table.code.push_back(figure(trimmed(cells[0]), table.file, line));
  for (std::size_t c = 1; c < cells.size(); ++c) {
    table.luminance[c - 1].push_back(figure(trimmed(cells[c]), table.file, line));
  }
  table.line.push_back(line);
}

// Where else a fault is found, a few lines of it.
std::string others_text(const MeasuredTable& table, const std::vector<std::size_t>& rows) {
  constexpr std::size_t kMost = 8;
  std::string text;
  for (std::size_t i = 1; i < std::min(rows.size(), kMost); ++i) {
    text += (i == 1 ? " (so too in line " : ", ") + std::to_string(table.line[rows[i]]);
  }
  if (text.empty()) return text;
  return text + (rows.size() > kMost ? ", ...)" : ")");
}

std::string at_code(double luminance, double code) {
  return shortest(luminance) + " at code " + shortest(code);
}

}  // namespace

MeasuredTable parse_measured(std::string_view text, const std::string& file) {
  MeasuredTable table{.file = file, .code = {}, .luminance = {}, .line = {}};
  int number = 0;
  bool headed = false;
  for (const std::string_view line : split(without_utf8_mark(text), '\n')) {
    ++number;
    const std::string_view row = trimmed(line);
    if (row.empty() || row.starts_with('#')) continue;
    const std::vector<std::string_view> cells = split(row, separator_of(row));
    const bool heading = table.code.empty() && !headed && !has_number(cells);
    headed = true;
    if (!heading) add_row(table, cells, number);
  }
  if (table.code.size() < 2) {
    throw Error(ErrorKind::kContent, file,
                "has " + std::to_string(table.code.size()) +
                    (table.code.size() == 1 ? " row of figures" : " rows of figures"),
                "a measured table needs 2 or more: code,luminance");
  }
  return table;
}

MeasuredTable load_measured(const std::string& path) {
  return parse_measured(read_text_file(path, kLargestFile), path == "-" ? "standard input" : path);
}

std::optional<MeasuredFault> measured_fault(std::span<const double> code,
                                            std::span<const double> luminance) {
  const auto first_fault = [&](auto&& bad) {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < code.size(); ++i) {
      if (bad(i)) rows.push_back(i);
    }
    return rows;
  };
  auto rows = first_fault([&](std::size_t i) { return code[i] < 0; });
  if (!rows.empty()) {
    return MeasuredFault{rows, "code " + shortest(code[rows[0]]) + " is below 0", "give codes"};
  }
  rows = first_fault([&](std::size_t i) { return i > 0 && !(code[i] > code[i - 1]); });
  if (!rows.empty()) {
    return MeasuredFault{
        rows,
        "code " + shortest(code[rows[0]]) + " does not ascend from " + shortest(code[rows[0] - 1]),
        "sort the rows by code and give each code once"};
  }
  rows = first_fault([&](std::size_t i) { return luminance[i] < 0; });
  if (!rows.empty()) {
    return MeasuredFault{rows,
                         "luminance " + at_code(luminance[rows[0]], code[rows[0]]) + " is below 0",
                         "subtract less of the meter's dark reading"};
  }
  rows = first_fault([&](std::size_t i) { return i > 0 && luminance[i] < luminance[i - 1]; });
  if (!rows.empty()) {
    const std::size_t i = rows[0];
    return MeasuredFault{rows,
                         "luminance falls from " + at_code(luminance[i - 1], code[i - 1]) + " to " +
                             at_code(luminance[i], code[i]),
                         "measure again, or level it out with --monotone"};
  }
  if (!(luminance.back() > luminance.front())) {
    return MeasuredFault{{luminance.size() - 1}, "luminance does not rise", "measure again"};
  }
  return std::nullopt;
}

TableResponse measured_response(const MeasuredTable& table, std::size_t channel) {
  const std::vector<double>& luminance = table.luminance[channel];
  if (const auto fault = measured_fault(table.code, luminance)) {
    fail(table.file, table.line[fault->rows[0]], fault->wrong + others_text(table, fault->rows),
         fault->remedy);
  }
  return {.code = table.code, .luminance = luminance};
}

std::vector<double> monotone_luminance(std::span<const double> luminance) {
  struct Pool {
    double sum;
    std::size_t count;
    double mean() const { return sum / static_cast<double>(count); }
  };
  std::vector<Pool> pools;
  for (const double y : luminance) {
    pools.push_back({y, 1});
    while (pools.size() > 1 && pools[pools.size() - 2].mean() > pools.back().mean()) {
      const Pool last = pools.back();
      pools.pop_back();
      pools.back() = {pools.back().sum + last.sum, pools.back().count + last.count};
    }
  }
  std::vector<double> level;
  for (const Pool& pool : pools) level.insert(level.end(), pool.count, pool.mean());
  return level;
}

}  // namespace tristim
