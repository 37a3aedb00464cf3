#include <algorithm>
#include <array>
#include <cmath>

#include "lib/plot/diagram_canvas.h"
#include "tristim/color/primaries.h"
#include "tristim/color/transfer.h"

namespace tristim::detail {
namespace {

constexpr double kRow = 2;            // pixels between rows of colour
constexpr double kSample = 5;         // pixels between colours of a row
constexpr double kSeen = 1.5;         // codes that a gradient may be off
constexpr double kPale = 0.78;        // opacity: lines and text stand out
using Codes = std::array<double, 3>;  // of sRGB, [0, 255]

// Brightest at full strength; what sRGB would need negative light for is clipped.
Codes display_codes(Chromaticity c) {
  static const Eigen::Matrix3d matrix = rgb_from_xyz(Primaries{});
  const Eigen::Vector3d light = (matrix * Eigen::Vector3d(c.x, c.y, 1 - c.x - c.y)).cwiseMax(0.0);
  const double brightest = std::max(light.maxCoeff(), 1e-9);
  Codes codes{};
  for (int i = 0; i < 3; ++i) {
    codes[static_cast<std::size_t>(i)] = 255 * srgb_encode(light[i] / brightest);
  }
  return codes;
}

std::string hex(const Codes& codes) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "#";
  for (const double code : codes) {
    const auto value = static_cast<std::size_t>(std::lround(code));
    text += kDigits[value / 16];
    text += kDigits[value % 16];
  }
  return text;
}

struct Sample {
  double offset;
  Codes codes;
};

// Whether the straight line from `a` to `b` shows all samples between them.
bool straight(const std::vector<Sample>& samples, std::size_t a, std::size_t b) {
  for (std::size_t i = a + 1; i < b; ++i) {
    const double t =
        (samples[i].offset - samples[a].offset) / (samples[b].offset - samples[a].offset);
    for (std::size_t k = 0; k < 3; ++k) {
      const double line = samples[a].codes[k] + t * (samples[b].codes[k] - samples[a].codes[k]);
      if (std::fabs(line - samples[i].codes[k]) > kSeen) return false;
    }
  }
  return true;
}

std::vector<SvgStop> stops_of(const std::vector<Sample>& samples) {
  std::vector<SvgStop> stops{{samples.front().offset, hex(samples.front().codes)}};
  for (std::size_t kept = 0; kept + 1 < samples.size();) {
    std::size_t next = kept + 1;
    while (next + 1 < samples.size() && straight(samples, kept, next + 1)) ++next;
    stops.push_back({samples[next].offset, hex(samples[next].codes)});
    kept = next;
  }
  return stops;
}

// Where a row of the drawing crosses an outline: its leftmost and rightmost place.
struct Span {
  double left = 1e9, right = -1e9;
};

Span span_at(const std::vector<SvgPoint>& outline, double y) {
  Span span;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const SvgPoint a = outline[i];
    const SvgPoint b = outline[(i + 1) % outline.size()];
    if ((a.y <= y) == (b.y <= y)) continue;
    const double x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
    span.left = std::min(span.left, x);
    span.right = std::max(span.right, x);
  }
  return span;
}

void draw_row(const DiagramCanvas& canvas, const Span& span, double y) {
  const double left = span.left - kSample;
  const double width = span.right - span.left + 2 * kSample;
  const int count = std::max(2, static_cast<int>(width / kSample) + 1);
  std::vector<Sample> samples;
  for (int i = 0; i < count; ++i) {
    const double offset = static_cast<double>(i) / (count - 1);
    const PlotPoint p = canvas.axes.point({left + offset * width, y + kRow / 2});
    samples.push_back({offset, display_codes(canvas.plane.chromaticity({p.x, p.y}))});
  }
  // Each row covers the next as well, which is drawn over it: no seams.
  canvas.svg.gradient({left, y}, width, 2 * kRow, stops_of(samples));
}

}  // namespace

std::string display_color(Chromaticity c) { return hex(display_codes(c)); }

void draw_inside(const DiagramCanvas& canvas) {
  const std::vector<SvgPoint> outline = canvas.at(locus_chromaticities());
  const auto [top, bottom] = std::minmax_element(outline.begin(), outline.end(),
                                                 [](SvgPoint a, SvgPoint b) { return a.y < b.y; });
  canvas.svg.begin_clip(outline, kPale);
  for (double y = std::floor(top->y) - kRow; y < bottom->y; y += kRow) {
    Span span = span_at(outline, y + kRow / 2);
    const Span below = span_at(outline, y + kRow);
    span = {std::min(span.left, below.left), std::max(span.right, below.right)};
    if (span.left < span.right) draw_row(canvas, span, y);
  }
  canvas.svg.end_clip();
}

}  // namespace tristim::detail
