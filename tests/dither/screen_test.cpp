#include "tristim/dither/screen.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/error_text.h"
#include "tristim/color/lab.h"
#include "tristim/color/transfer.h"
#include "tristim/dither/ordered.h"
#include "tristim/dither/screen_recipe.h"

namespace tristim {
namespace {

double angle_off(double a, double b) {
  const double off = std::fabs(std::fmod(std::fmod(a - b, 360) + 360, 360));
  return std::min(off, 360 - off);
}

int rank_at(const ThresholdMatrix& m, int x, int y) {
  return m.row(y)[(m.column(y) + x) % m.width];
}

Screen random_screen() {
  Screen screen;
  screen.dpi = *rc::gen::inRange(100, 5000);
  const double side = 2 + *rc::gen::inRange(0, 30000) / 1000.0;
  screen.lpi = screen.dpi / side;
  screen.angle_deg = *rc::gen::inRange(-36000, 72000) / 100.0;
  screen.spot = *rc::gen::elementOf(
      std::vector<SpotFunction>(std::begin(kSpotFunctions), std::end(kSpotFunctions)));
  return screen;
}

RC_GTEST_PROP(Screen, ReachesTheAngleAndTheRuling, ()) {
  const Screen screen = random_screen();
  const ReachedScreen reached = reach(screen);
  RC_ASSERT(angle_off(reached.angle_deg, screen.angle_deg) <= 0.05 + 1e-12);
  RC_ASSERT(std::fabs(reached.lpi / screen.lpi - 1) < 0.02);
  RC_ASSERT(std::hypot(reached.a, reached.b) <= 640 + screen.dpi / screen.lpi + 1);
}

RC_GTEST_PROP(Screen, HoldsEveryRankEquallyOften, ()) {
  const ThresholdMatrix m = screen_matrix(random_screen());
  std::vector<int> count(static_cast<std::size_t>(m.ranks), 0);
  for (const std::uint16_t rank : m.rank) ++count[rank];
  const auto [least, most] = std::ranges::minmax(count);
  RC_ASSERT(m.ranks == std::min(m.width * m.height, 65536));
  RC_ASSERT(most - least <= 1);
  RC_ASSERT(least >= 1);
}

// The page repeats along the two sides of the screen's square, wherever one stands.
RC_GTEST_PROP(Screen, TilesThePageWithoutSeams, ()) {
  const Screen screen = random_screen();
  const ReachedScreen s = reach(screen);
  const ThresholdMatrix m = screen_matrix(screen);
  const int x = *rc::gen::inRange(1000, 5000);
  const int y = *rc::gen::inRange(1000, 5000);
  RC_ASSERT(rank_at(m, x, y) == rank_at(m, x + s.a, y - s.b));
  RC_ASSERT(rank_at(m, x, y) == rank_at(m, x + s.b, y + s.a));
}

// Inked dots of each cell of a tile of whole cells, at a tone.
std::vector<int> inked_by_cell(const ThresholdMatrix& m, int side, int cells, double tone) {
  std::vector<int> inked(static_cast<std::size_t>(cells * cells), 0);
  const int lit = static_cast<int>(tone * m.ranks + 0.5);
  for (int y = 0; y < side * cells; ++y) {
    for (int x = 0; x < side * cells; ++x) {
      if (lit > rank_at(m, x, y)) continue;
      ++inked[static_cast<std::size_t>(y / side * cells + x / side)];
    }
  }
  return inked;
}

TEST(Screen, CellsAreInkedAlike) {
  for (const SpotFunction& spot : kSpotFunctions) {
    SCOPED_TRACE(spot.name);
    const ThresholdMatrix m = screen_matrix({.dpi = 800, .lpi = 100, .angle_deg = 0, .spot = spot});
    for (double tone = 0.5; tone <= 1; tone += 0.013) {
      const std::vector<int> inked = inked_by_cell(m, 8, 8, tone);
      const auto [least, most] = std::ranges::minmax(inked);
      EXPECT_LE(most - least, 1) << tone;
    }
  }
}

TEST(Screen, RoundDotsAreRound) {
  // A dot of 12 % in a cell of 40 dots has a radius of 7.8; no pixel is off by more than one.
  const ThresholdMatrix m =
      screen_matrix({.dpi = 4000, .lpi = 100, .angle_deg = 0, .spot = kSpotFunctions[0]});
  const double tone = 0.88;
  const int lit = static_cast<int>(tone * m.ranks + 0.5);
  const double radius = std::sqrt(1600 * (1 - tone) / 3.14159265);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      const double distance = std::hypot(x + 0.5 - 20, y + 0.5 - 20);
      const bool inked = lit <= rank_at(m, x, y);
      const bool inside = distance < radius;
      if (std::fabs(distance - radius) > 1) {
        EXPECT_EQ(inked, inside) << x << " " << y;
      }
    }
  }
}

