#include <algorithm>
#include <array>

#include "tools/report.h"
#include "tools/shade_model.h"
#include "tristim/render/gouraud.h"
#include "tristim/render/raster.h"

namespace tristim::tools {
namespace {

using Eigen::Vector2d;

constexpr Column kExpect[] = {{"expect", kJson}};
constexpr long long kMostPixels = 10'000'000;

constexpr Column kGouraudIn[] = {
    {"A", kPoint},   {"B", kPoint}, {"C", kPoint},      {"IA", kNumber},    {"IB", kNumber},
    {"IC", kNumber}, {"P", kPoint}, {"wA", kAboveZero}, {"wB", kAboveZero}, {"wC", kAboveZero}};
constexpr Column kGouraudOut[] = {{"xQ", kNumber},    {"xR", kNumber},
                                  {"IQ", kNumber},    {"IR", kNumber},
                                  {"t", kNumber},     {"IP", kNumber},
                                  {"alpha", kNumber}, {"beta", kNumber},
                                  {"gamma", kNumber}, {"IP_perspective", kNumber}};
void gouraud(const ShadeRow& in, ShadeRow& out) {
  const std::array<GouraudVertex, 3> triangle{{{in.point("A"), in.number("IA"), in.number("wA")},
                                               {in.point("B"), in.number("IB"), in.number("wB")},
                                               {in.point("C"), in.number("IC"), in.number("wC")}}};
  const Vector2d p = in.point("P");
  const GouraudSpan span = gouraud_span(triangle, p);
  const Barycentric parts = barycentric(triangle, p);
  out.set("xQ", span.x_q);
  out.set("xR", span.x_r);
  out.set("IQ", span.i_q);
  out.set("IR", span.i_r);
  out.set("t", span.t);
  out.set("IP", span.i_p);
  out.set("alpha", parts.alpha);
  out.set("beta", parts.beta);
  out.set("gamma", parts.gamma);
  out.set("IP_perspective", perspective_intensity(triangle, p));
}

constexpr Column kIncrementalIn[] = {{"xQ", kJson}, {"xR", kJson}, {"IQ", kJson}, {"IR", kJson}};
Json incremental(const JsonRow& in) {
  const long long x_q = in.integer("xQ");
  const long long x_r = in.integer("xR");
  if (x_r - x_q >= kMostPixels) in.refuse("xR", "is too far from xQ", "give 10 million pixels");
  Json list = Json::array();
  for (const double i : gouraud_incremental(x_q, x_r, in.number("IQ"), in.number("IR"))) {
    list.push_back(number_json(i));
  }
  return {{"expect", list}};
}

Vector2d point_of(const JsonRow& in, std::string_view key) {
  const std::vector<double> p = in.numbers(key);
  if (p.size() != 2) in.refuse(key, "has " + std::to_string(p.size()) + " numbers", "give 2");
  return {p[0], p[1]};
}

constexpr Column kOrientationIn[] = {
    {"quad", kJson}, {"I", kJson}, {"P", kJson}, {"rotations_deg", kJson}};
Json orientation(const JsonRow& in) {
  const auto corners = in.number_lists("quad", 2);
  const std::vector<double> intensities = in.numbers("I");
  if (intensities.size() != corners.size()) in.refuse("I", "is not one for each corner", "");
  std::vector<GouraudVertex> quad;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    quad.push_back({{corners[i][0], corners[i][1]}, intensities[i]});
  }
  constexpr double kHairDeg = 1e-7;  // so that no edge is level, as the published examples do it
  std::vector<double> turned;
  for (const double angle : in.numbers("rotations_deg")) {
    turned.push_back(gouraud_turned(quad, point_of(in, "P"), angle + kHairDeg));
  }
  if (turned.empty()) return {{"expect", Json::array()}, {"spread", 0}};
  const auto [least, most] = std::minmax_element(turned.begin(), turned.end());
  return {{"expect", turned}, {"spread", *most - *least}};
}

constexpr Column kViewportIn[] = {{"xN", kNumber},      {"yN", kNumber},       {"zN", kNumber},
                                  {"width_a", kNumber}, {"height_b", kNumber}, {"c", kNumber},
                                  {"d", kNumber}};
constexpr Column kViewportOut[] = {{"xD", kNumber}, {"yD", kNumber}, {"zD", kNumber}};
void viewport(const ShadeRow& in, ShadeRow& out) {
  const Viewport window{in.number("width_a"), in.number("height_b"), in.number("c"),
                        in.number("d")};
  const Eigen::Vector3d device =
      to_viewport(window, {in.number("xN"), in.number("yN"), in.number("zN")});
  out.set("xD", device.x());
  out.set("yD", device.y());
  out.set("zD", device.z());
}

Pixel pixel_of(const JsonRow& in, std::string_view key) {
  const Vector2d p = point_of(in, key);
  const Json parts{{"x", p.x()}, {"y", p.y()}};
  const JsonRow named(parts, std::string(key));
  return {named.integer("x"), named.integer("y")};
}

constexpr Column kLineIn[] = {{"p0", kJson}, {"p1", kJson}};
Json line(const JsonRow& in) {
  const Pixel p0 = pixel_of(in, "p0");
  const Pixel p1 = pixel_of(in, "p1");
  if (std::max(std::llabs(p1.x - p0.x), std::llabs(p1.y - p0.y)) > kMostPixels) {
    in.refuse("p1", "is too far from p0", "give 10 million pixels at the most");
  }
  Json pixels = Json::array();
  for (const Pixel& p : midpoint_line(p0, p1)) pixels.push_back(Json::array({p.x, p.y}));
  return {{"expect", pixels}};
}

constexpr Column kParityIn[] = {{"size", kJson}, {"polygon", kJson}};
constexpr Column kParityOut[] = {{"expect_spans_y_x0_x1excl", kJson}};
Json parity(const JsonRow& in) {
  constexpr long long kMostSide = 65536;
  const Pixel size = pixel_of(in, "size");
  if (size.x < 0 || size.y < 0 || size.x > kMostSide || size.y > kMostSide) {
    in.refuse("size", "is out of range", "give 0 to 65536 a side");
  }
  std::vector<Vector2d> polygon;
  for (const std::vector<double>& p : in.number_lists("polygon", 2))
    polygon.emplace_back(p[0], p[1]);
  Json runs = Json::array();
  for (const PixelRun& run :
       parity_fill(static_cast<int>(size.x), static_cast<int>(size.y), polygon)) {
    runs.push_back(Json::array({run.y, run.first, run.last}));
  }
  return {{"expect_spans_y_x0_x1excl", runs}};
}

constexpr Column kFloodIn[] = {{"image", kJson}, {"seed", kJson}};
Json flood(const JsonRow& in) {
  const std::vector<std::string> image = in.texts("image");
  for (const std::string& row : image) {
    if (row.size() != image[0].size()) in.refuse("image", "has rows of several lengths", "");
  }
  const Pixel seed = pixel_of(in, "seed");
  return {{"expect",
           {{"conn4", flood_fill(image, seed.x, seed.y, Connectivity::kFour)},
            {"conn8", flood_fill(image, seed.x, seed.y, Connectivity::kEight)}}}};
}

constexpr std::array kModels{
    ShadeModel{"gouraud",
               "IQ = (1 - u) IA + u IB, IP = (1 - t) IQ + t IR; sum(part I/w)/sum(part/w)",
               "[Shoaff 4.1, Gouraud71, UBC]", kGouraudIn, kGouraudOut, gouraud},
    ShadeModel{"gouraud_incremental", "I2 = I1 + (IR - IQ)/(xR - xQ)", "[Shoaff 4.1]",
               kIncrementalIn, kExpect, nullptr, incremental},
    ShadeModel{"orientation_dependence",
               "IP of a polygon turned about the origin, 1e-7 degrees further than asked",
               "[Shoaff 4.3]", kOrientationIn, kExpect, nullptr, orientation},
    ShadeModel{"viewport", "a xN/2 + a/2 + c, -b yN/2 + b/2 + d, zN/2 + 1/2", "[OpenGL 2.10.1]",
               kViewportIn, kViewportOut, viewport},
    ShadeModel{"midpoint_lines", "the shorter side steps past the midpoint", "[UBC, Bresenham65]",
               kLineIn, kExpect, nullptr, line},
    ShadeModel{"parity_fill", "centres that an odd number of crossings are left of", "[UBC]",
               kParityIn, kParityOut, nullptr, parity},
    ShadeModel{"flood_fill", "4 or 8 neighbours, until a 1 is met", "[UBC]", kFloodIn, kExpect,
               nullptr, flood},
};

}  // namespace

std::span<const ShadeModel> raster_models() { return kModels; }

}  // namespace tristim::tools
