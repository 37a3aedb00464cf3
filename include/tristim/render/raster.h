#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

namespace tristim {

// The elements of rasterization [UBC], one pixel at a time and exact. Pixel (i, j) has its centre
// at (i + .5, j + .5).

/// Where a window lies in the picture: `width` x `height` from (left, top).
struct Viewport {
  double width = 1, height = 1;  // a, b
  double left = 0, top = 0;      // c, d
};

/// From normalised device coordinates, -1..1 and y up, to those of the picture, y down and z 0..1:
/// a x/2 + a/2 + c, -b y/2 + b/2 + d, z/2 + 1/2.
Eigen::Vector3d to_viewport(const Viewport& viewport, const Eigen::Vector3d& ndc) noexcept;

struct Pixel {
  long long x = 0, y = 0;
  friend constexpr bool operator==(const Pixel&, const Pixel&) = default;
};

/// The pixels of a line from p0 to p1, both included, one for each step of the longer side
/// [Bresenham65]. Where the line passes half way between two pixels the shorter side does not step.
std::vector<Pixel> midpoint_line(Pixel p0, Pixel p1);

/// Pixels first..last - 1 of a row.
struct PixelRun {
  int y = 0, first = 0, last = 0;
  friend constexpr bool operator==(const PixelRun&, const PixelRun&) = default;
};

/// The pixels of a picture of `width` x `height` whose centres are inside of a polygon by the rule
/// of parity: a line from the left crosses the outline an odd number of times. A crossing at a
/// centre counts for it; an edge reaches from its lower y up to, not including, its higher y. In
/// order of rows; runs do not touch. Whatever the size of the coordinates, decided exactly but for
/// 2^-100 of their products.
std::vector<PixelRun> parity_fill(int width, int height, std::span<const Eigen::Vector2d> polygon);

/// Pixels first_x..last_x - 1 of the rows first_y..last_y - 1; none where a last is not above its
/// first.
struct PixelBox {
  int first_x = 0, first_y = 0, last_x = 0, last_y = 0;
  friend constexpr bool operator==(const PixelBox&, const PixelBox&) = default;
};

/// The least box of pixels of a picture of `width` x `height` that holds every centre that
/// parity_fill can light. All 0 where there is none.
PixelBox bounding_box(int width, int height, std::span<const Eigen::Vector2d> polygon) noexcept;

/// Whether a point is inside of a polygon by the rule of parity, as parity_fill has it.
bool is_inside(std::span<const Eigen::Vector2d> polygon, const Eigen::Vector2d& point) noexcept;

/// The same runs as parity_fill's, found by asking each centre of the bounding box.
std::vector<PixelRun> bounding_box_fill(int width, int height,
                                        std::span<const Eigen::Vector2d> polygon);

/// Which pixels count as neighbours in a flood fill.
enum class Connectivity { kFour, kEight };

/// The rows of a picture of '0' and '1', with the '0's that can be reached from (x, y) without
/// stepping on a '1' made '2'. A seed outside or on another character fills nothing. Rows are of
/// one length.
std::vector<std::string> flood_fill(std::vector<std::string> rows, long long x, long long y,
                                    Connectivity connectivity);

/// A polygon by its edges [UBC]: lines between the corners, '1', then a flood from a pixel inside,
/// '2'. Rows of '0' where neither is; corners may lie outside of the picture, seeds that do fill
/// nothing. Eight neighbours run through the corners of a line.
std::vector<std::string> outline_fill(int width, int height, std::span<const Pixel> corners,
                                      Pixel seed, Connectivity connectivity);

}  // namespace tristim
