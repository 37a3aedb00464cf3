#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "tristim/plot/svg.h"

namespace tristim {

/// A point of a plot, in the numbers of its axes.
struct PlotPoint {
  double x = 0, y = 0;
  friend constexpr bool operator==(const PlotPoint&, const PlotPoint&) = default;
};

/// A linear axis from `from` to `to`, from < to.
struct PlotAxis {
  double from = 0, to = 1;
  std::string_view title = {};
  double step = 0;      // between numbers; 0: nice_step for about 6 of them
  bool italic = false;  // the title is a symbol
};

/// What a line or mark of the legend stands for.
struct PlotKey {
  std::string_view text;
  SvgStroke stroke = {};       // a line, where its width is above 0
  std::string_view fill = {};  // a dot, where it is not empty
};

/// A rectangle on the drawing.
struct PlotBox {
  SvgPoint corner;  // top left
  double width = 0, height = 0;
};

/// How large a legend is, and the legend itself, on white: a key a row.
PlotBox legend_box(std::span<const PlotKey> keys, SvgPoint corner);
void draw_legend(SvgDrawing& svg, std::span<const PlotKey> keys, SvgPoint corner);

/// Where a legend stands in its frame.
enum class PlotCorner { kTopLeft, kTopRight, kBottomLeft, kBottomRight };

/// Two linear axes about a frame of a drawing.
///
/// Draw grid(), then the curves, then frame() over their ends. The numbers need about 30 pixels to
/// the left and below the frame, the titles another 25.
class PlotAxes {
 public:
  /// The frame is the area between the axes: its top left corner and size on the drawing. Throws
  /// std::invalid_argument where an axis has from >= to or no finite range.
  PlotAxes(SvgDrawing& svg, SvgPoint corner, double width, double height, const PlotAxis& x,
           const PlotAxis& y);

  /// Where a point of the plot lies on the drawing; also outside of the frame.
  SvgPoint at(PlotPoint point) const noexcept;
  std::vector<SvgPoint> at(std::span<const PlotPoint> points) const;

  /// The point of the plot at a place of the drawing: the inverse of at().
  PlotPoint point(SvgPoint place) const noexcept;

  /// Thin lines at every number of both axes.
  void grid(const SvgStroke& stroke = {"#e3e3e3", 0.8}) const;

  /// The frame, ticks, numbers and titles.
  void frame() const;

  /// A line through the points that shows inside of the frame only; NaN breaks it.
  void curve(std::span<const PlotPoint> points, const SvgStroke& stroke) const;

  /// A legend in a corner of the frame; returns where it is.
  PlotBox legend(std::span<const PlotKey> keys, PlotCorner corner) const;

  SvgPoint corner() const noexcept { return corner_; }
  double width() const noexcept { return width_; }
  double height() const noexcept { return height_; }

 private:
  SvgDrawing& svg_;
  SvgPoint corner_;
  double width_, height_;
  PlotAxis x_, y_;
};

/// The step of 1, 2 or 5 times a power of ten that divides `range` (finite, above 0)
/// into about `parts`.
double nice_step(double range, int parts);

/// The multiples of `step` (above 0) within an axis from `from` to `to`.
std::vector<double> axis_ticks(double from, double to, double step);

}  // namespace tristim
