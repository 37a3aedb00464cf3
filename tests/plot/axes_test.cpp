#include "tristim/plot/axes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/error_text.h"
#include "tests/plot/svg_reader.h"

namespace tristim {
namespace {

TEST(PlotAxes, PlacesPointsInTheFrame) {
  SvgDrawing svg(300, 200, "");
  const PlotAxes axes(svg, {50, 20}, 200, 100, {.from = 0, .to = 2}, {.from = -1, .to = 1});
  EXPECT_EQ(axes.at({0, 1}), (SvgPoint{50, 20}));
  EXPECT_EQ(axes.at({2, -1}), (SvgPoint{250, 120}));
  EXPECT_EQ(axes.at({1, 0}), (SvgPoint{150, 70}));
  EXPECT_EQ(axes.at({4, 0}), (SvgPoint{450, 70}));
  EXPECT_EQ(axes.point({450, 70}), (PlotPoint{4, 0}));
}

TEST(PlotAxes, NumbersAndNamesItsAxes) {
  SvgDrawing svg(300, 200, "");
  const PlotAxes axes(svg, {50, 20}, 200, 100, {.from = 0, .to = 1, .title = "angle", .step = 0.25},
                      {.from = 0, .to = 100, .title = "y", .italic = true});
  axes.grid();
  axes.frame();
  const std::string text = svg.document();
  EXPECT_EQ(xml_complaint(text), "");
  for (const char* part : {">0.00<", ">0.25<", ">1.00<", ">angle<", ">0<", ">20<", ">100<",
                           "font-style=\"italic\" transform=\"rotate(-90 6 70)\">y<"}) {
    EXPECT_EQ(count_of(text, part), 1U) << part << text;
  }
  EXPECT_EQ(count_of(text, "<line"), 2U * (5 + 6));  // gridlines and ticks
}

TEST(PlotAxes, ClipsCurvesToTheFrame) {
  SvgDrawing svg(300, 200, "");
  const PlotAxes axes(svg, {50, 20}, 200, 100, {}, {});
  const PlotPoint line[] = {{0, 0}, {0.5, 7}, {0.6, std::nan("")}, {0.7, 1}, {1, 1}};
  axes.curve(line, {"#c00", 1.5});
  const std::string text = svg.document();
  EXPECT_NE(text.find("<polygon points=\"50,20 250,20 250,120 50,120\"/>"), text.npos);
  EXPECT_EQ(count_of(text, "<polyline"), 2U);
}

TEST(PlotAxes, ListsKeysInACorner) {
  for (const PlotCorner corner : {PlotCorner::kTopLeft, PlotCorner::kTopRight,
                                  PlotCorner::kBottomLeft, PlotCorner::kBottomRight}) {
    SvgDrawing svg(300, 200, "");
    const PlotAxes axes(svg, {50, 20}, 200, 100, {}, {});
    const PlotKey keys[] = {{.text = "n = 1", .stroke = {"#c00", 2}},
                            {.text = "a <colour>", .fill = "#fff"}};
    const PlotBox box = axes.legend(keys, corner);
    EXPECT_GT(box.corner.x, 50);
    EXPECT_GT(box.corner.y, 20);
    EXPECT_LT(box.corner.x + box.width, 250);
    EXPECT_LT(box.corner.y + box.height, 120);
    const std::string text = svg.document();
    EXPECT_EQ(xml_complaint(text), "");
    EXPECT_EQ(count_of(text, ">n = 1<"), 1U);
    EXPECT_EQ(count_of(text, ">a &lt;colour&gt;<"), 1U);
    EXPECT_EQ(count_of(text, "<line"), 1U);
    EXPECT_EQ(count_of(text, "<circle"), 1U);
  }
}

TEST(PlotAxes, RefusesAnAxisWithoutRange) {
  SvgDrawing svg(10, 10, "");
  const double inf = std::numeric_limits<double>::infinity();
  const char* text = "invalid: axis: must go from a finite number to a greater one";
  for (const PlotAxis& axis : {PlotAxis{1, 1}, PlotAxis{2, 1}, PlotAxis{0, std::nan("")},
                               PlotAxis{0, inf}, PlotAxis{-inf, 0}}) {
    EXPECT_EQ(error_text([&] { PlotAxes(svg, {}, 1, 1, axis, {}); }), text);
    EXPECT_EQ(error_text([&] { PlotAxes(svg, {}, 1, 1, {}, axis); }), text);
  }
}

TEST(NiceStep, IsOneTwoOrFive) {
  EXPECT_NEAR(nice_step(1, 6), 0.2, 1e-15);
  EXPECT_NEAR(nice_step(0.85, 8), 0.1, 1e-15);
  EXPECT_NEAR(nice_step(100, 2), 50, 1e-12);
  EXPECT_NEAR(nice_step(7e9, 6), 1e9, 1);
  EXPECT_NEAR(nice_step(3e-7, 6), 5e-8, 1e-20);
}

TEST(AxisTicks, AreTheMultiplesWithin) {
  EXPECT_EQ(axis_ticks(0, 0.3, 0.1).size(), 4U);
  EXPECT_EQ(axis_ticks(-0.25, 0.25, 0.1).size(), 5U);
  EXPECT_EQ(axis_ticks(380, 700, 20).front(), 380);
  EXPECT_EQ(axis_ticks(0.01, 0.02, 1).size(), 0U);
}

}  // namespace
}  // namespace tristim
