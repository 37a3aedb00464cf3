// Figures that are diagrams: vectors and frames.
#include <array>
#include <cmath>
#include <vector>

#include "tools/figure_drawing.h"
#include "tools/figures.h"
#include "tristim/light/fisher_woo.h"
#include "tristim/light/vector.h"

namespace tristim::tools {
namespace {

using Eigen::Vector3d;

void draw_vector(SvgDrawing& svg, SvgPoint origin, double length, double degrees,
                 std::string_view name, std::string_view color) {
  draw_arrow(svg, origin, around(origin, length, degrees), color, 2.2);
  const SvgPoint place = around(origin, length + 16, degrees);
  svg.text({place.x, place.y + 6}, name,
           {.size = 18, .color = color, .anchor = SvgAnchor::kMiddle, .bold = true});
}

// `name_at`: where its name stands, for arcs that a vector divides.
void draw_angle(SvgDrawing& svg, SvgPoint origin, double radius, double from, double to,
                double name_at, std::string_view name, std::string_view color) {
  draw_arc(svg, origin, radius, from, to, {color, 1.3});
  const SvgPoint place = around(origin, radius + 12, name_at);
  svg.text(
      {place.x, place.y + 5}, name,
      {.size = 15, .color = color, .anchor = SvgAnchor::kMiddle, .italic = true, .halo = "#fff"});
}

// The paper's frame as seen from the right, above and in front.
class Oblique {
 public:
  Oblique(SvgPoint origin, double scale) : origin_(origin), scale_(scale) {}

  SvgPoint at(const Vector3d& p) const {
    constexpr double kTurn = 30;
    constexpr double kTilt = 24;
    const double right = p.x() * cosine_deg(kTurn) - p.z() * sine_deg(kTurn);
    const double near = p.x() * sine_deg(kTurn) + p.z() * cosine_deg(kTurn);
    const double up = p.y() * cosine_deg(kTilt) - near * sine_deg(kTilt);
    return {origin_.x + scale_ * right, origin_.y - scale_ * up};
  }

