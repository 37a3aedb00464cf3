#include "tristim/light/highlight_match.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/light/fisher_woo.h"

namespace tristim {
namespace {

TEST(ExponentConversion, GoesThereAndBack) {
  EXPECT_EQ(blinn_exponent(10), 40);
  EXPECT_EQ(blinn_exponent(10, 2.5), 25);
  EXPECT_EQ(phong_exponent(40), 10);
  EXPECT_EQ(beckmann_roughness(0), 1);
  EXPECT_EQ(beckmann_roughness(198), 0.1);
  EXPECT_EQ(blinn_exponent_of_roughness(0.5), 6);
  EXPECT_EQ(blinn_exponent_of_roughness(3), 0);
  for (const double n : {0.0, 1.0, 12.5, 4000.0}) {
    EXPECT_NEAR(blinn_exponent_of_roughness(beckmann_roughness(n)), n, 1e-15 * (n + 2) * 2);
  }
}

TEST(ExponentConversion, RefusesWhatIsNoExponent) {
  const double nan = std::nan("");
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {-1.0, nan, infinity}) {
    EXPECT_THROW(blinn_exponent(bad), std::invalid_argument);
    EXPECT_THROW(phong_exponent(bad), std::invalid_argument);
    EXPECT_THROW(beckmann_roughness(bad), std::invalid_argument);
    EXPECT_THROW(blinn_exponent_of_roughness(bad), std::invalid_argument);
    EXPECT_THROW(highlight_errors(bad, 4, 90), std::invalid_argument);
    EXPECT_THROW(highlight_errors(4, bad, 90), std::invalid_argument);
    EXPECT_THROW(minimax_factor(bad, 90), std::invalid_argument);
  }
  EXPECT_THROW(phong_exponent(4, 0), std::invalid_argument);
  EXPECT_THROW(near_eye_extreme(10, 4, 90, 1), std::invalid_argument);
}

TEST(ExponentConversion, AgreesWithTheExamples) {
  if (!shared_dir()) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row :
       example_rows(*shared_dir() / "spec/shade-examples/exponent_conversion.csv")) {
    SCOPED_TRACE(row.text("id"));
    const double r = row.number("in_phong_r");
    const double n4 = blinn_exponent(r);
    const double n_minimax = blinn_exponent(r, minimax_factor_limit(row.number("in_LE_deg")));
    const auto expect = [&](double value, const char* column) {
      EXPECT_NEAR(value, row.number(column), 1e-15 * value) << column;
    };
    expect(n4, "out_blinn_n_f4");
    expect(n_minimax, "out_blinn_n_minimax_4cosbeta");
    expect(beckmann_roughness(n4), "out_beckmann_m_of_n_f4");
    expect(beckmann_roughness(n_minimax), "out_beckmann_m_of_n_minimax");
    expect(blinn_normalisation(n4), "out_blinn_D_norm");
    expect(phong_normalisation(r), "out_phong_lobe_norm");
  }
}

TEST(HighlightErrors, AreTheEndsOverAllNormals) {
  for (const double le : {0.0, 40.0, 90.0, 150.0}) {
    for (const double r : {2.0, 10.0}) {
      const ErrorRange range = highlight_errors(r, 4, le);
      double least = 0;
      double greatest = 0;
      for (int theta = 0; theta <= 180; ++theta) {
        for (int phi = 0; phi <= 180; ++phi) {
          const double error = pixel_error(highlight_frame(theta, phi, le), r, 4);
          least = std::min(least, error);
          greatest = std::max(greatest, error);
        }
      }
      SCOPED_TRACE(testing::Message() << "r " << r << ", [L,E] " << le);
      EXPECT_LE(range.least, least + 1e-12);
      EXPECT_NEAR(range.least, least, 0.1);  // the grid misses the peak by half a degree
      EXPECT_GE(range.greatest, greatest - 1e-12);
      EXPECT_NEAR(range.greatest, greatest, 0.1);
    }
  }
}

// [FisherWoo] of exponents below 5: "from 10 to greater than 60"; above 45: below 1.
TEST(HighlightErrors, CoplanarOnesAreAsThePaperSays) {
  EXPECT_NEAR(highlight_errors(1, 4, 0).least, -63.75, 1e-12);
  EXPECT_NEAR(highlight_errors(4, 4, 0).least, -9.86, 0.005);
  EXPECT_NEAR(highlight_errors(45, 4, 0).least, -0.776, 0.0005);
}

// At [L,E] = 90 degrees the greatest error is 255/4 for every exponent.
TEST(HighlightErrors, AreAQuarterAtNinetyDegrees) {
  for (const double r : {0.5, 1.0, 10.0, 300.0, 1000.0}) {
    EXPECT_NEAR(highlight_errors(r, 4, 90).greatest, 63.75, 2e-10) << r;
  }
}

