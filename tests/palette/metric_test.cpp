#include "tristim/palette/metric.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tristim/color/oklab.h"
#include "tristim/color/transfer.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

void expect_place(std::string_view metric, Rgb color, double a, double b, double c,
                  double tolerance) {
  SCOPED_TRACE(metric);
  const auto place = find_by_name(kMetrics, metric)->place(color);
  EXPECT_NEAR(place[0], a, tolerance);
  EXPECT_NEAR(place[1], b, tolerance);
  EXPECT_NEAR(place[2], c, tolerance);
}

TEST(Metrics, PlaceRedWhereTheirSpaceHasIt) {
  const Rgb red{1, 0, 0};
  expect_place("oklab", red, 0.62796, 0.22486, 0.12585, 1e-5);  // [CSS4]
  expect_place("lab", red, 53.24, 80.09, 67.20, 0.01);          // D65, 2 decimals
  expect_place("luv", red, 53.24, 175.01, 37.75, 0.02);         // D65, 2 decimals
  expect_place("linear", red, 1, 0, 0, 0);
  expect_place("encoded", red, 1, 0, 0, 0);
}

TEST(Metrics, PlaceGreysOnTheNeutralAxis) {
  for (const std::string_view name : {"oklab", "oklab-toe", "lab", "luv"}) {
    for (const double grey : {0.0, 0.01, 0.2, 1.0}) {
      const auto place = find_by_name(kMetrics, name)->place({grey, grey, grey});
      EXPECT_NEAR(place[1], 0, 1e-6) << name;
      EXPECT_NEAR(place[2], 0, 1e-6) << name;
    }
  }
}

TEST(Metrics, EncodedIsTheSrgbCurveClipped) {
  expect_place("encoded", {0.2159, -1, 7}, srgb_encode(0.2159), 0, 1, 1e-5);
}

// The toe takes the infinite slope at black away.
TEST(Metrics, OklabToeIsLessSteepAtBlack) {
  const auto lightness = [](std::string_view name, double v) {
    return find_by_name(kMetrics, name)->place({v, v, v})[0];
  };
  EXPECT_LT(lightness("oklab-toe", 1e-3), 0.1 * lightness("oklab", 1e-3));
  EXPECT_NEAR(lightness("oklab-toe", 1e-3), 10 * lightness("oklab-toe", 1e-4), 1e-5);
  EXPECT_NEAR(lightness("oklab-toe", -1e-4), -lightness("oklab-toe", 1e-4), 1e-6);
}

TEST(Metrics, SeparateColoursThatDiffer) {
  for (const Metric& metric : kMetrics) {
    EXPECT_NE(metric.place({0.5, 0.5, 0.5}), metric.place({0.5, 0.5, 0.6})) << metric.name;
    EXPECT_NE(metric.place({0.5, 0.5, 0.5}), metric.place({0.6, 0.5, 0.5})) << metric.name;
  }
}

TEST(Metric, PlacesRowsAsColours) {
  std::vector<float> pixels;
  std::uint32_t state = 1;
  for (int i = 0; i < 3 * 1000; ++i) {
    state = state * 1664525 + 1013904223;
    pixels.push_back(static_cast<float>(state >> 8) / 0x1p24F);
  }
  for (const Metric& metric : kMetrics) {
    std::vector<float> places = pixels;
    place_row(metric, places);
    for (std::size_t i = 0; i < pixels.size(); i += 3) {
      const auto place = metric.place({pixels[i], pixels[i + 1], pixels[i + 2]});
      for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(places[i + c], place[c], 1e-6) << metric.name;
    }
  }
}

}  // namespace
}  // namespace tristim