 private:
  SvgPoint origin_;
  double scale_;
};

// Along the sphere from one direction to another, `radius` from its centre.
std::vector<SvgPoint> sphere_arc(const Oblique& view, const Vector3d& from, const Vector3d& to,
                                 double radius) {
  std::vector<SvgPoint> points;
  constexpr int kParts = 24;
  for (int i = 0; i <= kParts; ++i) {
    const double t = double(i) / kParts;
    points.push_back(view.at(radius * normalize((1 - t) * from + t * to)));
  }
  return points;
}

void label(SvgDrawing& svg, SvgPoint place, std::string_view text, std::string_view color,
           bool italic = false) {
  svg.text(place, text,
           {.size = 17,
            .color = color,
            .anchor = SvgAnchor::kMiddle,
            .bold = !italic,
            .italic = italic,
            .halo = "#fff"});
}

void draw_axes(SvgDrawing& svg, const Oblique& view) {
  struct Axis {
    Vector3d end;
    std::string_view name;
    double dx, dy;  // of the name
  };
  const Axis axes[] = {{{1.35, 0, 0}, "+x", 16, 8},
                       {{-1.35, 0, 0}, "-x", -16, 0},
                       {{0, 1.35, 0}, "+y", 0, -8},
                       {{0, 0, 1.55}, "+z", -14, 14}};
  for (const Axis& axis : axes) {
    const SvgPoint end = view.at(axis.end);
    draw_arrow(svg, view.at(Vector3d::Zero()), end, kGrey, 1.1);
    label(svg, {end.x + axis.dx, end.y + axis.dy}, axis.name, kGrey, true);
  }
}

}  // namespace

std::string fisher_woo_figure1() {
  SvgDrawing svg(560, 400, "Vectors of the R.E and N.H models",
                 "L, N, H, R and E in one plane; rho is twice nu");
  const SvgPoint origin{250, 340};
  constexpr double kAlpha = 38;
  constexpr double kRho = 34;
  constexpr double kNu = kRho / 2;
  svg.rectangle({60, 340}, 440, 14, {.fill = "#e4e4e4"});
  svg.line({60, 340}, {500, 340}, {kInk, 1.4});
  draw_angle(svg, origin, 70, -kAlpha, 0, -kAlpha / 2, "α", kBlue);
  draw_angle(svg, origin, 70, 0, kAlpha, (kNu + kAlpha) / 2, "α", kBlue);
  draw_angle(svg, origin, 110, 0, kNu, kNu / 2, "ν", kOrange);
  draw_angle(svg, origin, 110, kAlpha, kAlpha + kRho, kAlpha + kRho / 2, "ρ", kOrange);
  draw_angle(svg, origin, 156, -kAlpha, kNu, -kAlpha / 2, "β", kGreen);
  draw_angle(svg, origin, 156, kNu, kAlpha + kRho, kAlpha + kRho / 2, "β", kGreen);
  constexpr double kLength = 240;
  draw_vector(svg, origin, kLength, -kAlpha, "L", kInk);
  draw_vector(svg, origin, kLength + 40, 0, "N", kInk);
  draw_vector(svg, origin, kLength + 20, kNu, "H", kInk);
  draw_vector(svg, origin, kLength, kAlpha, "R", kInk);
  draw_vector(svg, origin, kLength, kAlpha + kRho, "E", kInk);
  svg.text({250, 386}, "ρ + 2α = 2β,  β = ν + α,  therefore ρ = 2ν",
           {.size = 14, .anchor = SvgAnchor::kMiddle, .italic = true});
  return svg.document();
}

std::string fisher_woo_figure4() {
  SvgDrawing svg(560, 430, "Reference frame of the lighting models",
                 "E along +z, L in the xz plane, N by theta from +y and phi from -x");
  const Oblique view({285, 262}, 165);
  const HighlightFrame frame = highlight_frame(46, 146, 84);
  const Vector3d half = half_vector(frame.to_light, frame.to_eye);
  const Vector3d foot(frame.normal.x(), 0, frame.normal.z());
  const Vector3d up(0, 1, 0);
  const Vector3d left(-1, 0, 0);
  std::vector<SvgPoint> disc;  // the half of the plane of L and E where L may be
  for (int i = 0; i <= 36; ++i) {
    disc.push_back(view.at({-sine_deg(5 * i), 0, cosine_deg(5 * i)}));
  }
  svg.polygon(disc, {.fill = "#eef3f8", .stroke = {"#c4d3e2", 1}});
  draw_axes(svg, view);
  const SvgPoint origin = view.at(Vector3d::Zero());
  svg.line(origin, view.at(foot), {kOrange, 1, "4 3"});
  svg.line(view.at(frame.normal), view.at(foot), {kOrange, 1, "4 3"});
  svg.polyline(sphere_arc(view, up, frame.normal, 0.5), {kOrange, 1.4});
  svg.polyline(sphere_arc(view, left, normalize(foot), 0.36), {kOrange, 1.4});
  svg.polyline(sphere_arc(view, frame.to_light, half, 0.62), {kGreen, 1.3});
  svg.polyline(sphere_arc(view, half, frame.to_eye, 0.62), {kGreen, 1.3});
  struct Named {
    Vector3d direction;
    std::string_view name, color;
    double dx, dy;
  };
  const Named vectors[] = {{frame.to_light, "L", kInk, -14, -4},
                           {frame.to_eye, "E", kInk, -18, 0},
                           {half, "H", kInk, -16, 8},
                           {frame.normal, "N", kOrange, 4, -10}};
  for (const Named& each : vectors) {
    const SvgPoint end = view.at(each.direction);
    draw_arrow(svg, origin, end, each.color, 2.2);
    label(svg, {end.x + each.dx, end.y + each.dy}, each.name, each.color);
  }
  const auto beside = [&](const Vector3d& direction, double radius) {
    const SvgPoint p = view.at(radius * normalize(direction));
    return SvgPoint{p.x, p.y + 5};
  };
  label(svg, beside(up + frame.normal, 0.6), "θ", kOrange, true);
  label(svg, beside(left + normalize(foot), 0.47), "φ", kOrange, true);
  label(svg, beside(frame.to_light + half, 0.72), "β", kGreen, true);
  label(svg, beside(half + frame.to_eye, 0.72), "β", kGreen, true);
  svg.text({280, 414}, "N = [−sin θ cos φ, cos θ, sin θ sin φ],  0° ≤ θ, φ ≤ 180°",
           {.size = 14, .anchor = SvgAnchor::kMiddle});
  return svg.document();
}

}  // namespace tristim::tools
