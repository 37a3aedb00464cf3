#include <array>
#include <optional>

#include "tools/cli.h"
#include "tools/report.h"
#include "tools/shade_paper.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/light/fisher_woo_tables.h"
#include "tristim/light/highlight_match.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr Command kCommand{"shade tables", "--paper PAPER [options]",
                           "the tables of a paper computed anew, its misprints marked",
                           run_shade_tables};

constexpr std::string_view kExamples =
    "  tristim shade tables --paper fisher-woo\n"
    "  tristim shade tables --paper fisher-woo --table 2 --single\n"
    "  tristim shade tables --paper fisher-woo --table 3 --format csv\n"
    "  tristim shade tables --paper fisher-woo --json\n";

struct Paper {
  std::string_view name, title;
};
constexpr Paper kPapers[] = {
    {"fisher-woo",
     "F. Fisher, A. Woo: R.E versus N.H specular highlights. Graphics Gems IV, 1994"}};

struct Options {
  std::string paper;
  int table = 0;  // 0: all
  bool single = false, json = false;
  std::string format = "text";
};

std::vector<PaperTable> chosen_tables(const Options& options) {
  const auto precision = options.single ? CosinePrecision::kSingle : CosinePrecision::kDouble;
  std::vector<PaperTable> tables;
  if (options.table == 0 || options.table == 1) tables.push_back(fisher_woo_table1());
  if (options.table == 0 || options.table == 2) tables.push_back(fisher_woo_table2(precision));
  if (options.table == 0 || options.table == 3) tables.push_back(fisher_woo_table3());
  return tables;
}

std::string right_aligned(std::string_view text, std::size_t width) {
  std::string padded(width > text.size() ? width - text.size() : 0, ' ');
  return padded.append(text);
}

constexpr std::size_t kHeadWidth = 10;
constexpr std::size_t kCellWidth = 8;

std::string heads_text(const PaperTable& table) {
  std::string text = right_aligned(table.row_name, kHeadWidth);
  if (table.row_name.empty()) text = right_aligned("rho", kHeadWidth);
  for (const std::string_view column : table.columns)
    text += right_aligned(column, kCellWidth) + " ";
  return text + "\n";
}

std::string misprints_text(const PaperTable& table) {
  constexpr int kPerLine = 3;
  std::string text;
  int count = 0;
  for (std::size_t cell = 0; cell < table.values.size(); ++cell) {
    if (!table.misprint(cell)) continue;
    text += count == 0 ? "* The paper prints " : count % kPerLine == 0 ? ",\n  " : ", ";
    ++count;
    text.append(table.printed[cell]).append(" for ").append(table.rounded(cell));
    text.append(" at (").append(table.rows[cell / table.columns.size()]).append(", ");
    text.append(table.columns[cell % table.columns.size()]).append(")");
  }
  return text.empty() ? text : text + ".\n";
}

std::string table_text(const PaperTable& table) {
  const std::size_t columns = table.columns.size();
  std::string text =
      "Table " + std::to_string(table.number) + ". " + std::string(table.caption) + "\n\n";
  text +=
      std::string(kHeadWidth + 3, ' ') + std::string(table.column_name) + "\n" + heads_text(table);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    text += right_aligned(table.row_name.empty() ? "required f" : table.rows[row], kHeadWidth);
    for (std::size_t column = 0; column < columns; ++column) {
      const std::size_t cell = row * columns + column;
      text += right_aligned(table.rounded(cell), kCellWidth) + (table.misprint(cell) ? "*" : " ");
    }
    text += "\n";
  }
  return text + "\n  value = " + std::string(table.formula) + "\n" + misprints_text(table) +
         std::string(table.remark) + "\n";
}

std::string tables_text(const std::vector<PaperTable>& tables) {
  std::string text;
  for (const PaperTable& table : tables) text += (text.empty() ? "" : "\n\n") + table_text(table);
  return text;
}

std::string tables_csv(const std::vector<PaperTable>& tables) {
  std::string text = "table,row,column,value,rounded,printed,misprint\n";
  for (const PaperTable& table : tables) {
    for (std::size_t cell = 0; cell < table.values.size(); ++cell) {
      text += std::to_string(table.number) + ",";
      text.append(table.rows[cell / table.columns.size()]).append(",");
      text.append(table.columns[cell % table.columns.size()]).append(",");
      text += shortest(table.values[cell]) + "," + table.rounded(cell) + ",";
      text.append(table.printed[cell]).append(table.misprint(cell) ? ",1\n" : ",0\n");
    }
  }
  return text;
}

Json numbers_json(std::span<const std::string_view> texts) {
  Json list = Json::array();
  for (const std::string_view text : texts) list.push_back(*parse_number(text));
  return list;
}