TEST(Screen, TurnsCounterclockwise) {
  // Lines at 30 degrees rise to the right: half a cell up along them the tone is the same.
  const ThresholdMatrix m = screen_matrix(
      {.dpi = 1000,
       .lpi = 50,
       .angle_deg = 30,
       .spot = *std::ranges::find(kSpotFunctions, std::string_view("line"), &SpotFunction::name)});
  int along = 0;
  int across = 0;
  const int lit = m.ranks / 2;
  for (int y = 200; y < 400; ++y) {
    for (int x = 200; x < 400; ++x) {
      const bool here = lit > rank_at(m, x, y);
      if ((lit > rank_at(m, x + 87, y - 50)) == here) ++along;
      if ((lit > rank_at(m, x + 87, y + 50)) == here) ++across;
    }
  }
  EXPECT_GT(along, 38000);
  EXPECT_LT(across, 30000);
}

// Of whole tiles: a patch that cuts through lines has more of them or less, whatever the screen.
double tone_error(const ThresholdMatrix& matrix, double light) {
  const OrderedDither dither({{0, 1}, {0, 1}}, matrix);
  const int width = matrix.width;
  const std::vector<float> in(static_cast<std::size_t>(width), static_cast<float>(light));
  std::vector<std::uint16_t> out(in.size());
  long long lit = 0;
  for (int y = 0; y < matrix.height; ++y) {
    dither.row({in.data(), width, 1}, y, {out.data(), width, 1});
    lit += std::ranges::count(out, 1);
  }
  const double got = static_cast<double>(lit) / (double{1} * width * matrix.height);
  return lstar_from_luminance(got) - lstar_from_luminance(light);
}

TEST(Screen, GivesBackTheToneOfPatches) {
  double worst = 0;
  for (const SpotFunction& spot : kSpotFunctions) {
    for (const double angle : {0.0, 15.0, 45.0, 71.3}) {
      for (const ScreenRecipe& recipe : kScreenRecipes) {
        const Screen screen =
            screen_of(recipe, {.dpi = 600, .lpi = 85, .angles_deg = {angle}, .spot = spot}, 0, 1);
        const ThresholdMatrix matrix = screen_matrix(screen);
        for (int k = 0; k <= 16; ++k) {
          worst = std::max(worst, std::fabs(tone_error(matrix, srgb_decode(k / 16.0))));
        }
      }
    }
  }
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LE(worst, 0.15);
}

TEST(Screen, HybridDotsAreNeverSmallerThanAsked) {
  const Screen screen{.dpi = 800, .lpi = 100, .angle_deg = 0, .smallest_dot = 6};
  const ThresholdMatrix m = screen_matrix(screen);
  for (double tone = 0.985; tone >= 0.92; tone -= 0.005) {
    int partial = 0;
    for (const int inked : inked_by_cell(m, 8, 8, tone)) {
      if (inked > 0 && inked < 6) ++partial;
    }
    EXPECT_LE(partial, 1) << tone;  // the one that is just coming
  }
}

TEST(Screen, SingleCellHasWholeDots) {
  const ReachedScreen s = reach({.dpi = 600, .lpi = 85, .angle_deg = 15, .single_cell = true});
  EXPECT_EQ(s.a, 7);
  EXPECT_EQ(s.b, 2);
  EXPECT_EQ(s.cells, 1);
  EXPECT_NEAR(s.angle_deg, 15.945, 1e-3);
  EXPECT_NEAR(s.lpi, 82.416, 1e-3);
}

TEST(Screen, SaysWhichRulingsArePossible) {
  const auto error = [](const Screen& screen) { return error_text([&] { reach(screen); }); };
  EXPECT_EQ(
      error({.dpi = 300, .lpi = 200}),
      "invalid: screen: 300 dpi cannot hold a ruling of 200 lpi; possible are 0.3 to 150 lpi, "
      "cells of 1000 to 2 dots");
  EXPECT_EQ(error({.dpi = 300, .lpi = 0}).substr(0, 48),
            "invalid: screen: 300 dpi cannot hold a ruling of");
  EXPECT_EQ(error({.dpi = 0}), "invalid: screen: a resolution of 0 dpi, expected above 0");
  EXPECT_EQ(error({.angle_deg = std::nan("")}),
            "invalid: screen: an angle of nan degrees, expected a number");
  EXPECT_EQ(
      error_text([] { screen_matrix({.dpi = 600, .lpi = 100, .smallest_dot = 10}); }),
      "invalid: screen: a smallest dot of 10 device dots, expected 1 to 8, a quarter of a cell");
  EXPECT_EQ(error_text([] {
              screen_matrices(kScreenRecipes[0], {.angles_deg = {1, 2}}, 3);
            }),
            "invalid: screen: 2 angles for 3 channels; give one for each, or one");
}

TEST(ScreenRecipe, TakesTheUsualAngles) {
  EXPECT_EQ(usual_angles(1), (std::vector<double>{45}));
  EXPECT_EQ(usual_angles(4), (std::vector<double>{15, 75, 0, 45}));
  EXPECT_EQ(usual_angles(5).back(), 37.5);
}

}  // namespace
}  // namespace tristim
