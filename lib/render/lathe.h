#pragma once

#include <span>
#include <vector>

#include "tristim/render/polygon_model.h"

namespace tristim::detail {

/// A point of a profile that is turned about the y axis: its distance from the axis and its height,
/// and the normal there, of any length.
struct ProfilePoint {
  double r = 0, y = 0;
  double normal_r = 0, normal_y = 0;
};

/// A smooth part of a profile. The surface faces to the left of the way along it.
using ProfileStrip = std::vector<ProfilePoint>;

/// The surface of a profile in `columns` steps round the axis: quads, triangles at the axis. Strips
/// that meet in a point share its vertices, but not their normals.
PolygonModel lathe(std::span<const ProfileStrip> strips, int columns);

}  // namespace tristim::detail
