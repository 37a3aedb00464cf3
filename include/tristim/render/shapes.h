#pragma once

#include <span>
#include <string_view>

#include "tristim/render/polygon_model.h"

namespace tristim {

// Models by formula, about the origin with y up. Closed ones are watertight: neighbours have the
// same positions, to the last bit. Where the surface is curved its own normals are given.

/// A figure of a shape.
struct ShapeParameter {
  std::string_view name;
  double preset;
  double least, most;
  bool whole = false;  // a whole number
};

/// A kind of model.
struct Shape {
  std::string_view name;
  std::string_view what;
  std::span<const ShapeParameter> parameters;
  PolygonModel (*make)(std::span<const double> values);  // one for each parameter, in its range
};

/// Every shape. The scene files, the docs and the tests read this list.
std::span<const Shape> shapes() noexcept;

/// The shape by its presets.
PolygonModel make_shape(const Shape& shape);

}  // namespace tristim
