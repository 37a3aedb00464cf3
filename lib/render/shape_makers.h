#pragma once

#include <span>

#include "tristim/render/polygon_model.h"

namespace tristim::detail {

// The makers of shapes(): each takes its parameters in the order of the list.

using ShapeValues = std::span<const double>;

PolygonModel sphere(ShapeValues radius_columns_rows);
PolygonModel icosphere(ShapeValues radius_divisions);
PolygonModel cylinder(ShapeValues radius_height_columns_rows);
PolygonModel cone(ShapeValues radius_height_columns_rows);
PolygonModel paraboloid(ShapeValues radius_height_columns_rows);
PolygonModel torus(ShapeValues radius_tube_columns_rows);
PolygonModel cap(ShapeValues radius_skirt_columns_rows);

PolygonModel box(ShapeValues width_height_depth);
PolygonModel plane(ShapeValues width_depth_columns_rows);
PolygonModel pyramid(ShapeValues bottom_top_height);
PolygonModel corrugation(ShapeValues width_depth_height_ridges);

PolygonModel teapot(ShapeValues steps);

}  // namespace tristim::detail
