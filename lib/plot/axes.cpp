#include "tristim/plot/axes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace tristim {
namespace {

constexpr int kParts = 6;
constexpr double kTick = 5;  // pixels
constexpr double kNumberSize = 11;
constexpr double kTitleSize = 13;
constexpr double kTitleGap = 44;  // from the frame to the baseline of the title
constexpr SvgStroke kLine{"#333", 1};
constexpr double kLegendSize = 11;
constexpr double kLegendRow = 17;     // pixels from key to key
constexpr double kLegendSample = 22;  // length of a key's line
constexpr double kLegendPad = 8;

// Decimals that show a step: 0.25 has two.
int decimals_of(double step) {
  int decimals = 0;
  for (double scaled = step; decimals < 12 && std::fabs(scaled - std::round(scaled)) > 1e-6 * step;
       scaled *= 10) {
    ++decimals;
  }
  return decimals;
}

double step_of(const PlotAxis& axis) {
  return axis.step > 0 ? axis.step : nice_step(axis.to - axis.from, kParts);
}

std::vector<double> ticks_of(const PlotAxis& axis) {
  return axis_ticks(axis.from, axis.to, step_of(axis));
}

std::string tick_text(const PlotAxis& axis, double tick) {
  return fixed_text(tick, decimals_of(step_of(axis)));
}

SvgFont number_font(SvgAnchor anchor) { return {.size = kNumberSize, .anchor = anchor}; }

}  // namespace

PlotAxes::PlotAxes(SvgDrawing& svg, SvgPoint corner, double width, double height, const PlotAxis& x,
                   const PlotAxis& y)
    : svg_(svg), corner_(corner), width_(width), height_(height), x_(x), y_(y) {
  for (const PlotAxis& axis : {x, y}) {
    if (!(axis.from < axis.to) || !std::isfinite(axis.to - axis.from)) {
      throw std::invalid_argument("axis: must go from a finite number to a greater one");
    }
  }
}

SvgPoint PlotAxes::at(PlotPoint point) const noexcept {
  return {corner_.x + width_ * (point.x - x_.from) / (x_.to - x_.from),
          corner_.y + height_ * (y_.to - point.y) / (y_.to - y_.from)};
}

PlotPoint PlotAxes::point(SvgPoint place) const noexcept {
  return {x_.from + (x_.to - x_.from) * (place.x - corner_.x) / width_,
          y_.to - (y_.to - y_.from) * (place.y - corner_.y) / height_};
}

std::vector<SvgPoint> PlotAxes::at(std::span<const PlotPoint> points) const {
  std::vector<SvgPoint> places;
  places.reserve(points.size());
  for (const PlotPoint& p : points) places.push_back(at(p));
  return places;
}

void PlotAxes::grid(const SvgStroke& stroke) const {
  for (const double x : ticks_of(x_)) svg_.line(at({x, y_.from}), at({x, y_.to}), stroke);
  for (const double y : ticks_of(y_)) svg_.line(at({x_.from, y}), at({x_.to, y}), stroke);
}

void PlotAxes::frame() const {
  svg_.rectangle(corner_, width_, height_, {.stroke = kLine});
  for (const double tick : ticks_of(x_)) {
    const SvgPoint p = at({tick, y_.from});
    svg_.line(p, {p.x, p.y + kTick}, kLine);
    svg_.text({p.x, p.y + kTick + kNumberSize + 1}, tick_text(x_, tick),
              number_font(SvgAnchor::kMiddle));
  }
  for (const double tick : ticks_of(y_)) {
    const SvgPoint p = at({x_.from, tick});
    svg_.line(p, {p.x - kTick, p.y}, kLine);
    svg_.text({p.x - kTick - 3, p.y + 0.36 * kNumberSize}, tick_text(y_, tick),
              number_font(SvgAnchor::kEnd));
  }
  const SvgFont font{.size = kTitleSize, .anchor = SvgAnchor::kMiddle};
  SvgFont title = font;
  title.italic = x_.italic;
  svg_.text({corner_.x + width_ / 2, corner_.y + height_ + kTitleGap - 6}, x_.title, title);
  title.italic = y_.italic;
  title.turn_deg = -90;
  svg_.text({corner_.x - kTitleGap, corner_.y + height_ / 2}, y_.title, title);
}

void PlotAxes::curve(std::span<const PlotPoint> points, const SvgStroke& stroke) const {
  const SvgPoint far{corner_.x + width_, corner_.y + height_};
  const SvgPoint frame[] = {corner_, {far.x, corner_.y}, far, {corner_.x, far.y}};
  svg_.begin_clip(frame);
  svg_.polyline(at(points), stroke);
  svg_.end_clip();
}

PlotBox PlotAxes::legend(std::span<const PlotKey> keys, PlotCorner corner) const {
  const PlotBox size = legend_box(keys, {});
  const bool left = corner == PlotCorner::kTopLeft || corner == PlotCorner::kBottomLeft;
  const bool top = corner == PlotCorner::kTopLeft || corner == PlotCorner::kTopRight;
  const SvgPoint place{
      left ? corner_.x + kLegendPad : corner_.x + width_ - size.width - kLegendPad,
      top ? corner_.y + kLegendPad : corner_.y + height_ - size.height - kLegendPad};
  draw_legend(svg_, keys, place);
  return legend_box(keys, place);
}

PlotBox legend_box(std::span<const PlotKey> keys, SvgPoint corner) {
  constexpr double kWider = 1.15;  // DejaVu Sans, where there is no Helvetica
  double widest = 0;
  for (const PlotKey& key : keys) widest = std::max(widest, text_width(key.text));
  return {corner, 3 * kLegendPad + kLegendSample + kWider * kLegendSize * widest,
          2 * kLegendPad - 4 + kLegendRow * static_cast<double>(keys.size())};
}

void draw_legend(SvgDrawing& svg, std::span<const PlotKey> keys, SvgPoint corner) {
  const PlotBox box = legend_box(keys, corner);
  svg.rectangle(corner, box.width, box.height,
                {.fill = "#fff", .stroke = {"#ccc", 0.8}, .opacity = 0.88});
  const double x = corner.x + kLegendPad;
  double y = corner.y + kLegendPad - 2 + kLegendRow / 2;
  for (const PlotKey& key : keys) {
    svg.line({x, y}, {x + kLegendSample, y}, key.stroke);
    if (!key.fill.empty()) {
      svg.circle({x + kLegendSample / 2, y}, 3.5, {.fill = key.fill, .stroke = {"#222", 0.8}});
    }
    svg.text({x + kLegendSample + kLegendPad, y + 0.36 * kLegendSize}, key.text,
             {.size = kLegendSize});
    y += kLegendRow;
  }
}

double nice_step(double range, int parts) {
  const double wanted = range / parts;
  double power = 1;
  while (power > wanted) power /= 10;
  while (power * 10 <= wanted) power *= 10;
  const double mantissa = wanted / power;
  return power * (mantissa < 1.5 ? 1 : mantissa < 3.5 ? 2 : mantissa < 7.5 ? 5 : 10);
}

std::vector<double> axis_ticks(double from, double to, double step) {
  const double slack = 1e-9;  // of a step: 0.3 / 0.1 is a little below 3
  std::vector<double> ticks;
  for (double n = std::ceil(from / step - slack); n <= to / step + slack; ++n) {
    ticks.push_back(n * step);
  }
  return ticks;
}

}  // namespace tristim
