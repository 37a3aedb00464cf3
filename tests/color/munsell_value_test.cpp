#include "tristim/color/munsell_value.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

TEST(MunsellValue, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/munsell_value.csv")) {
    SCOPED_TRACE(row.text("id"));
    const double in = row.number("in");
    const double out = row.number("out");
    if (row.text("op") == "V_to_Y") {
      EXPECT_NEAR(100 * luminance_from_munsell_value(in), out, 1e-13);
      continue;
    }
    const auto* function = find_by_name(kMunsellValueFunctions, row.text("method"));
    ASSERT_NE(function, nullptr) << row.text("method");
    EXPECT_NEAR(function->value_from_luminance(in / 100), out, 4e-15 * out);
  }
}

// Of the printed formulas, calculated apart from the library.
TEST(MunsellValue, HasTheHistoricalFunctions) {
  const struct {
    const char* name;
    double y, value;
  } rows[] = {
      {"priest1920", 25, 5},
      {"munsell1933", 100, 9.999499987499375},
      {"moon1943", 19.77, 4.991451743742128},
      {"saunderson1944", 100, 9.918249948821197},
      {"ladd1955", 50.775182993407995, 7.502936388898068},
      {"mccamy1987", 38.190380946728794, 6.725296544005446},
      {"mccamy1987", 0.5, 0.4382262468932231},
  };
  for (const auto& row : rows) {
    const auto* function = find_by_name(kMunsellValueFunctions, row.name);
    EXPECT_NEAR(function->value_from_luminance(row.y / 100), row.value, 4e-15 * row.value)
        << row.name;
  }
}

TEST(MunsellValue, OfTheQuinticComesBack) {
  for (int i = 0; i <= 100000; ++i) {
    const double value = i / 10000.0;
    // Largest error measured: 3.6e-15.
    ASSERT_NEAR(munsell_value_from_luminance(luminance_from_munsell_value(value)), value, 1e-14);
  }
  for (double value = 1e-300; value < 1; value *= 10) {
    ASSERT_NEAR(munsell_value_from_luminance(luminance_from_munsell_value(value)), value,
                1e-15 * value);
  }
}

TEST(MunsellValue, HasBlackAndWhiteExactly) {
  EXPECT_EQ(luminance_from_munsell_value(0), 0);
  EXPECT_EQ(luminance_from_munsell_value(10), 1);
  EXPECT_EQ(munsell_value_from_luminance(0), 0);
  EXPECT_EQ(munsell_value_from_luminance(1), 10);
  EXPECT_EQ(munsell_value_from_luminance(1 + 1e-13), 10);
}

TEST(MunsellValue, HasNoneOutside) {
  for (const double luminance : {-1e-9, 1.001, std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    EXPECT_TRUE(std::isnan(munsell_value_from_luminance(luminance))) << luminance;
  }
  for (const double value : {-0.1, 10.01, std::nan(""), HUGE_VAL}) {
    EXPECT_TRUE(std::isnan(luminance_from_munsell_value(value))) << value;
  }
}

}  // namespace
}  // namespace tristim
