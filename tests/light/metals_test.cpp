#include "tristim/light/metals.h"

#include <gtest/gtest.h>

#include "tristim/core/find.h"

namespace tristim {
namespace {

TEST(Metals, AreLinearBetweenTheRowsAndGoOnAtTheEnds) {
  const Metal& gold = *find_by_name(metals(), "gold");
  EXPECT_EQ(conductor_at(gold, 516.6).eta, 0.878);
  EXPECT_EQ(conductor_at(gold, 516.6).k, 2.01);
  EXPECT_NEAR(conductor_at(gold, (516.6 + 563.5) / 2).k, (2.01 + 2.64) / 2, 1e-15);
  EXPECT_EQ(conductor_at(gold, 1).eta, gold.table.front().eta);
  EXPECT_EQ(conductor_at(gold, 1e5).k, gold.table.back().k);
  // Gold and copper reflect red more than blue.
  for (const Metal& metal : metals()) {
    EXPECT_GT(fresnel(conductor_at(metal, 650), 1), fresnel(conductor_at(metal, 450), 1) + 0.3);
  }
}

}  // namespace
}  // namespace tristim
