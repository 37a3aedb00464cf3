#include <algorithm>
#include <limits>
#include <string>

#include "lib/core/trigonometry.h"
#include "lib/plot/diagram_canvas.h"
#include "tristim/color/cct.h"
#include "tristim/color/illuminant.h"
#include "tristim/color/planckian.h"
#include "tristim/color/wavelength.h"

namespace tristim::detail {
namespace {

constexpr SvgStroke kLocusStroke{"#111", 1.5};
constexpr SvgStroke kTickStroke{"#111", 1};
constexpr double kTick = 5;          // pixels
constexpr double kLeastBetween = 4;  // pixels from tick to tick
constexpr SvgFont kWavelengthFont{.size = 10.5, .halo = "#fff"};
constexpr SvgFont kTemperatureFont{.size = 9.5, .halo = "#fff"};

// Round wavelengths before those between them, and the ends of the spectrum where there is room.
constexpr int kLabelled[] = {500, 520, 540, 560, 580, 600, 480, 460, 620, 510, 530,
                             550, 570, 590, 490, 470, 700, 380, 610, 640, 450, 440};

constexpr double kTemperatures[] = {2000, 2500, 3000, 4000, 5000, 6500, 10000};
constexpr double kAbove = 0.004, kBelow = 0.008;  // the tick at a temperature, in CIE 1960

struct Direction {
  double x, y;
};

Direction direction(SvgPoint from, SvgPoint to) {
  const double length = hypotenuse(to.x - from.x, to.y - from.y);
  return {(to.x - from.x) / length, (to.y - from.y) / length};
}

// Away from the inside, square to the locus.
Direction outwards(const DiagramCanvas& canvas, int lambda_nm) {
  const double low = std::max(lambda_nm - 2, kLocusFirstNm);
  const double high = std::min(lambda_nm + 2, kLocusLastNm);
  const Direction along =
      direction(canvas.at(spectral_locus(low)), canvas.at(spectral_locus(high)));
  return {along.y, -along.x};  // the locus runs clockwise on the page
}

void draw_ticks(const DiagramCanvas& canvas) {
  SvgPoint last{-1e9, -1e9};
  for (int nm = kLocusFirstNm; nm <= kLocusLastNm; nm += 10) {
    const SvgPoint p = canvas.at(spectral_locus(nm));
    if (hypotenuse(p.x - last.x, p.y - last.y) < kLeastBetween) continue;
    last = p;
    const Direction out = outwards(canvas, nm);
    canvas.svg.line(p, {p.x + kTick * out.x, p.y + kTick * out.y}, kTickStroke);
  }
}

std::vector<Chromaticity> planckian_locus() {
  std::vector<Chromaticity> locus;
  for (int mired = 1000; mired > 0; mired -= 5) {
    locus.push_back(planckian_chromaticity(1e6 / mired));
  }
  locus.push_back(planckian_chromaticity(std::numeric_limits<double>::infinity()));
  return locus;
}

std::vector<Chromaticity> daylight_locus() {
  std::vector<Chromaticity> locus;
  for (int mired = 250; mired >= 40; mired -= 5) {
    locus.push_back(daylight_chromaticity(1e6 / mired));
  }
  return locus;
}

void draw_isotherm(const DiagramCanvas& canvas, double temperature_k) {
  const SvgPoint above = canvas.at(chromaticity_of({temperature_k, kAbove}));
  const SvgPoint below = canvas.at(chromaticity_of({temperature_k, -kBelow}));
  canvas.svg.line(above, below, {kPlanckianStroke.color, 0.9});
  const Direction away = direction(above, below);
  canvas.labels.place_towards(below, away.x, away.y, 2, fixed_text(temperature_k, 0) + " K",
                              kTemperatureFont);
}

}  // namespace

std::vector<SvgPoint> DiagramCanvas::at(const std::vector<Chromaticity>& chromaticities) const {
  std::vector<SvgPoint> places;
  for (const Chromaticity& c : chromaticities) places.push_back(at(c));
  return places;
}

std::vector<Chromaticity> locus_chromaticities() {
  std::vector<Chromaticity> locus;
  for (int nm = kLocusFirstNm; nm <= kLocusLastNm; ++nm) locus.push_back(spectral_locus(nm));
  return locus;
}

void draw_locus(const DiagramCanvas& canvas) {
  const std::vector<SvgPoint> locus = canvas.at(locus_chromaticities());
  canvas.svg.line(locus.front(), locus.back(), {kLocusStroke.color, 1, "6 3"});
  canvas.svg.polyline(locus, kLocusStroke);
  draw_ticks(canvas);
  for (const int nm : kLabelled) {
    const Direction out = outwards(canvas, nm);
    canvas.labels.place_towards(canvas.at(spectral_locus(nm)), out.x, out.y, kTick + 2,
                                std::to_string(nm), kWavelengthFont);
  }
}

void draw_temperatures(const DiagramCanvas& canvas) {
  canvas.svg.polyline(canvas.at(daylight_locus()), kDaylightStroke);
  canvas.svg.polyline(canvas.at(planckian_locus()), kPlanckianStroke);
  for (const double t : kTemperatures) draw_isotherm(canvas, t);
  const SvgPoint end = canvas.at(planckian_chromaticity(std::numeric_limits<double>::infinity()));
  canvas.svg.circle(end, 1.8, {.fill = kPlanckianStroke.color});
  canvas.labels.place_beside(end, 5, "∞", kTemperatureFont, false);
}

}  // namespace tristim::detail
