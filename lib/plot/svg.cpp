#include "tristim/plot/svg.h"

#include <array>
#include <charconv>
#include <cmath>

namespace tristim {
namespace {

// Fonts of the same proportions: what text_width measures holds for the first four.
constexpr std::string_view kFonts =
    "Helvetica,Arial,'Liberation Sans','Nimbus Sans','DejaVu Sans',sans-serif";

constexpr double kHaloOpacity = 0.75;

std::string number(double value) {
  std::string text = fixed_text(value, 2);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string attribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + xml_escaped(value) + "\"";
}

std::string attribute(std::string_view name, double value) {
  return attribute(name, number(value));
}

std::string stroke_attributes(const SvgStroke& stroke) {
  if (!(stroke.width > 0)) return {};
  std::string text = attribute("stroke", stroke.color) + attribute("stroke-width", stroke.width);
  if (stroke.opacity != 1) text += attribute("stroke-opacity", stroke.opacity);
  if (!stroke.dash.empty()) text += attribute("stroke-dasharray", stroke.dash);
  return text;
}

std::string paint_attributes(const SvgPaint& paint) {
  std::string text = attribute("fill", paint.fill);
  if (paint.opacity != 1) text += attribute("fill-opacity", paint.opacity);
  return text + stroke_attributes(paint.stroke);
}

bool finite(SvgPoint p) { return std::isfinite(p.x) && std::isfinite(p.y); }

bool finite(std::span<const SvgPoint> points) {
  for (const SvgPoint& p : points) {
    if (!finite(p)) return false;
  }
  return true;
}

std::string points_attribute(std::span<const SvgPoint> points) {
  std::string text;
  for (const SvgPoint& p : points) {
    text += (text.empty() ? "" : " ") + number(p.x) + "," + number(p.y);
  }
  return attribute("points", text);
}

}  // namespace

SvgDrawing::SvgDrawing(double width, double height, std::string_view title,
                       std::string_view description)
    : width_(width), height_(height) {
  const std::string w = number(width);
  const std::string h = number(height);
  head_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"" + w +
          "\" height=\"" + h + "\" viewBox=\"0 0 " + w + " " + h + "\" role=\"img\"" +
          attribute("font-family", kFonts) +
          " stroke-linejoin=\"round\" stroke-linecap=\"round\">\n<title>" + xml_escaped(title) +
          "</title>\n";
  if (!description.empty()) head_ += "<desc>" + xml_escaped(description) + "</desc>\n";
}

void SvgDrawing::polyline(std::span<const SvgPoint> points, const SvgStroke& stroke) {
  if (!(stroke.width > 0)) return;
  while (!points.empty()) {
    std::size_t count = 0;
    while (count < points.size() && finite(points[count])) ++count;
    if (count > 1) {
      body_ += "<polyline fill=\"none\"" + points_attribute(points.first(count)) +
               stroke_attributes(stroke) + "/>\n";
    }
    points = points.subspan(count < points.size() ? count + 1 : count);
  }
}

void SvgDrawing::line(SvgPoint from, SvgPoint to, const SvgStroke& stroke) {
  if (!(stroke.width > 0) || !finite(from) || !finite(to)) return;
  body_ += "<line" + attribute("x1", from.x) + attribute("y1", from.y) + attribute("x2", to.x) +
           attribute("y2", to.y) + stroke_attributes(stroke) + "/>\n";
}

void SvgDrawing::polygon(std::span<const SvgPoint> points, const SvgPaint& paint) {
  if (!finite(points)) return;
  body_ += "<polygon" + points_attribute(points) + paint_attributes(paint) + "/>\n";
}

void SvgDrawing::rectangle(SvgPoint corner, double width, double height, const SvgPaint& paint) {
  if (!finite(corner)) return;
  body_ += "<rect" + attribute("x", corner.x) + attribute("y", corner.y) +
           attribute("width", width) + attribute("height", height) + paint_attributes(paint) +
           "/>\n";
}

void SvgDrawing::circle(SvgPoint centre, double radius, const SvgPaint& paint) {
  if (!finite(centre)) return;
  body_ += "<circle" + attribute("cx", centre.x) + attribute("cy", centre.y) +
           attribute("r", radius) + paint_attributes(paint) + "/>\n";
}

void SvgDrawing::gradient(SvgPoint corner, double width, double height,
                          std::span<const SvgStop> stops) {
  if (!finite(corner)) return;
  const std::string id = "g" + std::to_string(++ids_);
  body_ += "<linearGradient" + attribute("id", id) + ">";
  for (const SvgStop& stop : stops) {
    body_ += "<stop" + attribute("offset", fixed_text(stop.offset, 4)) +
             attribute("stop-color", stop.color) + "/>";
  }
  body_ += "</linearGradient>\n";
  rectangle(corner, width, height, {.fill = "url(#" + id + ")"});
}

void SvgDrawing::text(SvgPoint place, std::string_view text, const SvgFont& font) {
  if (!finite(place)) return;
  body_ += "<text" + attribute("x", place.x) + attribute("y", place.y) +
           attribute("font-size", font.size) + attribute("fill", font.color);
  if (font.anchor != SvgAnchor::kStart) {
    body_ += attribute("text-anchor", font.anchor == SvgAnchor::kMiddle ? "middle" : "end");
  }
  if (font.bold) body_ += attribute("font-weight", "bold");
  if (font.italic) body_ += attribute("font-style", "italic");
  if (font.turn_deg != 0) {
    body_ += attribute("transform", "rotate(" + number(font.turn_deg) + " " + number(place.x) +
                                        " " + number(place.y) + ")");
  }
  if (!font.halo.empty()) {
    body_ += stroke_attributes({font.halo, font.size / 4, {}, kHaloOpacity}) +
             attribute("paint-order", "stroke");
  }
  body_ += ">" + xml_escaped(text) + "</text>\n";
}

void SvgDrawing::begin_clip(std::span<const SvgPoint> polygon, double opacity) {
  const std::string id = "c" + std::to_string(++ids_);
  body_ += "<clipPath" + attribute("id", id) + "><polygon" +
           points_attribute(finite(polygon) ? polygon : std::span<const SvgPoint>{}) +
           "/></clipPath>\n<g" + attribute("clip-path", "url(#" + id + ")") +
           (opacity != 1 ? attribute("opacity", opacity) : "") + ">\n";
}

void SvgDrawing::end_clip() { body_ += "</g>\n"; }

std::string SvgDrawing::document() const { return head_ + body_ + "</svg>\n"; }

std::string fixed_text(double value, int decimals) {
  std::array<char, 400> buffer{};  // 309 digits before the point
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                    std::chars_format::fixed, decimals);
  const std::string text(buffer.data(), result.ptr);
  const bool zero = text.find_first_not_of("-0.") == std::string::npos;
  return zero && text.starts_with('-') ? text.substr(1) : text;
}

}  // namespace tristim
