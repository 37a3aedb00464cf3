#include "tristim/palette/hull.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace tristim {
namespace {

using Color = PaletteHull::Color;
using Colors = std::vector<Color>;

const Colors kCube{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                   {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
const Colors kTetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

float unit() { return static_cast<float>(*rc::gen::inRange(0, 10001)) / 10000.0F; }
Color any_color() { return {unit(), unit(), unit()}; }

double luminance(const Color& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

// A convex mixture of the entries with every weight above 0.
Color mixture(const Colors& entries) {
  std::vector<double> weights;
  double sum = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    weights.push_back(*rc::gen::inRange(20, 1000));
    sum += weights.back();
  }
  Color mixed{};
  for (std::size_t c = 0; c < 3; ++c) {
    double value = 0;
    for (std::size_t i = 0; i < entries.size(); ++i) value += weights[i] / sum * entries[i][c];
    mixed[c] = static_cast<float>(value);
  }
  return mixed;
}

TEST(PaletteHull, LeavesTheCubeAlone) {
  const PaletteHull hull(kCube);
  for (const Color& corner : kCube) EXPECT_EQ(hull.inside(corner), corner);
  EXPECT_EQ(hull.inside({0.3F, 0.9F, 0.1F}), (Color{0.3F, 0.9F, 0.1F}));
}

// On the plane r + g + b = 1, on the way to the grey of the same luminance.
TEST(PaletteHull, MovesAColourToTheFirstPointInsideOnTheWayToGrey) {
  const PaletteHull hull(kTetrahedron);
  const Color wanted{0.9F, 0.2F, 0.3F};  // luminance .356: grey is outside too, as 3 x .356 > 1
  const Color moved = hull.inside(wanted);
  EXPECT_NEAR(moved[0] + moved[1] + moved[2], 1, 1e-6);
  const Color dark{0.9F, 0.05F, 0.15F};  // luminance .238: its grey is inside
  const Color kept = hull.inside(dark);
  EXPECT_NEAR(kept[0] + kept[1] + kept[2], 1, 1e-6);
  EXPECT_NEAR(luminance(kept), luminance(dark), 1e-6);
}

RC_GTEST_PROP(PaletteHull, LeavesMixturesUntouched, ()) {
  Colors entries;
  const int count = *rc::gen::inRange(4, 20);
  for (int i = 0; i < count; ++i) entries.push_back(any_color());
  const PaletteHull hull(entries);
  const Color color = mixture(entries);
  const Color same = hull.inside(color);
  for (std::size_t c = 0; c < 3; ++c) RC_ASSERT(std::fabs(same[c] - color[c]) <= 1e-5F);
}

// Whether one of many directions separates `color` from the entries by more than `slack`.
bool separated(const Colors& entries, const Color& color, double slack) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 2000; ++i) {
    double d[3] = {normal(random), normal(random), normal(random)};
    const double length = std::hypot(d[0], d[1], d[2]);
    const auto height = [&](const Color& c) {
      return (d[0] * c[0] + d[1] * c[1] + d[2] * c[2]) / length;
    };
    double highest = -10;
    for (const Color& entry : entries) highest = std::max(highest, height(entry));
    if (height(color) > highest + slack) return true;
  }
  return false;
}

RC_GTEST_PROP(PaletteHull, BringsEveryColourInside, ()) {
  Colors entries = kTetrahedron;  // so that the hull has a volume
  const int count = *rc::gen::inRange(0, 16);
  for (int i = 0; i < count; ++i) entries.push_back(any_color());
  const Color color = any_color();
  const Color moved = PaletteHull(entries).inside(color);
  RC_ASSERT(!separated(entries, moved, 1e-6));
}

TEST(PaletteHull, MovesRowsAsItMovesColours) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> any(-0.2F, 1.2F);
  const Colors inks{{0.04F, 0.03F, 0.04F},
                    {0.9F, 0.9F, 0.9F},
                    {0.04F, 0.1F, 0.06F},
                    {0.3F, 0.06F, 0.07F},
                    {0.6F, 0.5F, 0.06F}};
  const Colors greys{{0, 0, 0}, {1, 1, 1}};
  for (const Colors& entries : {kCube, kTetrahedron, inks, greys, Colors{}}) {
    const PaletteHull hull(entries);
    for (const std::size_t count : {std::size_t{1}, std::size_t{16}, std::size_t{77}}) {
      std::array<std::vector<float>, 3> planes;
      Colors expected;
      for (std::size_t i = 0; i < count; ++i) {
        const float r = any(random);
        const float g = any(random);
        const Color color{r, g, any(random)};
        for (std::size_t c = 0; c < 3; ++c) planes[c].push_back(color[c]);
        expected.push_back(hull.inside(color));
      }
      hull.inside_row({planes[0].data(), planes[1].data(), planes[2].data()}, count);
      for (std::size_t i = 0; i < count; ++i) {
        EXPECT_EQ((Color{planes[0][i], planes[1][i], planes[2][i]}), expected[i]);
      }
    }
  }
}

TEST(PaletteHull, OfOneColourLeavesEverythingAlone) {
  const Color color{0.9F, 0.1F, 0.4F};
  for (const Colors& entries : {Colors{}, Colors{{0.5F, 0.5F, 0.5F}}, Colors(4, {1, 0, 0})}) {
    EXPECT_EQ(PaletteHull(entries).inside(color), color);
  }
}

TEST(PaletteHull, OfGreysBringsColoursToTheGreyOfTheirLuminance) {
  const Colors greys{{0, 0, 0}, {1, 1, 1}, {0.5F, 0.5F, 0.5F}, {0.2F, 0.2F, 0.2F}};
  const Color color{0.9F, 0.1F, 0.4F};
  const Color moved = PaletteHull(greys).inside(color);
  for (const float c : moved) EXPECT_NEAR(c, luminance(color), 1e-6);
}

TEST(PaletteHull, OfBlackWhiteAndRedBringsColoursToTheirPlaneAtTheSameLuminance) {
  const PaletteHull hull(Colors{{0, 0, 0}, {1, 1, 1}, {1, 0, 0}});
  const Color mixable{0.7F, 0.3F, 0.3F};
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(hull.inside(mixable)[c], mixable[c], 1e-6);
  const Color blue{0.1F, 0.2F, 0.9F};
  const Color moved = hull.inside(blue);
  EXPECT_NEAR(luminance(moved), luminance(blue), 1e-6);
  EXPECT_NEAR(moved[1], moved[2], 1e-6);  // on the plane
  EXPECT_GE(moved[0], moved[1] - 1e-6);   // on the red side of grey
}

TEST(PaletteHull, TakesRepeatedEntries) {
  Colors twice = kTetrahedron;
  twice.insert(twice.end(), kTetrahedron.begin(), kTetrahedron.end());
  const Color outside{0.9F, 0.8F, 0.7F};
  EXPECT_EQ(PaletteHull(twice).inside(outside), PaletteHull(kTetrahedron).inside(outside));
}

TEST(PaletteHull, LeavesEverythingAloneForLargePalettes) {
  Colors many(PaletteHull::kMost + 1, Color{0.5F, 0.5F, 0.5F});
  many[0] = {0, 0, 0};
  EXPECT_EQ(PaletteHull(many).inside({1, 0, 0}), (Color{1, 0, 0}));
}

}  // namespace
}  // namespace tristim
