#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace tristim {

/// A row of an example table: its cells by the names of the header row.
class ExampleRow {
 public:
  explicit ExampleRow(std::map<std::string, std::string> cells) : cells_(std::move(cells)) {}

  const std::string& text(const std::string& column) const { return cells_.at(column); }
  double number(const std::string& column) const { return std::stod(cells_.at(column)); }

 private:
  std::map<std::string, std::string> cells_;
};

inline std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

/// The rows of a CSV file without quoted cells; lines that start with '#' are comments. Throws
/// std::runtime_error where it cannot be read.
inline std::vector<ExampleRow> example_rows(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string line;
  const auto next = [&] {
    while (std::getline(file, line)) {
      if (!line.starts_with('#')) return true;
    }
    return false;
  };
  if (!next()) throw std::runtime_error("cannot read " + path.string());
  const std::vector<std::string> names = cells_of(line);
  std::vector<ExampleRow> rows;
  while (next()) {
    const std::vector<std::string> cells = cells_of(line);
    std::map<std::string, std::string> row;
    for (std::size_t i = 0; i < names.size(); ++i) {
      row[names.at(i)] = i < cells.size() ? cells.at(i) : "";  // empty cells at the end
    }
    rows.emplace_back(std::move(row));
  }
  return rows;
}

}  // namespace tristim
