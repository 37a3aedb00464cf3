#include "tristim/palette/stable_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace tristim {
namespace {

using Order = std::vector<std::size_t>;

TEST(StableOrder, KeepsEqualColoursInTheirPlaces) {
  const std::vector<Rgb> before{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  const std::vector<Rgb> now{{0.02, 0.02, 0.02}, {0, 0, 1}, {1, 0, 0}, {1, 1, 1}};
  EXPECT_EQ(stable_order(before, now), (Order{2, 0, 1, 3}));
}

TEST(StableOrder, LetsNearColoursFollow) {
  const std::vector<Rgb> before{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<Rgb> now{{0, 0, 0.9}, {0.9, 0, 0}, {0, 0.9, 0.1}};
  EXPECT_EQ(stable_order(before, now), (Order{1, 2, 0}));
}

TEST(StableOrder, GrowsAndShrinks) {
  const std::vector<Rgb> before{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(stable_order(before, std::vector<Rgb>{{0, 1, 0}, {1, 0, 0}}), (Order{1, 0}));
  EXPECT_EQ(stable_order(before, std::vector<Rgb>{{1, 1, 1}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}}),
            (Order{2, 3, 1, 0}));
  EXPECT_EQ(stable_order({}, before), (Order{0, 1, 2}));
  EXPECT_TRUE(stable_order(before, {}).empty());
}

TEST(StableOrder, LeavesFixedColours) {
  const std::vector<Rgb> before{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<Rgb> now{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
  EXPECT_EQ(stable_order(before, now, 1), (Order{0, 1, 2}));
}

TEST(StableOrder, IsAPermutation) {
  std::mt19937 generator(3);
  const auto colors = [&](std::size_t count) {
    std::vector<Rgb> all;
    for (std::size_t i = 0; i < count; ++i) {
      const auto channel = [&] { return static_cast<double>(generator() % 16) / 15; };
      all.push_back({channel(), channel(), channel()});
    }
    return all;
  };
  for (int i = 0; i < 200; ++i) {
    const auto before = colors(generator() % 20);
    const auto now = colors(generator() % 20);
    Order order = stable_order(before, now, now.empty() ? 0 : generator() % now.size());
    std::ranges::sort(order);
    for (std::size_t k = 0; k < now.size(); ++k) ASSERT_EQ(order[k], k);
    ASSERT_EQ(order.size(), now.size());
  }
}

}  // namespace
}  // namespace tristim
