#include <filesystem>

#include "tools/device_actions.h"
#include "tools/outputs.h"
#include "tristim/color/lab.h"
#include "tristim/color/wavelength.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/device/channels.h"
#include "tristim/plot/axes.h"
#include "tristim/plot/chromaticity.h"

namespace tristim::tools {
namespace {

constexpr double kSide = 400;  // of a frame
constexpr double kLeft = 62;   // of a frame, for its numbers and title
constexpr double kTop = 46;
constexpr double kBottom = 60;
constexpr double kGap = 24;
constexpr std::string_view kOneColor = "#222";
constexpr std::string_view kThreeColors[] = {"#d55e00", "#009e73", "#0072b2"};

constexpr SvgStroke kSetStrokes[] = {
    {"#0072b2", 1.2, "4 3"}, {"#009e73", 1.2, "4 3"}, {"#d55e00", 1.2, "4 3"}};
static_assert(std::size(kSetStrokes) == std::size(kPictureSets));

using Points = std::vector<PlotPoint>;

// Light of each code, steps as the codes are; entries of a palette by their luminance.
Points lights_of(const Display& display, int channel) {
  Points points;
  if (!display.palette.empty()) {
    double white = 0;
    for (const CodeColor& c : display.palette) white = std::max(white, c.appearance.y);
    for (const CodeColor& c : display.palette) {
      points.push_back({double(c.code), c.appearance.y / white});
    }
    return points;
  }
  const int bits = display.frame.packing.bits[static_cast<std::size_t>(channel)];
  const std::vector<double> light = light_of_codes(display, bits, channel);
  for (std::size_t v = 0; v < light.size(); ++v) points.push_back({double(v), light[v]});
  return points;
}

double most_codes(const Display& display) {
  int bits = 1;
  for (const int b : display.frame.packing.bits) bits = std::max(bits, b);
  return (1 << bits) - 1;
}

void draw_lights(SvgDrawing& svg, const PlotAxes& axes, const Points& lights,
                 std::string_view color) {
  constexpr std::size_t kMostDots = 64;
  Points lstar;
  for (const PlotPoint p : lights) lstar.push_back({p.x, lstar_from_luminance(p.y) / 100});
  if (lights.size() > kMostDots) {
    axes.curve(lights, {color, 1.8});
    return axes.curve(lstar, {color, 1.2, "4 3"});
  }
  for (const PlotPoint p : lights) svg.circle(axes.at(p), 3, {.fill = color});
  for (const PlotPoint p : lstar) {
    svg.circle(axes.at(p), 2.6, {.fill = "none", .stroke = {color, 1.2}});
  }
}

void draw_response(SvgDrawing& svg, const Display& display, SvgPoint corner) {
  const PlotAxes axes(svg, corner, kSide, kSide,
                      {.from = 0, .to = most_codes(display), .title = "code"},
                      {.from = 0, .to = 1, .title = "light; L* / 100", .step = 0.2});
  axes.grid();
  const bool three = display.palette.empty() && display.frame.packing.samples == 3 &&
                     !(has_one_response(display) &&
                       display.frame.packing.bits[0] == display.frame.packing.bits[1]);
  std::vector<PlotKey> keys;
  for (int c = 0; c < (three ? 3 : 1); ++c) {
    const auto i = static_cast<std::size_t>(c);
    const std::string_view color = three ? kThreeColors[i] : kOneColor;
    draw_lights(svg, axes, lights_of(display, c), color);
    keys.push_back({.text = three ? kChannelNames[i] : "light", .stroke = {color, 1.8}});
  }
  keys.push_back({.text = "L*", .stroke = {kOneColor, 1.2, "4 3"}});
  axes.frame();
  axes.legend(keys, PlotCorner::kTopLeft);
}

Points triangle(const Primaries& p) {
  return {{p.red.x, p.red.y}, {p.green.x, p.green.y}, {p.blue.x, p.blue.y}, {p.red.x, p.red.y}};
}

Points locus() {
  Points points;
  for (int nm = kLocusFirstNm; nm <= kLocusLastNm; nm += 2) {
    const Chromaticity c = spectral_locus(nm);
    points.push_back({c.x, c.y});
  }
  points.push_back(points.front());
  return points;
}

void draw_gamut(SvgDrawing& svg, const Display& display, SvgPoint corner) {
  const PlotAxes axes(svg, corner, kSide, kSide,
                      {.from = 0, .to = 0.9, .title = "x", .step = 0.1, .italic = true},
                      {.from = 0, .to = 0.9, .title = "y", .step = 0.1, .italic = true});
  axes.grid();
  axes.curve(locus(), {"#999", 1});
  std::vector<PlotKey> keys{{.text = "device", .stroke = {"#222", 2}}};
  for (std::size_t i = 0; i < std::size(kPictureSets); ++i) {
    axes.curve(triangle(find_by_name(primaries_list(), kPictureSets[i])->primaries),
               kSetStrokes[i]);
    keys.push_back({.text = kPictureSets[i], .stroke = kSetStrokes[i]});
  }
  axes.curve(triangle(display.primaries), {"#222", 2});
  svg.circle(axes.at({display.primaries.white.x, display.primaries.white.y}), 4,
             {.fill = "#fff", .stroke = {"#222", 1.2}});
  for (const CodeColor& entry : display.palette) {
    const Xyy c = xyz_to_xyy(entry.appearance);
    svg.circle(axes.at({c.x, c.y}), 3, {.fill = "#222"});
  }
  axes.frame();
  axes.legend(keys, PlotCorner::kTopRight);
}

void write_drawing(const std::string& path, const std::string& text, bool force) {
  OutputFile file(path, force);
  file.write(text);
  file.commit();
}

}  // namespace

std::string response_plot(const Display& display) {
  SvgDrawing svg(kLeft + kSide + kGap, kTop + kSide + kBottom, display.name);
  svg.text({kLeft, 26}, display.name, {.size = 14, .bold = true});
  draw_response(svg, display, {kLeft, kTop});
  return svg.document();
}

std::string device_plot(const Display& display) {
  constexpr double kFrame = kLeft + kSide + kGap;
  SvgDrawing svg(2 * kFrame, kTop + kSide + kBottom, display.name,
                 "Light of the codes, and the gamut beside those that pictures are made for");
  svg.text({kLeft, 26}, display.name, {.size = 14, .bold = true});
  draw_response(svg, display, {kLeft, kTop});
  draw_gamut(svg, display, {kFrame + kLeft, kTop});
  return svg.document();
}

std::string gamut_plot(const Display& display) {
  ChromaticityDiagram diagram;
  diagram.white = {"white", display.primaries.white};
  diagram.gamuts.push_back({display.name, display.primaries});
  for (const std::string_view name : kPictureSets) {
    diagram.gamuts.push_back({std::string(name), find_by_name(primaries_list(), name)->primaries});
  }
  diagram.temperatures = false;
  return chromaticity_diagram(diagram);
}

void write_device_plot(const Display& display, const std::string& output, bool force) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(output, ignored)) {
    refuse_other_drawings(output);
    return write_drawing(output, device_plot(display), force);
  }
  const std::filesystem::path folder(output);
  const std::string response = (folder / "response.svg").string();
  const std::string gamut = (folder / "gamut.svg").string();
  refuse_taken_outputs({response, gamut}, force);
  write_drawing(response, response_plot(display), force);
  write_drawing(gamut, gamut_plot(display), force);
}

}  // namespace tristim::tools
