#include <algorithm>

#include "tools/levels_job.h"
#include "tristim/color/lab.h"
#include "tristim/core/text.h"
#include "tristim/plot/axes.h"

namespace tristim::tools {
namespace {

constexpr double kSide = 400;  // of a frame
constexpr double kLeft = 62;   // of a frame, for its numbers and title
constexpr double kTop = 64;
constexpr double kBottom = 60;
constexpr double kGap = 24;
constexpr std::size_t kMostDots = 96;  // beyond it dots would be a line
constexpr std::string_view kOneColor[] = {"#0072b2"};
constexpr std::string_view kThreeColors[] = {"#d55e00", "#009e73", "#0072b2"};

using Points = std::vector<PlotPoint>;

std::string_view color_of(const LevelsJob& job, std::size_t channel) {
  return job.drives.size() == 1 ? kOneColor[0] : kThreeColors[channel];
}

// How the eye sees light, over whose scale dark levels do not crowd: L*.
double shown(double light) { return lstar_from_luminance(light); }

void draw_points(SvgDrawing& svg, const PlotAxes& axes, const Points& points,
                 std::string_view color) {
  if (points.size() > kMostDots) return axes.curve(points, {color, 1.6});
  for (const PlotPoint p : points) svg.circle(axes.at(p), 2.6, {.fill = color});
}

// The response as a line and the levels on it, over the codes.
void draw_codes(SvgDrawing& svg, const PlotAxes& axes, const LevelsJob& job,
                const std::vector<ChannelLevels>& channels) {
  constexpr int kSteps = 256;
  axes.grid();
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const auto& [response, vmax] = job.drives[c];
    Points line;
    for (int i = 0; i <= kSteps; ++i) {
      const double v = double(vmax) * i / kSteps;
      line.push_back({v, light_of_code(response, v, vmax)});
    }
    axes.curve(line, {color_of(job, c), 1, "", 0.55});
    Points levels;
    for (const int v : channels[c].codes) {
      levels.push_back({double(v), light_of_code(response, v, vmax)});
    }
    draw_points(svg, axes, levels, color_of(job, c));
  }
  axes.frame();
}

// L* of each level: as asked for, and as its code shows it.
void draw_levels(SvgDrawing& svg, const PlotAxes& axes, const LevelsJob& job,
                 const std::vector<ChannelLevels>& channels) {
  axes.grid();
  const std::vector<double> levels = intensity_levels(job.table);
  Points wanted;
  for (std::size_t j = 0; j < levels.size(); ++j) wanted.push_back({double(j), shown(levels[j])});
  axes.curve(wanted, {"#888", 1, "4 3"});
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const auto& [response, vmax] = job.drives[c];
    Points points;
    for (std::size_t j = 0; j < levels.size(); ++j) {
      points.push_back({double(j), shown(light_of_code(response, channels[c].codes[j], vmax))});
    }
    draw_points(svg, axes, points, color_of(job, c));
  }
  axes.frame();
}

}  // namespace

std::string levels_plot(const LevelsJob& job, const std::vector<ChannelLevels>& channels) {
  const std::string title = std::to_string(job.table.n + 1) + " intensity levels, " +
                            std::string(spacing_of(job.table).name) + " spacing";
  const double left = kLeft + kSide + kGap;
  SvgDrawing svg(2 * left, kTop + kSide + kBottom, title,
                 "Light of the codes with the levels on it, and L* of the levels");
  svg.text({kLeft, 24}, title, {.size = 14, .bold = true});
  svg.text({kLeft, 44},
           "I0 " + rounded(lowest_intensity(job.table), 6) + ", dynamic range " +
               rounded(channels[0].report.dynamic_range, 6) + ", " +
               std::string(kind_of(job.drives[0].response)) + " response",
           {.size = 12, .color = "#555"});
  const double vmax = most_code(job);
  const PlotAxes codes(svg, {kLeft, kTop}, kSide, kSide, {.from = 0, .to = vmax, .title = "code V"},
                       {.from = 0, .to = 1, .title = "intensity I", .step = 0.2});
  draw_codes(svg, codes, job, channels);
  const std::string_view color = color_of(job, 0);
  const PlotKey code_keys[] = {{.text = "levels", .fill = color},
                               {.text = "response", .stroke = {color, 1, "", 0.55}}};
  codes.legend(code_keys, PlotCorner::kTopLeft);
  const PlotAxes levels(svg, {left + kLeft, kTop}, kSide, kSide,
                        {.from = 0, .to = double(job.table.n), .title = "level j"},
                        {.from = 0, .to = 100, .title = "L*", .step = 20});
  draw_levels(svg, levels, job, channels);
  const PlotKey level_keys[] = {{.text = "as asked for", .stroke = {"#888", 1, "4 3"}},
                                {.text = "as the codes show them", .fill = color}};
  levels.legend(level_keys, PlotCorner::kTopLeft);
  return svg.document();
}

}  // namespace tristim::tools
