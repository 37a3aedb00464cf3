#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tristim/color/rgb.h"
#include "tristim/light/vector.h"
#include "tristim/plot/axes.h"
#include "tristim/plot/svg.h"

namespace tristim::tools {

/// Colours of curves that colour-blind readers tell apart too.
inline constexpr std::string_view kInk = "#222";
inline constexpr std::string_view kBlue = "#0072b2";
inline constexpr std::string_view kOrange = "#d55e00";
inline constexpr std::string_view kGreen = "#009e73";
inline constexpr std::string_view kPurple = "#aa3377";
inline constexpr std::string_view kGrey = "#777";

/// Colours of an ordered family of curves, light to dark.
inline constexpr std::string_view kFamily[] = {"#c6a5dd", "#a47fcb", "#8460b5", "#66469c",
                                               "#4b3081", "#331d63", "#1f0d43"};

inline constexpr SvgFont kCaptionFont{.size = 15, .bold = true};

/// The point `radius` from `centre`, `degrees` clockwise from upward.
SvgPoint around(SvgPoint centre, double radius, double degrees);

/// A line with a filled head at its end.
void draw_arrow(SvgDrawing& svg, SvgPoint from, SvgPoint to, std::string_view color,
                double width = 1.8);

/// A part of a circle, angles as in around().
void draw_arc(SvgDrawing& svg, SvgPoint centre, double radius, double from_deg, double to_deg,
              const SvgStroke& stroke);

/// `function` at `count` + 1 places from `from` to `to`.
template <typename Function>
std::vector<PlotPoint> curve_points(double from, double to, int count, const Function& function) {
  std::vector<PlotPoint> points;
  for (int i = 0; i <= count; ++i) {
    const double x = from + (to - from) * i / count;
    points.push_back({x, function(x)});
  }
  return points;
}

/// Linear sRGB as "#rrggbb", clipped.
std::string hex_color(const Rgb& linear);

inline double sine_deg(double degrees) { return cosine_deg(90 - degrees); }

}  // namespace tristim::tools
