#include "tristim/dither/spot.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/error_text.h"

namespace tristim {
namespace {

TEST(Spot, EveryFunctionIsFiniteAndEvenAndFallsFromTheMiddle) {
  for (const SpotFunction& spot : kSpotFunctions) {
    SCOPED_TRACE(spot.name);
    EXPECT_NO_THROW(check_spot(spot));
    for (double x = -1; x <= 1; x += 0.125) {
      for (double y = -1; y <= 1; y += 0.125) {
        const double value = spot.value(x, y);
        EXPECT_EQ(value, spot.value(-x, y));
        EXPECT_EQ(value, spot.value(x, -y));
        EXPECT_LE(value, spot.value(0, 0));
        EXPECT_GE(value, spot.value(1, 1));
      }
    }
    const SpotCentres centres = spot_centres(spot);
    EXPECT_EQ(centres.dot_x, 0);
    EXPECT_EQ(centres.dot_y, 0);
    EXPECT_EQ(std::fabs(centres.hole_x), 1);
    EXPECT_EQ(std::fabs(centres.hole_y), 1);
  }
}

TEST(Spot, HasTheShapesOfItsNames) {
  EXPECT_EQ(round_spot(0.6, 0), round_spot(0.36, 0.48));             // one distance
  EXPECT_EQ(euclidean_spot(0.25, 0.5), -euclidean_spot(0.75, 0.5));  // holes are dots, turned
  EXPECT_GT(ellipse_spot(0.5, 0), ellipse_spot(0, 0.5));             // longer along x
  EXPECT_EQ(line_spot(0.9, 0.3), line_spot(-0.2, 0.3));              // the same all along x
  EXPECT_GT(diamond_spot(0.99, 0), diamond_spot(0, 0.99));           // joins along x first
  EXPECT_EQ(square_spot(0.5, 0.1), square_spot(0.2, -0.5));          // one half side
}

TEST(Spot, FormulaAndFunctionAgree) {
  const Formula formula("(cos(pi*x) + cos(pi*y))/2");
  for (double x = -1; x <= 1; x += 0.1) {
    EXPECT_NEAR(spot_value(formula, x, 0.3), cosine_spot(x, 0.3), 1e-15);
  }
}

TEST(Spot, PictureIsInterpolatedAndRepeats) {
  const SpotPicture picture{"cell", 2, 2, {0, 1, 2, 3}};
  EXPECT_EQ(spot_value(picture, -0.5, 0.5), 0);
  EXPECT_EQ(spot_value(picture, 0.5, 0.5), 1);
  EXPECT_EQ(spot_value(picture, -0.5, -0.5), 2);
  EXPECT_EQ(spot_value(picture, 0, 0), 1.5);
  EXPECT_EQ(spot_value(picture, -1, 0.5), 0.5);  // half way to the neighbour cell's last column
  EXPECT_EQ(spot_value(picture, 1, 0.5), 0.5);
}

TEST(Spot, RefusesWhatIsNotFinite) {
  const auto error = [](const char* text) {
    return error_text([&] { check_spot(Formula(text)); });
  };
  EXPECT_EQ(error("1/x"),
            "invalid: spot '1/x' is inf at x = 0, y = -1, expected a number in all of the cell");
  EXPECT_EQ(
      error("log(x)"),
      "invalid: spot 'log(x)' is nan at x = -1, y = -1, expected a number in all of the cell");
  EXPECT_EQ(error("3"), "invalid: spot '3' is 3 everywhere: no dot can grow");
  EXPECT_EQ(error("cos(pi*x) + cos(pi*y)"), "");
}

}  // namespace
}  // namespace tristim