Json table_json(const PaperTable& table) {
  const std::size_t columns = table.columns.size();
  Json values = Json::array();
  Json printed = Json::array();
  Json misprints = Json::array();
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const auto first = table.values.begin() + static_cast<std::ptrdiff_t>(row * columns);
    values.push_back(std::vector<double>(first, first + static_cast<std::ptrdiff_t>(columns)));
    printed.push_back(numbers_json(table.printed.subspan(row * columns, columns)));
    for (std::size_t column = 0; column < columns; ++column) {
      const std::size_t cell = row * columns + column;
      if (!table.misprint(cell)) continue;
      misprints.push_back({{"row", parse_number(table.rows[row]).value_or(0)},
                           {"column", *parse_number(table.columns[column])},
                           {"printed", *parse_number(table.printed[cell])},
                           {"right", *parse_number(table.rounded(cell))}});
    }
  }
  return {{"table", table.number},
          {"caption", table.caption},
          {"formula", table.formula},
          {"rows", table.row_name.empty() ? Json::array() : numbers_json(table.rows)},
          {"columns", numbers_json(table.columns)},
          {"values", values},
          {"printed", printed},
          {"misprints", misprints},
          {"remark", table.remark}};
}

// What the paper does not have: the columns of table 3 for an exponent without end.
constexpr std::array kLimitAngles{0.0, 30.0, 60.0, 90.0, 120.0, 150.0, 180.0};

Json limits_json() {
  Json list = Json::array();
  for (const double le_deg : kLimitAngles) {
    list.push_back({{"LE_deg", le_deg},
                    {"maximum_error_f4", limit_error(le_deg)},
                    {"minimax_f", minimax_factor_limit(le_deg)},
                    {"maximum_error_minimax_f", minimax_limit_error(le_deg)}});
  }
  return list;
}

std::string limits_text() {
  constexpr int kDigits = 5;
  std::string angles = right_aligned("[L,E]", kHeadWidth + 8);
  std::string errors = right_aligned("error with f = 4", kHeadWidth + 8);
  std::string factors = right_aligned("f* = 4 cos beta", kHeadWidth + 8);
  std::string best = right_aligned("error with f*", kHeadWidth + 8);
  for (const double le_deg : kLimitAngles) {
    angles += right_aligned(rounded(le_deg, kDigits), kCellWidth);
    errors += right_aligned(rounded(limit_error(le_deg), kDigits), kCellWidth);
    factors += right_aligned(rounded(minimax_factor_limit(le_deg), kDigits), kCellWidth);
    best += right_aligned(rounded(minimax_limit_error(le_deg), kDigits), kCellWidth);
  }
  return "\n\nPast the paper: what table 3 tends to as r grows, and the factor that makes the "
         "maximum "
         "smallest\n\n" +
         angles + "\n" + errors + "\n" + factors + "\n" + best + "\n";
}

void declare(CommandLine& line, Options& options) {
  line.option("--paper", "PAPER", "one of: " + list_names(kPapers), options.paper);
  line.option("--table", "N", "1, 2 or 3; default: all",
              [&](const std::string& v) { options.table = integer_option("--table", v, 1, 3); });
  line.flag("--single", "table 2 as the authors computed it, with cosines in single precision",
            options.single);
  line.option("--format", "text|csv|json", "default: text", options.format);
  line.flag("--json", "the same as --format json", options.json);
}

void check(Options& options) {
  if (options.paper.empty()) {
    throw Error(ErrorKind::kMisuse, "--paper", "is missing", "give one of " + list_names(kPapers));
  }
  if (find_by_name(kPapers, options.paper) == nullptr) {
    throw Error(ErrorKind::kMisuse, "--paper", "unknown paper '" + options.paper + "'",
                name_hint(kPapers, options.paper));
  }
  if (options.json) options.format = "json";
  constexpr Paper kFormats[] = {{"text", ""}, {"csv", ""}, {"json", ""}};
  if (find_by_name(kFormats, options.format) == nullptr) {
    throw Error(ErrorKind::kMisuse, "--format", "unknown format '" + options.format + "'",
                name_hint(kFormats, options.format));
  }
}

}  // namespace

void run_shade_tables(Arguments arguments) {
  Options options;
  CommandLine line(kCommand, kExamples);
  declare(line, options);
  if (!line.parse(arguments)) return;
  check(options);
  const std::vector<PaperTable> tables = chosen_tables(options);
  const bool limits = options.table == 0 || options.table == 3;
  if (same_name(options.format, "csv")) return print(tables_csv(tables));
  if (same_name(options.format, "text"))
    return print(tables_text(tables) + (limits ? limits_text() : ""));
  const Paper& paper = *find_by_name(kPapers, options.paper);
  Json json{{"paper", paper.name}, {"title", paper.title}, {"tables", Json::array()}};
  for (const PaperTable& table : tables) json["tables"].push_back(table_json(table));
  if (limits) json["limits"] = limits_json();
  print(json_line(json));
}

}  // namespace tristim::tools
