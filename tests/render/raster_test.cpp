#include "tristim/render/raster.h"

#include <gtest/gtest.h>

#include <random>

namespace tristim {
namespace {

TEST(Viewport, CornersAndMiddle) {
  const Viewport window{.width = 640, .height = 480, .left = 10, .top = 20};
  EXPECT_EQ(to_viewport(window, {-1, 1, -1}), Eigen::Vector3d(10, 20, 0));
  EXPECT_EQ(to_viewport(window, {1, -1, 1}), Eigen::Vector3d(650, 500, 1));
  EXPECT_EQ(to_viewport(window, {0, 0, 0}), Eigen::Vector3d(330, 260, 0.5));
}

TEST(MidpointLine, StaysOnAnExactTie) {
  // Slope 1/2: half way at x = 1 and 3, where the minor side does not step.
  const std::vector<Pixel> up{{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2}};
  EXPECT_EQ(midpoint_line({0, 0}, {4, 2}), up);
  const std::vector<Pixel> back{{4, 2}, {3, 2}, {2, 1}, {1, 1}, {0, 0}};
  EXPECT_EQ(midpoint_line({4, 2}, {0, 0}), back);
  const std::vector<Pixel> steep{{0, 0}, {0, -1}, {-1, -2}, {-1, -3}, {-2, -4}};
  EXPECT_EQ(midpoint_line({0, 0}, {-2, -4}), steep);
  EXPECT_EQ(midpoint_line({5, 7}, {5, 7}), (std::vector<Pixel>{{5, 7}}));
}

TEST(MidpointLine, KeepsWithinHalfAPixelOfTheLine) {
  for (long long x = -9; x <= 9; ++x) {
    for (long long y = -9; y <= 9; ++y) {
      const std::vector<Pixel> pixels = midpoint_line({0, 0}, {x, y});
      const long long longer = std::max(std::abs(x), std::abs(y));
      ASSERT_EQ(pixels.size(), static_cast<std::size_t>(longer) + 1);
      EXPECT_EQ(pixels.back(), (Pixel{x, y}));
      for (const Pixel& p : pixels) EXPECT_LE(2 * std::abs(p.x * y - p.y * x), longer);
    }
  }
}

TEST(ParityFill, CountsCentresFromTheLeftAndBelow) {
  using Polygon = std::vector<Eigen::Vector2d>;
  // The outline passes through centres: left and lower ones are in, right and upper ones are not.
  const Polygon box{{1.5, 1.5}, {3.5, 1.5}, {3.5, 3.5}, {1.5, 3.5}};
  EXPECT_EQ(parity_fill(8, 8, box), (std::vector<PixelRun>{{1, 1, 3}, {2, 1, 3}}));
  // A star's middle is outside.
  const Polygon hole{{0, 0}, {6, 0}, {6, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 0}};
  EXPECT_EQ(parity_fill(8, 1, hole), (std::vector<PixelRun>{{0, 0, 2}, {0, 4, 6}}));
  EXPECT_EQ(parity_fill(2, 9, box), (std::vector<PixelRun>{{1, 1, 2}, {2, 1, 2}}));  // cut off
  EXPECT_EQ(parity_fill(8, 8, Polygon{}), std::vector<PixelRun>{});
}

TEST(FloodFill, FourOrEightNeighbours) {
  const std::vector<std::string> rows{"001", "010", "100"};
  EXPECT_EQ(flood_fill(rows, 0, 0, Connectivity::kFour),
            (std::vector<std::string>{"221", "210", "100"}));
  EXPECT_EQ(flood_fill(rows, 0, 0, Connectivity::kEight),
            (std::vector<std::string>{"221", "212", "122"}));
  const std::vector<std::string> corner{"01", "10"};
  EXPECT_EQ(flood_fill(corner, 0, 0, Connectivity::kFour), (std::vector<std::string>{"21", "10"}));
  EXPECT_EQ(flood_fill(corner, 0, 0, Connectivity::kEight), (std::vector<std::string>{"21", "12"}));
  EXPECT_EQ(flood_fill(corner, 1, 0, Connectivity::kEight), corner);  // on a 1
  EXPECT_EQ(flood_fill(corner, -1, 5, Connectivity::kEight), corner);
}

TEST(BoundingBox, HoldsTheCentresThatCanBeLit) {
  using Polygon = std::vector<Eigen::Vector2d>;
  const Polygon box{{2, 2}, {10, 2}, {10, 10}, {2, 10}};
  EXPECT_EQ(bounding_box(32, 32, box), (PixelBox{2, 2, 10, 10}));
  EXPECT_EQ(bounding_box(8, 32, box), (PixelBox{2, 2, 8, 10}));
  const Polygon between{{2.6, 2.6}, {3.4, 2.6}, {3, 3.4}};  // no centre
  EXPECT_EQ(bounding_box(32, 32, between), PixelBox{});
  EXPECT_EQ(bounding_box(32, 32, Polygon{}), PixelBox{});
}

TEST(BoundingBoxFill, LightsTheSamePixelsAsTheScanlines) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(-4, 24);
  for (int i = 0; i < 300; ++i) {
    std::vector<Eigen::Vector2d> polygon;
    for (int corner = 0; corner < 3 + i % 4; ++corner) {
      polygon.emplace_back(place(random), place(random));
      if (i % 2 == 0) polygon.back() = (polygon.back() * 2).array().round() / 2;  // onto centres
    }
    EXPECT_EQ(bounding_box_fill(20, 20, polygon), parity_fill(20, 20, polygon));
  }
}

TEST(OutlineFill, DrawsLinesThenFloods) {
  const std::vector<Pixel> diamond{{2, 0}, {4, 2}, {2, 4}, {0, 2}};
  EXPECT_EQ(outline_fill(5, 5, diamond, {2, 2}, Connectivity::kFour),
            (std::vector<std::string>{"00100", "01210", "12221", "01210", "00100"}));
  // Eight neighbours run out between the corners.
  EXPECT_EQ(outline_fill(5, 5, diamond, {2, 2}, Connectivity::kEight),
            (std::vector<std::string>{"22122", "21212", "12221", "21212", "22122"}));
  EXPECT_EQ(outline_fill(3, 3, std::vector<Pixel>{{-5, 1}, {9, 1}}, {0, 0}, Connectivity::kFour),
            (std::vector<std::string>{"222", "111", "000"}));
}

}  // namespace
}  // namespace tristim
