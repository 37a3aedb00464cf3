#include "tristim/plot/chromaticity.h"

#include <algorithm>
#include <cmath>

#include "lib/plot/diagram_canvas.h"
#include "tristim/color/ellipses.h"
#include "tristim/color/macadam.h"
#include "tristim/color/wavelength.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

using detail::DiagramCanvas;

constexpr double kMostWidth = 680;  // of the frame, in pixels
constexpr double kMostHeight = 720;
constexpr double kLeft = 72, kTop = 46, kRight = 24, kBottom = 58;  // about the frame
constexpr double kMargin = 0.03;  // about corners that reach beyond the usual axes
constexpr double kFarthest = 2;   // from 0; what lies beyond is not shown

constexpr SvgStroke kRay{"#111", 1};
constexpr SvgStroke kOppositeRay{"#111", 0.9, "4 3"};
constexpr SvgStroke kLimit{"#333", 0.9, "7 2 1.5 2"};
constexpr SvgStroke kEllipse{"#111", 0.9};
constexpr double kMagnified = 10;
constexpr double kDot = 4.5;           // radius of a colour
constexpr std::size_t kMostRays = 24;  // colours: more are a cloud, without rays and names

// Told apart by colour, and by their dashes where there is none.
constexpr SvgStroke kGamutStrokes[] = {
    {"#111", 1.8},           {"#c0172c", 1.8},        {"#1450a0", 1.8},        {"#7a2c96", 1.8},
    {"#11673a", 1.8, "9 4"}, {"#a04a00", 1.8, "9 4"}, {"#005f73", 1.8, "9 4"}, {"#555", 1.8, "9 4"},
};

const SvgStroke& gamut_stroke(std::size_t i) { return kGamutStrokes[i % std::size(kGamutStrokes)]; }

// The ranges of the axes.
struct View {
  double left, right, bottom, top;
};

View usual_view(const ChromaticityPlane& plane) {
  if (plane.name == kCie1976Plane.name) return {-0.05, 0.68, -0.03, 0.63};
  return {-0.06, 0.80, -0.035, 0.90};
}

void include(View& view, PlanePoint p) {
  if (!(std::fabs(p.x) <= kFarthest) || !(std::fabs(p.y) <= kFarthest)) return;
  view = {std::min(view.left, p.x - kMargin), std::max(view.right, p.x + kMargin),
          std::min(view.bottom, p.y - kMargin), std::max(view.top, p.y + kMargin)};
}

View view_of(const ChromaticityDiagram& diagram) {
  View view = usual_view(*diagram.plane);
  for (const DiagramGamut& gamut : diagram.gamuts) {
    const Primaries& p = gamut.primaries;
    for (const Chromaticity c : {p.red, p.green, p.blue}) include(view, diagram.plane->point(c));
  }
  for (const DiagramColor& color : diagram.colors) {
    include(view, diagram.plane->point(color.chromaticity));
  }
  return view;
}

double scale_of(const View& view) {
  return std::min(kMostWidth / (view.right - view.left), kMostHeight / (view.top - view.bottom));
}

void draw_gamuts(const DiagramCanvas& canvas, const ChromaticityDiagram& diagram) {
  for (std::size_t i = 0; i < diagram.gamuts.size(); ++i) {
    const Primaries& p = diagram.gamuts[i].primaries;
    const std::vector<SvgPoint> triangle = canvas.at({p.red, p.green, p.blue});
    canvas.svg.polygon(triangle, {.stroke = {"#fff", 3.4, {}, 0.6}});
    canvas.svg.polygon(triangle, {.stroke = gamut_stroke(i)});
  }
}

void draw_limits(const DiagramCanvas& canvas, const std::vector<double>& luminances) {
  if (luminances.empty()) return;
  const OptimalColors colors = optimal_colors(*find_by_name(illuminants(), "c"));
  for (const double luminance : luminances) {
    const std::vector<SvgPoint> outline = canvas.at(colors.boundary(luminance));
    if (outline.empty()) continue;
    canvas.svg.polygon(outline, {.stroke = kLimit});
    const SvgPoint top = *std::min_element(outline.begin(), outline.end(),
                                           [](SvgPoint a, SvgPoint b) { return a.y < b.y; });
    canvas.labels.place_beside(top, 3, "Y = " + rounded(100 * luminance, 6),
                               {.size = 9.5, .halo = "#fff"}, false);
  }
}

