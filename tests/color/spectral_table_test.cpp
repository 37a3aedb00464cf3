#include "tristim/color/spectral_table.h"

#include <gtest/gtest.h>

#include "tristim/color/observer.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

const SpectralTable& table(std::string_view name) { return *find_by_name(spectral_tables(), name); }

TEST(SpectralTables, HaveWholeRowsAtEqualSteps) {
  for (const SpectralTable& t : spectral_tables()) {
    SCOPED_TRACE(t.name);
    ASSERT_EQ(t.cells.size(), t.row_count() * (t.column_count() + 1));
    const double step = t.lambda_nm(1) - t.lambda_nm(0);
    for (std::size_t row = 1; row < t.row_count(); ++row) {
      EXPECT_EQ(t.lambda_nm(row) - t.lambda_nm(row - 1), step);
    }
    EXPECT_EQ(spectrum_fault(column_of(t, 0)), "");
  }
}

// The matrix that the CIE chose in 1931 to make x y z of r g b. The r g b have five decimals and so
// differ by 1.9e-4 at the most; swapped digits of some copies (500 and 580 nm) by 1e-3.
TEST(SpectralTables, RgbMatchingFunctionsMakeThoseOfXyz) {
  const SpectralTable& rgb = table("cie1931-rgb");
  for (std::size_t row = 0; row < rgb.row_count(); ++row) {
    SCOPED_TRACE(rgb.lambda_nm(row));
    const double r = rgb.value(row, 0) / 0.17697;
    const double g = rgb.value(row, 1) / 0.17697;
    const double b = rgb.value(row, 2) / 0.17697;
    const Xyz bar = matching_functions(observers()[0], static_cast<int>(rgb.lambda_nm(row)));
    EXPECT_NEAR(0.49 * r + 0.31 * g + 0.20 * b, bar.x, 2e-4);
    EXPECT_NEAR(0.17697 * r + 0.81240 * g + 0.01063 * b, bar.y, 2e-4);
    EXPECT_NEAR(0.01 * g + 0.99 * b, bar.z, 2e-4);
  }
}

// ybar is V but for digits below 1e-6.
TEST(SpectralTables, PhotopicEfficiencyIsYbar) {
  const SpectralTable& v = table("photopic");
  for (std::size_t row = 0; row < v.row_count(); ++row) {
    const Xyz bar = matching_functions(observers()[0], static_cast<int>(v.lambda_nm(row)));
    EXPECT_NEAR(v.value(row, 0), bar.y, 6e-13);
  }
}

TEST(SpectralTables, ScotopicEfficiencyPeaksAt507) {
  const SpectralTable& v = table("scotopic");
  EXPECT_EQ(v.lambda_nm(127), 507);
  EXPECT_EQ(v.value(127, 0), 1);
}

}  // namespace
}  // namespace tristim
