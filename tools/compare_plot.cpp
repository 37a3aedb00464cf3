#include "tools/compare_plot.h"

#include <algorithm>
#include <cmath>

#include "tristim/color/lab.h"
#include "tristim/core/text.h"
#include "tristim/plot/axes.h"

namespace tristim::tools {
namespace {

constexpr double kSide = 380;  // of a frame
constexpr double kLeft = 60;   // of a frame, for its numbers and title
constexpr double kTop = 44;
constexpr double kBottom = 60;
constexpr double kGap = 24;
constexpr SvgStroke kIdeal{"#999", 1, "4 3"};
constexpr SvgStroke kMain{"#0072b2", 2};
constexpr SvgStroke kOther{"#d55e00", 2};

using Points = std::vector<PlotPoint>;

void draw_tone(SvgDrawing& svg, SvgPoint corner, const Figures& figures) {
  const PlotAxes axes(svg, corner, kSide, kSide, {0, 100, "L* of the reference", 20},
                      {0, 100, "L* of the result", 20});
  const bool patches = !figures.patches.empty();
  Points points;
  for (const TonePoint& p : patches ? figures.patches : figures.tone.curve) {
    points.push_back({lstar_from_luminance(p.reference), lstar_from_luminance(p.result)});
  }
  axes.grid();
  axes.curve(Points{{0, 0}, {100, 100}}, kIdeal);
  axes.curve(points, kMain);
  for (const PlotPoint p : points) svg.circle(axes.at(p), 3, {.fill = kMain.color});
  axes.frame();
  const std::string error = "largest error " + rounded(figures.tone.lstar_max, 3);
  const PlotKey keys[] = {{.text = patches ? "tone of the patches" : "tone curve", .stroke = kMain},
                          {.text = "as it should be", .stroke = kIdeal},
                          {.text = error}};
  axes.legend(keys, PlotCorner::kTopLeft);
}

double largest_power(const RadialSpectrum& spectrum) {
  double most = 0;
  for (const RadialSpectrum::Ring& ring : spectrum.rings) most = std::max(most, ring.power);
  return most;
}

void draw_spectrum(SvgDrawing& svg, SvgPoint corner, const TextureFigures& texture) {
  const double most = std::max(1.0, largest_power(texture.spectrum)) * 1.05;
  const PlotAxes axes(svg, corner, kSide, kSide * 0.6, {0, 0.71, "", 0.1},
                      {0, most, "power / variance"});
  Points power;
  for (const RadialSpectrum::Ring& ring : texture.spectrum.rings) {
    power.push_back({ring.frequency, ring.power});
  }
  axes.grid();
  axes.curve(Points{{texture.principal, 0}, {texture.principal, most}}, kIdeal);
  axes.curve(Points{{0, 1}, {0.71, 1}}, {"#ccc", 1});
  axes.curve(power, kMain);
  axes.frame();
  const PlotKey keys[] = {{.text = "radial power", .stroke = kMain},
                          {.text = "principal frequency", .stroke = kIdeal}};
  axes.legend(keys, PlotCorner::kTopLeft);
}

void draw_anisotropy(SvgDrawing& svg, SvgPoint corner, const TextureFigures& texture) {
  const PlotAxes axes(svg, corner, kSide, kSide * 0.3, {0, 0.71, "cycles per sample", 0.1},
                      {-30, 20, "anisotropy, dB", 10});
  Points points;
  for (const RadialSpectrum::Ring& ring : texture.spectrum.rings) {
    const double db = 10 * std::log10(std::max(ring.anisotropy, 1e-9));
    if (ring.frequency > 0) points.push_back({ring.frequency, std::clamp(db, -30.0, 20.0)});
  }
  const double isotropic = -10 * std::log10(texture.spectrum.segments);
  axes.grid();
  axes.curve(Points{{0, isotropic}, {0.71, isotropic}}, kIdeal);
  axes.curve(points, kOther);
  axes.frame();
}

}  // namespace

std::string compare_plot(const Figures& figures, std::string_view title) {
  const double frames = figures.texture ? 2 : 1;
  SvgDrawing svg(frames * (kLeft + kSide) + kGap, kTop + kSide + kBottom, title,
                 "Tone curve and noise spectrum of a result against its reference");
  svg.text({kLeft, 26}, title, {.size = 14, .bold = true});
  draw_tone(svg, {kLeft, kTop}, figures);
  if (figures.texture) {
    const double x = 2 * kLeft + kSide;
    draw_spectrum(svg, {x, kTop}, *figures.texture);
    draw_anisotropy(svg, {x, kTop + kSide * 0.7}, *figures.texture);
  }
  return svg.document();
}

}  // namespace tristim::tools
