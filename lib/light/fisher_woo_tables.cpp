#include "tristim/light/fisher_woo_tables.h"

#include <array>
#include <charconv>

#include "lib/core/math.h"
#include "lib/light/degrees.h"
#include "tristim/core/text.h"
#include "tristim/light/fisher_woo.h"
#include "tristim/light/highlight_match.h"

namespace tristim {
namespace {

using Texts = std::span<const std::string_view>;

constexpr std::string_view kRho1[] = {"5",    "20.0",  "40.0",  "60.0",  "80.0",
                                      "85.0", "87.00", "89.00", "89.50", "89.90"};
constexpr std::string_view kPrinted1[] = {
#include "luts/fisher_woo_table1.csv"
};

constexpr std::string_view kRho2[] = {"10.00", "20.00", "30.00", "40.00", "50.00",
                                      "60.00", "70.00", "80.00", "85.00"};
constexpr std::string_view kR2[] = {"5.00",  "10.00", "15.00", "20.00", "25.00",
                                    "30.00", "35.00", "40.00", "45.00"};
constexpr std::string_view kPrinted2[] = {
#include "luts/fisher_woo_table2.csv"
};

constexpr std::string_view kR3[] = {"10.00",  "20.00",  "40.00",  "60.00", "80.00",
                                    "100.00", "200.00", "300.00", "400.00"};
constexpr std::string_view kLe3[] = {"0.00",   "30.00",  "60.00", "90.00",
                                     "120.00", "150.00", "180.00"};
constexpr std::string_view kPrinted3[] = {
#include "luts/fisher_woo_table3.csv"
};

double number(std::string_view text) { return parse_number(text).value_or(0); }

template <typename Cell>
std::vector<double> cells(Texts rows, Texts columns, const Cell& cell) {
  std::vector<double> values;
  for (const std::string_view row : rows) {
    for (const std::string_view column : columns)
      values.push_back(cell(number(row), number(column)));
  }
  return values;
}

double single_precision_error(double rho_deg, double r) {
  const float cos_nu = static_cast<float>(detail::cos_deg(rho_deg / 2));
  const float cos_rho = static_cast<float>(detail::cos_deg(rho_deg));
  return 255 * (detail::pow(double{cos_nu}, 4 * r) - detail::pow(double{cos_rho}, r));
}

}  // namespace

std::string PaperTable::rounded(std::size_t cell) const {
  const std::string_view text = printed[cell];
  const int decimals = static_cast<int>(text.size() - text.find('.') - 1);
  std::array<char, 64> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), values[cell],
                                 std::chars_format::fixed, decimals);
  return {buffer.data(), end.ptr};
}

PaperTable fisher_woo_table1() {
  static constexpr std::string_view kOneRow[] = {""};
  return {.number = 1,
          .caption = "Required f for rho given any exponent, coplanar LNE",
          .formula = "f = log(cos rho) / log(cos nu), rho = 2 nu",
          .row_name = "",
          .column_name = "rho (degrees)",
          .rows = kOneRow,
          .columns = kRho1,
          .printed = kPrinted1,
          .values = cells(kOneRow, kRho1, [](double, double rho) { return exponent_factor(rho); }),
          .remark = "All cells are as printed."};
}

PaperTable fisher_woo_table2(CosinePrecision precision) {
  return {
      .number = 2,
      .caption = "Pixel value errors for r from 5 to 45, coplanar LNE",
      .formula = "255 (cos^(4r) nu - cos^r rho), rho = 2 nu",
      .row_name = "rho (deg.)",
      .column_name = "Shininess exponent r",
      .rows = kRho2,
      .columns = kR2,
      .printed = kPrinted2,
      .values = cells(
          kRho2, kR2,
          precision == CosinePrecision::kSingle ? single_precision_error : coplanar_pixel_error),
      .remark =
          precision == CosinePrecision::kSingle
              ? "Cosines rounded to single precision before they are raised."
              : "With the two cosines rounded to single precision before they are raised all cells "
                "are as printed."};
}

PaperTable fisher_woo_table3() {
  return {.number = 3,
          .caption = "Maximum pixel error given shininess and [L,E], with f = 4",
          .formula = "the extreme of 255 ((R.E)^r - (N.H)^(4r)) over N",
          .row_name = "r",
          .column_name = "2 beta = angle between L and E (degrees)",
          .rows = kR3,
          .columns = kLe3,
          .printed = kPrinted3,
          .values = cells(
              kR3, kLe3,
              [](double r, double le_deg) { return highlight_errors(r, 4, le_deg).extreme(); }),
          .remark =
              "At [L,E] = 90 the maximum is 63.75 for every r; 180 is a limit, H is not defined "
              "there."};
}

}  // namespace tristim
