#include <cmath>

#include "lib/device/read_display.h"
#include "tristim/core/file.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

TableResponse checked_table(const TomlTable& table, std::string_view key,
                            const std::vector<std::vector<double>>& rows, double code_max) {
  TableResponse response;
  for (const auto& row : rows) {
    if (row.size() != 2) table.fail(key, "a row is no pair", "give [code, luminance] pairs");
    response.code.push_back(row[0]);
    response.luminance.push_back(row[1]);
  }
  if (rows.size() < 2) table.fail(key, "a measured table needs at least 2 rows");
  if (!strictly_ascending(response.code) || !strictly_ascending(response.luminance)) {
    table.fail(key, "the measured table is not ascending",
               "sort the rows by code; luminance must rise from row to row");
  }
  if (response.code.front() < 0 || response.code.back() > code_max ||
      response.luminance.front() < 0) {
    table.fail(key, "the measured table leaves the codes 0.." + shortest(code_max) +
                        " or has negative luminance");
  }
  return response;
}

std::vector<std::vector<double>> csv_rows(const TomlTable& table, const std::string& path) {
  std::vector<std::vector<double>> rows;
  const std::string text = read_text_file(path, std::size_t{1} << 20);
  for (std::string_view line : split(text, '\n')) {
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty() || line.starts_with('#')) continue;
    const std::vector<std::string_view> cells = split(line, ',');
    std::vector<double> row;
    for (std::string_view cell : cells) {
      while (cell.starts_with(' ')) cell.remove_prefix(1);
      while (cell.ends_with(' ')) cell.remove_suffix(1);
      const auto value = parse_number(cell);
      if (value && std::isfinite(*value)) row.push_back(*value);
    }
    const bool header = rows.empty() && row.empty();
    if (header) continue;
    if (row.size() != 2 || cells.size() != 2) {
      table.fail("file", path + ": '" + std::string(line) + "' is no pair of code and luminance");
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

Response read_table_response(const TomlTable& table, double code_max,
                             const std::string& directory) {
  const auto pairs = table.rows("table");
  const auto file = table.string("file");
  if (pairs) return checked_table(table, "table", *pairs, code_max);
  if (!file) {
    table.fail("kind", "a measured response has no figures",
               "give table = [[code, luminance], ...] or file = \"measured.csv\"");
  }
  if (directory.empty()) table.fail("file", "no file can be named here", "give the table itself");
  const std::string path = file->starts_with('/') ? *file : directory + "/" + *file;
  return checked_table(table, "file", csv_rows(table, path), code_max);
}

struct ResponseKind {
  std::string_view name;
};
constexpr ResponseKind kResponseKinds[] = {{"srgb"}, {"linear"}, {"gamma"}, {"bt1886"}, {"table"}};

}  // namespace

Response read_response(const TomlTable& root, double code_max, const std::string& directory) {
  const auto table = root.table("response");
  if (!table) return SrgbResponse{};
  const std::string_view kind = choice(*table, "kind", kResponseKinds, kResponseKinds[0]).name;
  Response response = SrgbResponse{};
  if (kind == "linear") response = LinearResponse{};
  if (kind == "gamma") {
    GammaResponse gamma;
    gamma.gamma = number_in(*table, "gamma", 2.2, 0.01, 100, "from 0.01 to 100");
    gamma.i0 = number_in(*table, "i0", 0, 0, 1 - kTiny, "from 0 up to, not including, 1");
    gamma.k = number_in(*table, "k", 0, table->has("k") ? 1e-300 : 0, 1e300, "above 0");
    response = gamma;
  }
  if (kind == "bt1886") {
    response = Bt1886Response{
        number_in(*table, "black", 0, 0, 1 - kTiny, "from 0 up to, not including, 1")};
  }
  if (kind == "table") response = read_table_response(*table, code_max, directory);
  table->finish();
  return response;
}

}  // namespace tristim::detail