void draw_ellipses(const DiagramCanvas& canvas) {
  for (const DiscriminationEllipse& ellipse : macadam_ellipses()) {
    canvas.svg.polygon(canvas.at(ellipse_outline(ellipse, kMagnified, 48)), {.stroke = kEllipse});
  }
}

// From the white through the colour to the locus or the purple line, and the other way, dashed.
void draw_rays(const DiagramCanvas& canvas, Chromaticity color, Chromaticity white) {
  const DominantWavelength seen = dominant_wavelength(color, white);
  if (!(seen.excitation_purity > 0)) return;
  const double reach = 1 / seen.excitation_purity;
  const Chromaticity end{white.x + (color.x - white.x) * reach,
                         white.y + (color.y - white.y) * reach};
  const double opposite_nm = seen.dominant_nm < 0 ? -seen.dominant_nm : seen.complementary_nm;
  canvas.svg.line(canvas.at(white), canvas.at(seen.excitation_purity > 1 ? color : end), kRay);
  canvas.svg.circle(canvas.at(end), 2.2, {.fill = "#fff", .stroke = {"#111", 1}});
  if (std::isnan(opposite_nm)) return;
  canvas.svg.line(canvas.at(white), canvas.at(spectral_locus(opposite_nm)), kOppositeRay);
  canvas.svg.circle(canvas.at(spectral_locus(opposite_nm)), 1.8, {.fill = "#111"});
}

void draw_white(const DiagramCanvas& canvas, const DiagramColor& white) {
  const SvgPoint place = canvas.at(white.chromaticity);
  canvas.svg.circle(place, 4, {.fill = "#fff", .stroke = {"#111", 1.2}});
  canvas.svg.circle(place, 1.2, {.fill = "#111"});
}

void draw_colors(const DiagramCanvas& canvas, const ChromaticityDiagram& diagram) {
  for (const DiagramColor& color : diagram.colors) {
    const SvgPoint place = canvas.at(color.chromaticity);
    canvas.svg.circle(place, kDot + 1, {.fill = "#fff"});
    canvas.svg.circle(place, kDot,
                      {.fill = detail::display_color(color.chromaticity), .stroke = {"#111", 1}});
  }
  if (diagram.colors.size() > kMostRays) return;
  for (const DiagramColor& color : diagram.colors) {
    canvas.labels.place_beside(canvas.at(color.chromaticity), kDot + 4, color.name,
                               {.size = 11, .bold = true, .halo = "#fff"}, true);
  }
}

// "tomato: 607.4 nm, purity 0.62"
std::string wavelength_text(const DiagramColor& color, Chromaticity white) {
  const DominantWavelength seen = dominant_wavelength(color.chromaticity, white);
  if (std::isnan(seen.dominant_nm)) return color.name;
  return color.name + ": " + fixed_text(std::fabs(seen.dominant_nm), 1) +
         (seen.dominant_nm < 0 ? " nm c, purity " : " nm, purity ") +
         fixed_text(seen.excitation_purity, 3);
}

// The keys of a legend, and the texts that they point to.
struct Legend {
  std::vector<std::string> texts;
  std::vector<std::string> fills;
  std::vector<SvgStroke> strokes;

  void add(std::string text, const SvgStroke& stroke, std::string fill = {}) {
    texts.push_back(std::move(text));
    strokes.push_back(stroke);
    fills.push_back(std::move(fill));
  }
  std::vector<PlotKey> keys() const {
    std::vector<PlotKey> keys;
    for (std::size_t i = 0; i < texts.size(); ++i) keys.push_back({texts[i], strokes[i], fills[i]});
    return keys;
  }
};

void add_colors(Legend& legend, const ChromaticityDiagram& diagram) {
  if (diagram.colors.empty()) return;
  if (diagram.colors.size() > kMostRays) {
    return legend.add(std::to_string(diagram.colors.size()) + " colours", {}, "#bbb");
  }
  for (const DiagramColor& color : diagram.colors) {
    legend.add(wavelength_text(color, diagram.white.chromaticity), {},
               detail::display_color(color.chromaticity));
  }
  legend.add("to the dominant wavelength", kRay);
  legend.add("to the complementary wavelength", kOppositeRay);
}

