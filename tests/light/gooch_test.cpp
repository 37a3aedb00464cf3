#include "tristim/light/gooch.h"

#include <gtest/gtest.h>

namespace tristim {
namespace {

using Eigen::Vector3d;

const Vector3d kUp(0, 0, 1);

TEST(Gooch, WarmFacesTheLight) {
  const Rgb warm{1, 0.5, 0};
  const Rgb cool{0, 0.25, 1};
  EXPECT_EQ(gooch(kUp, kUp, warm, cool), warm);
  EXPECT_EQ(gooch(kUp, -kUp, warm, cool), cool);
  EXPECT_EQ(gooch_warmth(kUp, Vector3d(0.6, 0, 0.8)), 0.9);
  EXPECT_EQ(gooch(kUp, Vector3d(1, 0, 0), warm, cool), (Rgb{0.5, 0.375, 0.5}));
}

TEST(Silhouette, IsWhereOneFaceTurnsAway) {
  EXPECT_TRUE(is_silhouette(kUp, kUp, Vector3d(0.6, 0, -0.8)));
  EXPECT_FALSE(is_silhouette(kUp, kUp, Vector3d(0.6, 0, 0.8)));
  EXPECT_FALSE(is_silhouette(kUp, -kUp, Vector3d(0.6, 0, -0.8)));
  EXPECT_TRUE(is_silhouette(kUp, kUp, Vector3d(1, 0, 0)));  // the product is 0
  // The product of the two would vanish below every double.
  EXPECT_FALSE(is_silhouette(1e-200 * kUp, kUp, kUp));
}

TEST(Crease, IsBelowTheThresholdOrAtIt) {
  EXPECT_TRUE(is_crease(kUp, Vector3d(0.6, 0, 0.8), 0.8));
  EXPECT_TRUE(is_crease(kUp, Vector3d(1, 0, 0), 0.5));
  EXPECT_FALSE(is_crease(kUp, kUp, 0.9));
}

}  // namespace
}  // namespace tristim
