#include "tristim/dither/moire.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tristim {
namespace {

ReachedScreen at(double angle_deg, double lpi = 150) {
  return reach({.dpi = 2400, .lpi = lpi, .angle_deg = angle_deg});
}

double expected_beat(double angle_deg) {  // of two equal rulings
  return 2 * std::sin(angle_deg / 2 * 3.14159265358979 / 180);
}

TEST(Beats, FollowTheAngleBetweenTheScreens) {
  for (const double angle : {1.0, 5.0, 15.0, 30.0}) {
    const ReachedScreen screens[] = {at(0), at(angle)};
    const auto all = beats(screens);
    ASSERT_EQ(all.size(), 1u);
    EXPECT_NEAR(all[0].lpi / 150, expected_beat(angle), 2e-3) << angle;
    EXPECT_NEAR(all[0].period_cells * all[0].lpi, 150, 0.3);
  }
}

TEST(Beats, AreOneForAnglesThatDifferByQuarterTurns) {
  const ReachedScreen screens[] = {at(10), at(100)};
  EXPECT_EQ(beats(screens)[0].lpi, 0);
  EXPECT_TRUE(std::isinf(beats(screens)[0].period_cells));
  EXPECT_FALSE(beats(screens)[0].visible);
}

TEST(Beats, CountTheRulingToo) {
  const ReachedScreen screens[] = {at(0, 150), at(0, 120)};
  EXPECT_NEAR(beats(screens)[0].lpi, 30, 0.2);
}

TEST(Beats, CountTheDiagonals) {
  const ReachedScreen screens[] = {at(0, 100), at(45, 141.4213562)};
  EXPECT_LT(beats(screens)[0].lpi, 0.5);
}

TEST(Beats, OfTheUsualAnglesAreNotSeen) {
  std::vector<ReachedScreen> screens;
  for (const double angle : {15.0, 75.0, 0.0, 45.0}) screens.push_back(at(angle));
  for (const Beat& beat : beats(screens)) EXPECT_FALSE(beat.visible) << beat.lpi;
  screens.push_back(at(50));
  EXPECT_TRUE(beats(screens).back().visible);  // 45 and 50 degrees
}

}  // namespace
}  // namespace tristim
