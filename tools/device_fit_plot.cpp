#include <algorithm>
#include <cmath>

#include "tools/device_fit_report.h"
#include "tristim/plot/axes.h"

namespace tristim::tools {
namespace {

constexpr double kWidth = 520;                     // of both frames
constexpr double kCurves = 360, kResiduals = 150;  // their heights
constexpr double kLeft = 66, kTop = 46, kGap = 20, kBottom = 58;
constexpr std::string_view kOneColor[] = {"#0072b2"};
constexpr std::string_view kThreeColors[] = {"#d55e00", "#009e73", "#0072b2"};

using Points = std::vector<PlotPoint>;

std::string_view color_of(const FitReport& report, std::size_t channel) {
  return report.channels.size() == 1 ? kOneColor[0] : kThreeColors[channel];
}

double most_code(const FitReport& report) {
  double most = 1;
  for (const ChannelFit& c : report.channels) most = std::max(most, c.code_max);
  return most;
}

void draw_curves(SvgDrawing& svg, const PlotAxes& axes, const FitReport& report) {
  constexpr int kSteps = 256;
  axes.grid();
  for (std::size_t c = 0; c < report.channels.size(); ++c) {
    const ChannelFit& channel = report.channels[c];
    Points curve;
    for (int i = 0; i <= kSteps; ++i) {
      const double v = channel.code_max * i / kSteps;
      curve.push_back(
          {v, channel.fit.white * light_of_code(channel.fit.response, v, channel.code_max)});
    }
    axes.curve(curve, {color_of(report, c), 1.6});
    for (const FitResidual& r : channel.fit.residuals) {
      svg.circle(axes.at({r.code, r.measured}), 3,
                 {.fill = "#fff", .stroke = {color_of(report, c), 1.4}});
    }
  }
  axes.frame();
  const PlotKey keys[] = {{.text = "fitted", .stroke = {color_of(report, 0), 1.6}},
                          {.text = "measured", .fill = color_of(report, 0)}};
  axes.legend(keys, PlotCorner::kTopLeft);
}

void draw_residuals(SvgDrawing& svg, const PlotAxes& axes, const FitReport& report) {
  axes.grid();
  axes.curve(Points{{0, 0}, {most_code(report), 0}}, {"#888", 1});
  for (std::size_t c = 0; c < report.channels.size(); ++c) {
    for (const FitResidual& r : report.channels[c].fit.residuals) {
      const SvgStroke stroke{color_of(report, c), 1.4};
      svg.line(axes.at({r.code, 0}), axes.at({r.code, r.lstar}), stroke);
      svg.circle(axes.at({r.code, r.lstar}), 2.6, {.fill = stroke.color});
    }
  }
  axes.frame();
}

}  // namespace

std::string fit_plot(const FitReport& report) {
  const std::string title = report.display.name + ", fitted";
  SvgDrawing svg(kLeft + kWidth + kGap, kTop + kCurves + 2 * kGap + kResiduals + kBottom, title,
                 "Measured luminances on the fitted curves, and what the fit leaves over in L*");
  svg.text({kLeft, 26}, title, {.size = 14, .bold = true});
  double white = 0;
  double error = 0.1;
  for (const ChannelFit& c : report.channels) {
    white = std::max({white, c.fit.white, c.ramp.luminance.back()});
    error = std::max(error, c.fit.largest_lstar * 1.15);
  }
  const PlotAxis codes{.from = 0, .to = most_code(report)};
  const PlotAxes curves(svg, {kLeft, kTop}, kWidth, kCurves, codes,
                        {.from = 0, .to = white * 1.02, .title = "luminance"});
  draw_curves(svg, curves, report);
  PlotAxis below = codes;
  below.title = "code V";
  const PlotAxes residuals(svg, {kLeft, kTop + kCurves + 2 * kGap}, kWidth, kResiduals, below,
                           {.from = -error, .to = error, .title = "error, L*"});
  draw_residuals(svg, residuals, report);
  return svg.document();
}

}  // namespace tristim::tools
