#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tristim {

/// One of the three tables of [FisherWoo], computed anew beside what the paper prints. The heads
/// are the paper's, as text; cells are row by row.
struct PaperTable {
  int number = 0;
  std::string_view caption;   // the paper's
  std::string_view formula;   // of a cell
  std::string_view row_name;  // "" where there is one row
  std::string_view column_name;
  std::span<const std::string_view> rows, columns;
  std::span<const std::string_view> printed;
  std::vector<double> values;
  std::string_view remark = {};  // on the misprints

  /// The value of a cell, rounded to the decimals that the paper gives it.
  std::string rounded(std::size_t cell) const;

  /// Whether the paper's number is not the rounded value.
  bool misprint(std::size_t cell) const { return rounded(cell) != printed[cell]; }
};

/// Whether the cosines of table 2 are rounded to float before they are raised, as the authors did
/// it: then all of its 81 cells are as printed. Else 7 are not.
enum class CosinePrecision { kDouble, kSingle };

/// Table 1: the factor f of equation 5. All 10 cells are as printed.
PaperTable fisher_woo_table1();

/// Table 2: the error of equation 6, coplanar.
PaperTable fisher_woo_table2(CosinePrecision precision = CosinePrecision::kDouble);

/// Table 3: the extreme of highlight_errors with f = 4. 11 of the 63 cells are not as printed, by
/// .01. At [L,E] = 90 it is 63.75 for every r.
PaperTable fisher_woo_table3();

}  // namespace tristim