TEST(HighlightErrors, GreatestMovesToTheHighlightAsTheExponentGrows) {
  double last = 0;
  for (const double r : {5.0, 10.0, 40.0, 200.0}) {
    const double n_dot_h = highlight_errors(r, 4, 90).greatest_n_dot_h;
    EXPECT_GT(n_dot_h, last);
    last = n_dot_h;
  }
  EXPECT_LT(last, 1);
}

TEST(LimitError, IsWhatLargeExponentsTendTo) {
  for (const double le : {10.0, 30.0, 90.0, 120.0, 170.0}) {
    const double limit = limit_error(le);
    EXPECT_NEAR(highlight_errors(1e5, 4, le).greatest, limit, 0.001 * limit) << le;
  }
  EXPECT_EQ(limit_error(0), 0);
  EXPECT_EQ(limit_error(180), 255);
  EXPECT_NEAR(limit_error(90), 63.75, 1e-13);
}

TEST(MinimaxFactor, HalvesTheWorstErrorAtNinetyDegrees) {
  EXPECT_NEAR(minimax_factor_limit(90), 2.8284271247461901, 1e-15);
  const ErrorRange errors = highlight_errors(1e5, minimax_factor_limit(90), 90);
  EXPECT_NEAR(errors.greatest, 32.35, 0.005);
  EXPECT_NEAR(minimax_limit_error(90), errors.greatest, 0.001);
  EXPECT_NEAR(-errors.least, 32.35, 0.005);
  EXPECT_EQ(minimax_factor_limit(180), 0);
}

TEST(MinimaxFactor, LeavesBothEndsEqualAndNeighboursWorse) {
  for (const double r : {2.0, 10.0, 100.0}) {
    for (const double le : {0.0, 60.0, 130.0}) {
      SCOPED_TRACE(testing::Message() << "r " << r << ", [L,E] " << le);
      const double f = minimax_factor(r, le);
      const ErrorRange best = highlight_errors(r, f, le);
      EXPECT_NEAR(best.greatest, -best.least, 1e-9);
      for (const double other : {0.99 * f, 1.01 * f}) {
        EXPECT_GT(std::fabs(highlight_errors(r, other, le).extreme()), best.greatest);
      }
    }
  }
  EXPECT_EQ(minimax_factor(10, 180), 0);
  EXPECT_NEAR(minimax_factor(1e4, 60), minimax_factor_limit(60), 1e-3);
}

// Where [L,E] and r are small, 4 is nearer to the best factor than 4 cos beta.
TEST(MinimaxFactor, IsAboveFourForSmallAnglesAndExponents) {
  EXPECT_GT(minimax_factor(5, 0), 4.2);
  EXPECT_GT(minimax_factor(5, 30), 4.1);
  const double limit = minimax_factor_limit(30);
  EXPECT_GT(std::fabs(highlight_errors(5, limit, 30).extreme()),
            std::fabs(highlight_errors(5, 4, 30).extreme()));
}

TEST(BeckmannMatch, ShrinksAsTheExponentGrows) {
  const ErrorRange broad = beckmann_match_errors(10);
  EXPECT_NEAR(broad.least, -6.91, 0.005);  // by golden section in another program
  EXPECT_NEAR(broad.greatest, 11.06, 0.005);
  const ErrorRange narrow = beckmann_match_errors(1000);
  EXPECT_LT(narrow.extreme(), 0.12);
  EXPECT_GT(narrow.extreme(), 0.11);
}

// [FisherWoo]: below 10 for exponents of 40 and [L,E] below 120, and of 180 and 140.
TEST(ErrorStatistics, AreAsThePaperSays) {
  const ErrorStatistics wide = highlight_error_statistics(40, 4, 120);
  EXPECT_NEAR(wide.standard_deviation, 7.8, 0.05);
  EXPECT_NEAR(wide.mean, 0, 2);
  EXPECT_NEAR(highlight_error_statistics(180, 4, 140).standard_deviation, 6.0, 0.05);
}

struct EyeRow {
  double distance, error;
};

// Nearer than about 5 radii the error is no longer that of the eye at infinity.
TEST(NearEye, ErrorGrowsAsTheEyeComesNearer) {
  constexpr EyeRow kRows[] = {{1e9, 63.8}, {50, 65.0}, {10, 70.4}, {5, 78.0},
                              {3, 90},     {2, 109},   {1.5, 135}};
  for (const auto& [distance, error] : kRows) {
    // The digits that are known, and the search's 1e-3.
    EXPECT_NEAR(near_eye_extreme(10, 4, 90, distance), error, error < 80 ? 0.051 : 0.51);
  }
}

}  // namespace
}  // namespace tristim