Legend legend_of(const ChromaticityDiagram& diagram) {
  Legend legend;
  for (std::size_t i = 0; i < diagram.gamuts.size(); ++i) {
    legend.add(diagram.gamuts[i].name, gamut_stroke(i));
  }
  if (diagram.temperatures) {
    legend.add("Planckian locus", detail::kPlanckianStroke);
    legend.add("daylight locus", detail::kDaylightStroke);
  }
  if (!diagram.limits.empty()) legend.add("MacAdam limits of Y, illuminant C", kLimit);
  if (diagram.ellipses) legend.add("MacAdam ellipses, 10 times", kEllipse);
  legend.add("white, " + diagram.white.name, {}, "#fff");
  add_colors(legend, diagram);
  return legend;
}

bool shown(const DiagramColor& color) {
  return std::isfinite(color.chromaticity.x) && std::isfinite(color.chromaticity.y);
}

void draw_parts(const DiagramCanvas& canvas, const ChromaticityDiagram& diagram) {
  detail::draw_inside(canvas);
  canvas.axes.grid({"#000", 0.6, {}, 0.13});
  if (diagram.ellipses) draw_ellipses(canvas);
  draw_gamuts(canvas, diagram);
  canvas.labels.occupy(canvas.at(diagram.white.chromaticity), 5);
  for (const DiagramColor& color : diagram.colors) {
    canvas.labels.occupy(canvas.at(color.chromaticity), kDot);
  }
  if (diagram.colors.size() <= kMostRays) {
    for (const DiagramColor& color : diagram.colors) {
      draw_rays(canvas, color.chromaticity, diagram.white.chromaticity);
    }
  }
  detail::draw_locus(canvas);
  if (diagram.temperatures) detail::draw_temperatures(canvas);
  draw_limits(canvas, diagram.limits);
  draw_white(canvas, diagram.white);
  draw_colors(canvas, diagram);
}

}  // namespace

std::string chromaticity_diagram(const ChromaticityDiagram& given) {
  ChromaticityDiagram diagram = given;
  std::erase_if(diagram.colors, [](const DiagramColor& color) { return !shown(color); });
  const View view = view_of(diagram);
  const double scale = scale_of(view);
  const double width = scale * (view.right - view.left);
  const double height = scale * (view.top - view.bottom);
  const std::string title = "CIE " + std::string(diagram.plane->name) + " chromaticity diagram";
  const Legend legend = legend_of(diagram);
  const std::vector<PlotKey> keys = legend.keys();
  const PlotBox size = legend_box(keys, {});
  // The corner that the locus leaves free holds a short legend; a long one stands beside the frame.
  const bool beside = size.width > 0.40 * width || size.height > 0.36 * height;
  const double right = beside ? size.width + 2 * kRight : kRight;

  SvgDrawing svg(kLeft + width + right, kTop + height + kBottom, title);
  svg.rectangle({0, 0}, svg.width(), svg.height(), {.fill = "#fff"});
  const PlotAxes axes(svg, {kLeft, kTop}, width, height,
                      {.from = view.left,
                       .to = view.right,
                       .title = diagram.plane->x_name,
                       .step = 0.1,
                       .italic = true},
                      {.from = view.bottom,
                       .to = view.top,
                       .title = diagram.plane->y_name,
                       .step = 0.1,
                       .italic = true});
  svg.text({kLeft + width / 2, kTop - 18}, title,
           {.size = 16, .anchor = SvgAnchor::kMiddle, .bold = true});

  detail::LabelPlacer labels(svg, {kLeft, kTop}, width, height);
  const bool low = diagram.plane->name == kCie1976Plane.name;
  const SvgPoint corner{kLeft + width + (beside ? kRight : -size.width - 8),
                        beside ? kTop
                        : low  ? kTop + height - size.height - 8
                               : kTop + 8};
  if (!beside) labels.occupy(corner, size.width, size.height);
  const SvgPoint frame[] = {
      {kLeft, kTop}, {kLeft + width, kTop}, {kLeft + width, kTop + height}, {kLeft, kTop + height}};
  svg.begin_clip(frame);
  draw_parts({svg, axes, labels, *diagram.plane}, diagram);
  svg.end_clip();
  axes.frame();
  draw_legend(svg, keys, corner);
  return svg.document();
}

}  // namespace tristim
