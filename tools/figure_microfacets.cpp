// Figures of rough surfaces as small mirrors.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "tools/figure_drawing.h"
#include "tools/figures.h"
#include "tristim/light/microfacet.h"

namespace tristim::tools {
namespace {

// F is 1 at every angle.
constexpr Conductor kPerfectMirror{.eta = 0, .k = 1};
constexpr int kAlbedoSteps = 24;

// A V groove of two facets, filled below.
void draw_groove(SvgDrawing& svg, SvgPoint left, std::string_view title) {
  const std::array<SvgPoint, 7> outline{{{left.x, left.y},
                                         {left.x + 35, left.y},
                                         {left.x + 100, left.y + 95},
                                         {left.x + 165, left.y},
                                         {left.x + 200, left.y},
                                         {left.x + 200, left.y + 125},
                                         {left.x, left.y + 125}}};
  svg.polygon(outline, {.fill = "#e4e4e4"});
  svg.polyline(std::span(outline).first(5), {kInk, 1.8});
  svg.text({left.x + 100, left.y + 152}, title, {.size = 14, .anchor = SvgAnchor::kMiddle});
}

SvgPoint moved(SvgPoint p, double x, double y) { return {p.x + x, p.y + y}; }

}  // namespace

std::string directional_albedos() {
  SvgDrawing svg(600, 430, "Directional albedo of the two normalisations",
                 "Light that leaves a surface of perfect mirrors, by angle of incidence");
  const PlotAxes axes(svg, {70, 50}, 490, 310,
                      {.from = 0, .to = 90, .title = "angle of incidence (degrees)", .step = 15},
                      {.from = 0, .to = 5.5, .title = "directional albedo, F = 1", .step = 0.5});
  svg.text({315, 30}, "Light reflected by Beckmann's microfacets",
           {.size = 15, .anchor = SvgAnchor::kMiddle, .bold = true});
  axes.grid();
  struct Roughness {
    double m;
    std::string_view name, dash;
  };
  constexpr Roughness kRoughness[] = {
      {0.1, "m = .1", ""}, {0.3, "m = .3", "6 3"}, {0.6, "m = .6", "2 3"}};
  std::vector<PlotKey> keys;
  for (const Roughness& each : kRoughness) {
    for (const MicrofacetNormalization& normalization : kMicrofacetNormalizations) {
      const Microfacets surface{kBeckmann, normalization, each.m};
      const auto albedo = [&](double angle_deg) {
        return directional_albedo(surface, kPerfectMirror, angle_deg, kAlbedoSteps);
      };
      const std::string_view color = normalization.normalised ? kBlue : kOrange;
      axes.curve(curve_points(0, 88, 44, albedo), {color, 2, each.dash});
    }
    keys.push_back({.text = each.name, .stroke = {kInk, 2, each.dash}});
  }
  svg.line(axes.at({0, 1}), axes.at({90, 1}), {kInk, 0.8});
  const auto name = [&](double y, std::string_view text, std::string_view color) {
    svg.text(axes.at({45, y}), text,
             {.size = 13, .color = color, .anchor = SvgAnchor::kMiddle, .bold = true});
  };
  name(2.75, "as printed: F D G / (π N·V N·L)", kOrange);
  name(0.35, "normalised: F D G / (4π N·V N·L)", kBlue);
  axes.frame();
  axes.legend(keys, PlotCorner::kTopRight);
  return svg.document();
}

std::string microfacet_sketch() {
  SvgDrawing svg(760, 300, "Microfacets",
                 "Light that leaves, light that is shadowed, light that is masked");
  const SvgPoint a{30, 120};
  const SvgPoint b{280, 120};
  const SvgPoint c{530, 120};
  draw_groove(svg, a, "lit and seen");
  draw_groove(svg, b, "shadowed: kept from the facet");
  draw_groove(svg, c, "masked: kept from the eye");
  // The right-hand facet leans to the left: its normal is 55.6 degrees left of up.
  const SvgPoint hit = moved(a, 138, 40);
  draw_arrow(svg, moved(a, 20, -60), hit, kOrange);
  draw_arrow(svg, hit, moved(a, 62, -78), kOrange);
  draw_arrow(svg, hit, moved(hit, -52, -36), kBlue, 1.3);
  svg.text(moved(hit, -66, -28), "H", {.size = 14, .color = kBlue, .italic = true});
  svg.text(moved(a, 12, -68), "L", {.size = 15, .bold = true});
  svg.text(moved(a, 58, -86), "V", {.size = 15, .bold = true});
  draw_arrow(svg, moved(b, -24, -34), moved(b, 33, -1), kOrange);
  svg.line(moved(b, 35, 0), moved(b, 112, 77), {kOrange, 1.2, "4 3"});
  svg.text(moved(b, -36, -40), "L", {.size = 15, .bold = true});
  const SvgPoint low = moved(c, 118, 68);
  draw_arrow(svg, moved(c, 96, -76), low, kOrange);
  draw_arrow(svg, low, moved(c, 66, 44), kOrange);
  svg.line(moved(c, 62, 40), moved(c, -10, -12), {kOrange, 1.2, "4 3"});
  svg.text(moved(c, 90, -84), "L", {.size = 15, .bold = true});
  svg.text(moved(c, -22, -16), "V", {.size = 15, .bold = true});
  return svg.document();
}

std::string microfacet_lobes() {
  SvgDrawing svg(600, 430, "Distribution of the microfacets by roughness",
                 "Beckmann's distribution relative to its peak");
  const PlotAxes axes(svg, {70, 50}, 490, 310,
                      {.from = -90, .to = 90, .title = "angle β from N to H (degrees)", .step = 30},
                      {.from = 0, .to = 1, .title = "D(β) / D(0)", .step = 0.2});
  svg.text({315, 30}, "Small m reflects in one direction, large m spreads",
           {.size = 15, .anchor = SvgAnchor::kMiddle, .bold = true});
  axes.grid();
  constexpr double kRoughness[] = {0.1, 0.2, 0.3, 0.45, 0.6};
  static constexpr std::string_view kNames[] = {"m = .1", "m = .2", "m = .3", "m = .45", "m = .6"};
  std::vector<PlotKey> keys;
  for (std::size_t i = 0; i < std::size(kRoughness); ++i) {
    const double m = kRoughness[i];
    const SvgStroke stroke{kFamily[5 - i], 2};
    const double peak = microfacet_density(kBeckmann, 1, m);
    axes.curve(curve_points(-90, 90, 720,
                            [&](double beta) {
                              return microfacet_density(kBeckmann, cosine_deg(beta), m) / peak;
                            }),
               stroke);
    keys.push_back({.text = kNames[i], .stroke = stroke});
  }
  axes.frame();
  axes.legend(keys, PlotCorner::kTopRight);
  return svg.document();
}

}  // namespace tristim::tools
