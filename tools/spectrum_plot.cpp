#include "tools/spectrum_plot.h"

#include <algorithm>
#include <cmath>

#include "tristim/color/observer.h"
#include "tristim/color/primaries.h"
#include "tristim/color/transfer.h"
#include "tristim/plot/axes.h"

namespace tristim::tools {
namespace {

constexpr double kWidth = 720;
constexpr double kHeight = 440;
constexpr double kBand = 6;  // of the spectrum's colours

// Of xbar, ybar, zbar and rbar, gbar, bbar the first three; legible on white and to
// colour-deficient viewers in this order.
constexpr std::string_view kColors[] = {"#d55e00", "#009e73", "#0072b2", "#cc79a7",
                                        "#e69f00", "#56b4e9", "#000000"};
constexpr std::string_view kDashes[] = {"", "6 3", "2 2"};

// A curve's colour, and beyond the colours its dash.
SvgStroke stroke_of(std::size_t i) {
  return {kColors[i % std::size(kColors)], 1.8,
          kDashes[i / std::size(kColors) % std::size(kDashes)]};
}

struct Range {
  double least = 0, most = 0;

  void include(double value) {
    if (!std::isfinite(value)) return;
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

// The values' range from 0, widened to a whole step.
PlotAxis value_axis(std::span<const NamedSpectrum> spectra) {
  Range range;
  for (const NamedSpectrum& s : spectra) {
    for (const double v : s.spectrum.value) range.include(v);
  }
  if (range.least == range.most) range.most = 1;
  const double step = nice_step(range.most - range.least, 6);
  return {.from = step * std::floor(range.least / step),
          .to = step * std::ceil(range.most / step * 1.02),
          .step = step};
}

PlotAxis wavelength_axis(std::span<const NamedSpectrum> spectra) {
  double least = HUGE_VAL;
  double most = 0;
  for (const NamedSpectrum& s : spectra) {
    least = std::min(least, s.spectrum.lambda_nm.front());
    most = std::max(most, s.spectrum.lambda_nm.back());
  }
  return {.from = least, .to = most, .title = "wavelength in nm"};
}

// The colour of a wavelength as sRGB shows it, dark towards the ends: light of matching functions,
// desaturated by clipping.
std::string spectral_color(double lambda_nm) {
  const Xyz bar = matching_functions(observers()[0], static_cast<int>(std::lround(lambda_nm)));
  const Eigen::Vector3d rgb = rgb_from_xyz({}) * Eigen::Vector3d(bar.x, bar.y, bar.z);
  std::string color = "#";
  for (const double light : rgb) {
    const auto code =
        static_cast<unsigned>(std::lround(255 * srgb_encode(std::clamp(light, 0., 1.))));
    color += "0123456789abcdef"[code >> 4];
    color += "0123456789abcdef"[code & 15];
  }
  return color;
}

void draw_spectral_band(SvgDrawing& svg, const PlotAxes& axes, const PlotAxis& wavelengths) {
  std::vector<SvgStop> stops;
  constexpr int kStops = 80;
  for (int i = 0; i <= kStops; ++i) {
    const double t = static_cast<double>(i) / kStops;
    stops.push_back(
        {t, spectral_color(wavelengths.from + t * (wavelengths.to - wavelengths.from))});
  }
  svg.gradient({axes.corner().x, axes.corner().y - kBand}, axes.width(), kBand, stops);
}

}  // namespace

std::string spectrum_plot(std::span<const NamedSpectrum> spectra, std::string_view title) {
  SvgDrawing svg(kWidth, kHeight, title);
  const PlotAxis wavelengths = wavelength_axis(spectra);
  const PlotAxes axes(svg, {56, 38}, kWidth - 76, kHeight - 94, wavelengths, value_axis(spectra));
  svg.text({56, 22}, title, {.size = 14, .bold = true});
  axes.grid();
  draw_spectral_band(svg, axes, wavelengths);
  std::vector<PlotKey> keys;
  for (std::size_t i = 0; i < spectra.size(); ++i) {
    const Spectrum& s = spectra[i].spectrum;
    std::vector<PlotPoint> points;
    for (std::size_t k = 0; k < s.value.size(); ++k) points.push_back({s.lambda_nm[k], s.value[k]});
    axes.curve(points, stroke_of(i));
    keys.push_back({.text = spectra[i].name, .stroke = stroke_of(i)});
  }
  axes.frame();
  axes.legend(keys, PlotCorner::kTopRight);
  return svg.document();
}

}  // namespace tristim::tools
