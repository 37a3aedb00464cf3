#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "tristim/color/xyz.h"

namespace tristim {

/// A point of a chromaticity diagram: x, y of CIE 1931 or u', v' of CIE 1976.
struct PlanePoint {
  double x = 0, y = 0;
  friend constexpr bool operator==(const PlanePoint&, const PlanePoint&) = default;
};

/// A chromaticity diagram: lights that are mixed lie on a straight line in each of them.
struct ChromaticityPlane {
  std::string_view name;
  std::string_view x_name, y_name;
  PlanePoint (*point)(Chromaticity c) noexcept;
  Chromaticity (*chromaticity)(PlanePoint p) noexcept;
  std::string_view formula;
  std::string_view source;
};

/// u' = 4x/(-2x + 12y + 3), v' = 9y/(-2x + 12y + 3) [CIE15 8.1], and back.
PlanePoint uv76_from_xy(Chromaticity c) noexcept;
Chromaticity xy_from_uv76(PlanePoint p) noexcept;

inline constexpr ChromaticityPlane kCie1931Plane{"1931",
                                                 "x",
                                                 "y",
                                                 [](Chromaticity c) noexcept {
                                                   return PlanePoint{c.x, c.y};
                                                 },
                                                 [](PlanePoint p) noexcept {
                                                   return Chromaticity{p.x, p.y};
                                                 },
                                                 "x = X/(X + Y + Z), y = Y/(X + Y + Z)",
                                                 "[CIE15 7.3]"};
inline constexpr ChromaticityPlane kCie1976Plane{
    "1976",       "u′",         "v′",
    uv76_from_xy, xy_from_uv76, "u' = 4x/(-2x + 12y + 3), v' = 9y/(-2x + 12y + 3)",
    "[CIE15 8.1]"};

/// Every diagram. The command line and the tests read this list.
inline constexpr ChromaticityPlane kChromaticityPlanes[] = {kCie1931Plane, kCie1976Plane};

/// Corners in either turning sense; the last is joined to the first.
using Polygon = std::vector<PlanePoint>;

/// The area, of either turning sense; that of fewer than three corners is 0.
double polygon_area(std::span<const PlanePoint> polygon) noexcept;

/// Whether a convex polygon holds `point`; its edges count as inside.
bool convex_contains(std::span<const PlanePoint> polygon, PlanePoint point) noexcept;

/// What two convex polygons have in common [Sutherland74]: `subject` itself, corner for corner,
/// where `window` holds it; empty where they are apart.
Polygon convex_intersection(std::span<const PlanePoint> subject,
                            std::span<const PlanePoint> window);

/// The smallest convex polygon about finite points [Andrew79], counterclockwise, without corners on
/// a straight edge.
Polygon convex_hull(std::vector<PlanePoint> points);

/// How far `point` is from a convex polygon; 0 inside.
double distance_outside(std::span<const PlanePoint> polygon, PlanePoint point) noexcept;

}  // namespace tristim
