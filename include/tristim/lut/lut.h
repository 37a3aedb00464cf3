#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "tristim/color/rgb.h"

namespace tristim {

/// What the ends of a table stand for, a channel each; low < high. Input beyond them counts as the
/// nearer end, NaN as low.
struct LutRange {
  std::array<double, 3> low = {0, 0, 0};
  std::array<double, 3> high = {1, 1, 1};
  friend bool operator==(const LutRange&, const LutRange&) = default;
};

/// Three curves sampled at equal steps over `range` and joined by straight lines.
struct Lut1D {
  LutRange range;
  int size = 0;            // entries, 2 .. kMostCurveSize
  std::vector<float> rgb;  // 3 size, interleaved
  friend bool operator==(const Lut1D&, const Lut1D&) = default;
};

/// One curve through points of its own, joined by straight lines; beyond them it has the end's
/// value.
struct LutCurve {
  std::vector<float> in;  // strictly ascending, 2 .. kMostCurveSize
  std::vector<float> out;
  friend bool operator==(const LutCurve&, const LutCurve&) = default;
};

/// Three curves whose points are where they are needed: shapers of wide ranges, half floats as
/// index.
struct LutPoints {
  std::array<LutCurve, 3> curves;
  friend bool operator==(const LutPoints&, const LutPoints&) = default;
};

/// A cube of colours at equal steps over `range`.
struct Lut3D {
  LutRange range;
  int size = 0;            // points of an edge, 2 .. kMostCubeSize
  std::vector<float> rgb;  // 3 size^3, interleaved, red fastest
  friend bool operator==(const Lut3D&, const Lut3D&) = default;
};

/// RGB to matrix RGB + offset; nothing is clipped.
struct LutMatrix {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  friend bool operator==(const LutMatrix&, const LutMatrix&) = default;
};

using LutStep = std::variant<Lut1D, LutPoints, Lut3D, LutMatrix>;

/// Steps that are taken one after the other: a shaper and a cube are two.
struct Lut {
  std::string title;
  std::vector<LutStep> steps;  // none: the identity
  friend bool operator==(const Lut&, const Lut&) = default;
};

inline constexpr int kMostCurveSize = 1 << 22;
inline constexpr int kMostCubeSize = 256;  // 201 MB

/// Throws std::invalid_argument, "lut: ..." with the step's number, where a size is out of its
/// bounds, a table is not of its size or holds NaN or infinity, a range is empty or points do not
/// ascend.
void check(const Lut& lut);

/// What goes into a LUT from end to end: the range of its first step, 0 to 1 where that is a matrix
/// or there is none.
LutRange input_range(const Lut& lut);

/// The number of floats in the table of a cube or of curves, 3 size^3 or 3 size. Throws
/// std::invalid_argument where `size` is out of bounds: before memory is asked for.
std::size_t cube_samples(int size);
std::size_t curve_samples(int size);

/// How a colour between the points of a cube is made.
struct LutInterpolation {
  std::string_view name;
  Rgb (*evaluate)(const Lut3D& cube, Rgb rgb) noexcept;  // of a cube that check() takes
  std::string_view formula;
  std::string_view source;
};

/// From the four corners of the tetrahedron that holds the colour, of the six about the cell's
/// diagonal from low to high: greys stay on the diagonal's own points.
Rgb tetrahedral(const Lut3D& cube, Rgb rgb) noexcept;

/// From the eight corners of the cell.
Rgb trilinear(const Lut3D& cube, Rgb rgb) noexcept;

/// Every interpolation; the first is the default. The command line and the tests read this list.
inline constexpr LutInterpolation kLutInterpolations[] = {
    {"tetrahedral", tetrahedral,
     "(1 - f1) P000 + (f1 - f2) Pa + (f2 - f3) Pab + f3 P111, f1 >= f2 >= f3", "[Kasson95]"},
    {"trilinear", trilinear, "sum of Pijk times the opposite parts of the cell", "[Kasson95]"}};

/// One colour in double: the definition of what a table of floats means. Of a LUT that check()
/// takes.
Rgb evaluate(const Lut& lut, Rgb rgb,
             const LutInterpolation& interpolation = kLutInterpolations[0]) noexcept;
Rgb evaluate(const LutStep& step, Rgb rgb,
             const LutInterpolation& interpolation = kLutInterpolations[0]) noexcept;

/// The value of one curve at `x`.
double evaluate(const LutCurve& curve, double x) noexcept;

}  // namespace tristim
