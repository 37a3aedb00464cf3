// Figures of Fresnel's equations.
#include <array>
#include <string>
#include <vector>

#include "tools/figure_drawing.h"
#include "tools/figures.h"
#include "tristim/color/illuminant.h"
#include "tristim/color/observer.h"
#include "tristim/color/primaries.h"
#include "tristim/core/find.h"
#include "tristim/light/fresnel.h"
#include "tristim/light/metals.h"

namespace tristim::tools {
namespace {

const Metal& metal_named(std::string_view name) { return *find_by_name(metals(), name); }

double metal_reflectance(const Metal& metal, double lambda_nm, double angle_deg) {
  return fresnel(conductor_at(metal, lambda_nm), cosine_deg(angle_deg));
}

Spectrum reflectance_spectrum(const Metal& metal, double angle_deg) {
  Spectrum spectrum;
  for (int lambda = 380; lambda <= 780; lambda += 5) {
    spectrum.lambda_nm.push_back(lambda);
    spectrum.value.push_back(metal_reflectance(metal, lambda, angle_deg));
  }
  return spectrum;
}

// The highlight under D65, as a display shows it.
std::string highlight_color(const Metal& metal, double angle_deg) {
  static const Spectrum daylight = illuminant_spectrum(*find_by_name(illuminants(), "d65"));
  const Xyz xyz = xyz_of_object(reflectance_spectrum(metal, angle_deg), daylight, observers()[0]);
  const Eigen::Vector3d rgb = rgb_from_xyz(Primaries{}) * Eigen::Vector3d(xyz.x, xyz.y, xyz.z);
  return hex_color({rgb[0], rgb[1], rgb[2]});
}

void draw_dielectrics(SvgDrawing& svg, SvgPoint corner, double width, double height) {
  const PlotAxes axes(svg, corner, width, height,
                      {.from = 0, .to = 90, .title = "angle of incidence (degrees)", .step = 15},
                      {.from = 0, .to = 1, .title = "reflectance F", .step = 0.2});
  svg.text({corner.x + width / 2, corner.y - 16}, "dielectrics",
           {.size = 14, .anchor = SvgAnchor::kMiddle, .bold = true});
  axes.grid();
  struct Curve {
    std::string_view name;
    double eta_i, eta_t;
    SvgStroke stroke;
  };
  const Curve curves[] = {{"glass, n = 1.5", 1, 1.5, {kBlue, 2}},
                          {"water, n = 1.333", 1, 1.333, {kGreen, 2}},
                          {"glass to air", 1.5, 1, {kBlue, 1.6, "5 3"}},
                          {"water to air", 1.333, 1, {kGreen, 1.6, "5 3"}}};
  std::vector<PlotKey> keys;
  for (const Curve& curve : curves) {
    axes.curve(curve_points(0, 90, 900,
                            [&](double angle) {
                              return fresnel_dielectric(cosine_deg(angle), curve.eta_i,
                                                        curve.eta_t);
                            }),
               curve.stroke);
    keys.push_back({.text = curve.name, .stroke = curve.stroke});
  }
  axes.frame();
  axes.legend(keys, PlotCorner::kTopLeft);
}

void draw_metals(SvgDrawing& svg, SvgPoint corner, double width, double height) {
  const PlotAxes axes(svg, corner, width, height,
                      {.from = 0, .to = 90, .title = "angle of incidence (degrees)", .step = 15},
                      {.from = 0, .to = 1, .title = "reflectance F", .step = 0.2});
  svg.text({corner.x + width / 2, corner.y - 16}, "metals",
           {.size = 14, .anchor = SvgAnchor::kMiddle, .bold = true});
  axes.grid();
  struct Curve {
    std::string_view name;
    Metal metal;
    double lambda_nm;
    SvgStroke stroke;
  };
  const Curve curves[] = {{"gold, 620 nm", metal_named("gold"), 619.9, {kOrange, 2}},
                          {"gold, 517 nm", metal_named("gold"), 516.6, {kGreen, 2}},
                          {"gold, 443 nm", metal_named("gold"), 442.8, {kBlue, 2}},
                          {"copper, 620 nm", metal_named("copper"), 619.9, {kOrange, 1.6, "5 3"}},
                          {"copper, 517 nm", metal_named("copper"), 516.6, {kGreen, 1.6, "5 3"}},
                          {"copper, 443 nm", metal_named("copper"), 442.8, {kBlue, 1.6, "5 3"}}};
  std::vector<PlotKey> keys;
  for (const Curve& curve : curves) {
    axes.curve(curve_points(0, 90, 360,
                            [&](double angle) {
                              return metal_reflectance(curve.metal, curve.lambda_nm, angle);
                            }),
               curve.stroke);
    keys.push_back({.text = curve.name, .stroke = curve.stroke});
  }
  axes.frame();
  axes.legend(keys, PlotCorner::kBottomRight);
}

void draw_swatches(SvgDrawing& svg, SvgPoint corner, double width, std::string_view name,
                   const Metal& metal) {
  constexpr double kHeight = 46;
  std::vector<SvgStop> stops;
  for (int angle = 0; angle <= 90; angle += 3) {
    stops.push_back({angle / 90.0, highlight_color(metal, angle)});
  }
  svg.gradient(corner, width, kHeight, stops);
  svg.rectangle(corner, width, kHeight, {.stroke = {kInk, 0.8}});
  svg.text({corner.x - 10, corner.y + kHeight / 2 + 5}, name,
           {.size = 13, .anchor = SvgAnchor::kEnd});
}

}  // namespace

std::string fresnel_curves() {
  SvgDrawing svg(1000, 460, "Fresnel reflectance",
                 "Unpolarised light on glass, water, gold, copper");
  draw_dielectrics(svg, {70, 50}, 400, 340);
  draw_metals(svg, {570, 50}, 400, 340);
  return svg.document();
}

std::string highlight_colors() {
  SvgDrawing svg(620, 560, "Colour of a metal's highlight by angle",
                 "Copper's reflectance by wavelength, and gold and copper under daylight");
  svg.text({330, 28}, "At grazing angles the highlight takes on the colour of the light",
           {.size = 15, .anchor = SvgAnchor::kMiddle, .bold = true});
  const PlotAxes axes(svg, {90, 50}, 480, 260,
                      {.from = 380, .to = 780, .title = "wavelength (nm)", .step = 50},
                      {.from = 0, .to = 1, .title = "reflectance F of copper", .step = 0.2});
  axes.grid();
  struct Curve {
    std::string_view name;
    double angle_deg;
  };
  constexpr Curve kCurves[] = {{"0°", 0}, {"60°", 60}, {"75°", 75}, {"85°", 85}, {"89°", 89}};
  std::vector<PlotKey> keys;
  for (std::size_t i = 0; i < std::size(kCurves); ++i) {
    const SvgStroke stroke{kFamily[i + 1], 2};
    axes.curve(curve_points(380, 780, 200,
                            [&](double lambda) {
                              return metal_reflectance(metal_named("copper"), lambda,
                                                       kCurves[i].angle_deg);
                            }),
               stroke);
    keys.push_back({.text = kCurves[i].name, .stroke = stroke});
  }
  axes.frame();
  axes.legend(keys, PlotCorner::kBottomRight);
  draw_swatches(svg, {90, 392}, 480, "copper", metal_named("copper"));
  draw_swatches(svg, {90, 452}, 480, "gold", metal_named("gold"));
  for (int angle = 0; angle <= 90; angle += 15) {
    const double x = 90 + 480 * angle / 90.0;
    svg.line({x, 498}, {x, 503}, {kInk, 1});
    svg.text({x, 516}, std::to_string(angle), {.size = 11, .anchor = SvgAnchor::kMiddle});
  }
  svg.text({330, 540}, "angle of incidence (degrees), under D65",
           {.size = 13, .anchor = SvgAnchor::kMiddle});
  return svg.document();
}

}  // namespace tristim::tools
