#include "lib/render/hit_rows.h"

#include <gtest/gtest.h>

#include <random>

namespace tristim::detail {
namespace {

VisibilityPlane random_plane(std::mt19937& random, int kinds) {
  VisibilityPlane plane;
  plane.clear({.x0 = 32, .y0 = -3, .width = 80, .height = 9});
  std::uint32_t id = 0;
  for (std::size_t i = 0; i + 1 < plane.id.size(); ++i) {
    if (random() % 4 == 0) id = static_cast<std::uint32_t>(random() % static_cast<unsigned>(kinds));
    plane.id[i] = id == 0 ? kNothing : id;
  }
  return plane;
}

TEST(FindRuns, InVectorsIsTheDefinition) {
  std::mt19937 random(5);
  for (const int kinds : {1, 2, 3, 50}) {
    const VisibilityPlane plane = random_plane(random, kinds);
    std::vector<HitRun> fast;
    std::vector<HitRun> slow;
    fast.resize(find_runs(plane, fast));
    find_runs_scalar(plane, slow);
    ASSERT_EQ(fast.size(), slow.size());
    for (std::size_t i = 0; i < fast.size(); ++i) {
      EXPECT_EQ(fast[i].pixel, slow[i].pixel);
      EXPECT_EQ(fast[i].triangle, slow[i].triangle);
      EXPECT_EQ(fast[i].x, slow[i].x);
      EXPECT_EQ(fast[i].y, slow[i].y);
      EXPECT_EQ(fast[i].length, slow[i].length);
    }
  }
}

TEST(GatherHits, InVectorsIsTheDefinition) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> value(-1, 1);
  const VisibilityPlane plane = random_plane(random, 9);
  std::vector<HitRun> runs;
  runs.resize(find_runs(plane, runs));
  std::vector<SurfacePlanes> planes(9);
  for (SurfacePlanes& each : planes) {
    each.x0 = 70 + 20 * value(random);
    each.y0 = 5 * value(random);
    each.set(0, {2 + value(random), value(random) / 100, value(random) / 100});
    for (std::size_t k = 1; k < 4; ++k) {
      each.set(k, {value(random), value(random) / 100, value(random) / 100});
    }
  }
  for (const bool orthographic : {false, true}) {
    for (const bool facing : {false, true}) {
      const Camera camera{.eye = {1, 2, 3}, .orthographic = orthographic};
      const HitRays rays = hit_rays(view_of(camera, 128, 10));
      HitRows fast;
      HitRows slow;
      fast.resize(1000);
      slow.resize(1000);
      const HitJob job{runs, planes.data(), 0.25, 0.75, rays, facing};
      gather_hits(job, fast);
      gather_hits_scalar(job, slow);
      ASSERT_EQ(fast.size, slow.size);
      for (std::size_t i = 0; i < slow.size / kBlock; ++i) {
        EXPECT_EQ(fast.blocks[i].pixel, slow.blocks[i].pixel);
        EXPECT_EQ(fast.blocks[i].lanes, slow.blocks[i].lanes);
      }
      for (std::size_t i = 0; i < slow.size; ++i) {
        EXPECT_EQ(fast.x[i], slow.x[i]);
        EXPECT_EQ(fast.y[i], slow.y[i]);
        EXPECT_EQ(fast.z[i], slow.z[i]);
        EXPECT_EQ(fast.nx[i], slow.nx[i]);
        EXPECT_EQ(fast.ny[i], slow.ny[i]);
        EXPECT_EQ(fast.nz[i], slow.nz[i]);
        EXPECT_EQ(fast.distance[i], slow.distance[i]);
      }
    }
  }
}

}  // namespace
}  // namespace tristim::detail
