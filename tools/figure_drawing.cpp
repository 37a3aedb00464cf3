#include "tools/figure_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tristim/color/transfer.h"

namespace tristim::tools {

SvgPoint around(SvgPoint centre, double radius, double degrees) {
  return {centre.x + radius * sine_deg(degrees), centre.y - radius * cosine_deg(degrees)};
}

void draw_arrow(SvgDrawing& svg, SvgPoint from, SvgPoint to, std::string_view color, double width) {
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double length = std::sqrt(dx * dx + dy * dy);
  const double head = std::min(5.5 * width, length / 2);
  const SvgPoint neck{to.x - dx / length * head, to.y - dy / length * head};
  const double side = 0.38 * head / length;
  const std::array<SvgPoint, 3> triangle{
      {to, {neck.x - dy * side, neck.y + dx * side}, {neck.x + dy * side, neck.y - dx * side}}};
  svg.line(from, neck, {color, width});
  svg.polygon(triangle, {.fill = color});
}

void draw_arc(SvgDrawing& svg, SvgPoint centre, double radius, double from_deg, double to_deg,
              const SvgStroke& stroke) {
  constexpr int kParts = 24;
  std::vector<SvgPoint> points;
  for (int i = 0; i <= kParts; ++i) {
    points.push_back(around(centre, radius, from_deg + (to_deg - from_deg) * i / kParts));
  }
  svg.polyline(points, stroke);
}

std::string hex_color(const Rgb& linear) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "#";
  for (const double component : {linear.r, linear.g, linear.b}) {
    const double encoded = srgb_encode(std::clamp(component, 0.0, 1.0));
    const auto code = static_cast<std::size_t>(255 * encoded + 0.5);
    text += kDigits[code / 16];
    text += kDigits[code % 16];
  }
  return text;
}

}  // namespace tristim::tools
