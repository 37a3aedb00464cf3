#include "tristim/light/fisher_woo_tables.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace tristim {
namespace {

// "row,column paper>right" of each misprint.
std::vector<std::string> misprints(const PaperTable& table) {
  std::vector<std::string> list;
  for (std::size_t cell = 0; cell < table.values.size(); ++cell) {
    if (!table.misprint(cell)) continue;
    const std::size_t columns = table.columns.size();
    std::string text(table.rows[cell / columns]);
    text.append(",").append(table.columns[cell % columns]).append(" ");
    list.push_back(text.append(table.printed[cell]).append(">").append(table.rounded(cell)));
  }
  return list;
}

TEST(FisherWooTable1, IsAsPrinted) {
  const PaperTable table = fisher_woo_table1();
  ASSERT_EQ(table.values.size(), 10U);
  EXPECT_EQ(table.rounded(0), "4.0038");
  EXPECT_EQ(table.rounded(9), "18.37");
  EXPECT_TRUE(misprints(table).empty());
}

TEST(FisherWooTable2, HasSevenMisprints) {
  const PaperTable table = fisher_woo_table2();
  ASSERT_EQ(table.values.size(), 81U);
  ASSERT_EQ(table.printed.size(), 81U);
  EXPECT_EQ(misprints(table),
            (std::vector<std::string>{"10.00,15.00 0.179>0.178", "10.00,20.00 0.221>0.220",
                                      "10.00,30.00 0.284>0.283", "10.00,35.00 0.307>0.306",
                                      "10.00,40.00 0.325>0.324", "10.00,45.00 0.339>0.338",
                                      "20.00,30.00 1.161>1.162"}));
}

TEST(FisherWooTable2, ComesOutInSinglePrecision) {
  EXPECT_TRUE(misprints(fisher_woo_table2(CosinePrecision::kSingle)).empty());
}

TEST(FisherWooTable3, HasElevenMisprintsOfOneHundredth) {
  const PaperTable table = fisher_woo_table3();
  ASSERT_EQ(table.values.size(), 63U);
  ASSERT_EQ(table.printed.size(), 63U);
  EXPECT_EQ(
      misprints(table),
      (std::vector<std::string>{
          "80.00,0.00 -0.44>-0.43", "80.00,30.00 6.24>6.25", "80.00,120.00 120.69>120.70",
          "100.00,30.00 6.29>6.30", "200.00,0.00 -0.18>-0.17", "200.00,120.00 120.56>120.57",
          "200.00,150.00 196.08>196.07", "300.00,60.00 26.86>26.85", "300.00,90.00 63.76>63.75",
          "400.00,60.00 26.87>26.86", "400.00,90.00 63.76>63.75"}));
  for (std::size_t cell = 0; cell < 63; ++cell) {
    EXPECT_LE(
        std::fabs(std::stod(table.rounded(cell)) - std::stod(std::string(table.printed[cell]))),
        0.0101);
  }
}

}  // namespace
}  // namespace tristim
