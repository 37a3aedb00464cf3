#include <array>
#include <cmath>

#include "tools/report.h"
#include "tools/shade_model.h"
#include "tristim/image/view.h"
#include "tristim/render/mach_bands.h"
#include "tristim/render/scanline.h"
#include "tristim/render/shared_vertices.h"

namespace tristim::tools {
namespace {

using Eigen::Vector2d;

constexpr Column kExpect[] = {{"expect", kJson}};
constexpr long long kMostSteps = 10'000'000;
constexpr long long kMostSide = 4096;

Pixel size_of(const JsonRow& in) {
  const std::vector<double> size = in.numbers("size");
  const auto good = [](double side) {
    return side == std::trunc(side) && side >= 0 && side <= kMostSide;
  };
  if (size.size() != 2 || !good(size[0]) || !good(size[1])) {
    in.refuse("size", "is no size", "give [width, height], whole numbers of 0 to 4096");
  }
  return {static_cast<long long>(size[0]), static_cast<long long>(size[1])};
}

std::vector<Vector2d> points_of(const JsonRow& in, std::string_view key) {
  std::vector<Vector2d> points;
  for (const std::vector<double>& p : in.number_lists(key, 2)) points.emplace_back(p[0], p[1]);
  return points;
}

std::vector<double> one_for_each(const JsonRow& in, std::string_view key, std::size_t count) {
  std::vector<double> values = in.numbers(key);
  if (values.size() != count) {
    in.refuse(key, "has " + std::to_string(values.size()) + " numbers",
              "give " + std::to_string(count) + ", one for each vertex");
  }
  return values;
}

Json numbers_json(std::span<const double> numbers) {
  Json list = Json::array();
  for (const double number : numbers) list.push_back(number_json(number));
  return list;
}

constexpr Column kScanlineIn[] = {{"size", kJson}, {"polygon", kJson}, {"I", kJson}};
Json scanline(const JsonRow& in) {
  const Pixel size = size_of(in);
  const std::vector<Vector2d> corners = points_of(in, "polygon");
  const std::vector<double> intensities = one_for_each(in, "I", corners.size());
  std::vector<GouraudVertex> polygon;
  for (std::size_t i = 0; i < corners.size(); ++i) polygon.push_back({corners[i], intensities[i]});
  Json rows = Json::array();
  for (const ScanlineRow& row :
       scanline_fill(static_cast<int>(size.x), static_cast<int>(size.y), polygon)) {
    rows.push_back({{"y", row.run.y},
                    {"x0", row.run.first},
                    {"u", number_json(row.span.u)},
                    {"w", number_json(row.span.w)},
                    {"t", number_json(row.span.t)},
                    {"IQ", number_json(row.span.i_q)},
                    {"IR", number_json(row.span.i_r)},
                    {"I", numbers_json(row.intensity)}});
  }
  return {{"expect", rows}};
}

void check_steps(const JsonRow& in, long long x_q, long long x_r) {
  if (x_r - x_q >= kMostSteps) in.refuse("xR", "is too far from xQ", "give 10 million pixels");
}

constexpr Column kDriftIn[] = {{"xQ", kJson}, {"xR", kJson}, {"IQ", kJson}, {"IR", kJson}};
Json drift(const JsonRow& in) {
  const long long x_q = in.integer("xQ");
  const long long x_r = in.integer("xR");
  check_steps(in, x_q, x_r);
  const IncrementalDrift drift = incremental_drift(x_q, x_r, in.number("IQ"), in.number("IR"));
  return {{"expect", {{"drift", number_json(drift.largest)}, {"bound", number_json(drift.bound)}}}};
}

constexpr Column kNormalsIn[] = {{"xQ", kJson}, {"xR", kJson}, {"NQ", kJson}, {"NR", kJson}};
Json normals(const JsonRow& in) {
  const long long x_q = in.integer("xQ");
  const long long x_r = in.integer("xR");
  check_steps(in, x_q, x_r);
  Json list = Json::array();
  for (const Eigen::Vector3d& n : normals_incremental(x_q, x_r, in.vector("NQ"), in.vector("NR"))) {
    list.push_back(vector_json(n));
  }
  return {{"expect", list}};
}

constexpr Column kBarycentricIn[] = {{"A", kPoint}, {"B", kPoint}, {"C", kPoint}, {"P", kPoint}};
constexpr Column kBarycentricOut[] = {{"alpha", kNumber},      {"beta", kNumber},
                                      {"gamma", kNumber},      {"alpha_axes", kNumber},
                                      {"beta_axes", kNumber},  {"gamma_axes", kNumber},
                                      {"combination", kPoint}, {"convex", kFlag}};
void barycentric_parts(const ShadeRow& in, ShadeRow& out) {
  const std::array<GouraudVertex, 3> triangle{{{in.point("A")}, {in.point("B")}, {in.point("C")}}};
  const Barycentric areas = barycentric(triangle, in.point("P"));
  const Barycentric axes = barycentric_by_axes(triangle, in.point("P"));
  out.set("alpha", areas.alpha);
  out.set("beta", areas.beta);
  out.set("gamma", areas.gamma);
  out.set("alpha_axes", axes.alpha);
  out.set("beta_axes", axes.beta);
  out.set("gamma_axes", axes.gamma);
  out.set("combination", combination(triangle, areas));
  out.set("convex", is_convex(areas));
}

constexpr Column kBoxIn[] = {{"size", kJson}, {"polygon", kJson}};
constexpr Column kBoxOut[] = {{"expect", kJson}, {"spans_y_x0_x1excl", kJson}};
Json box(const JsonRow& in) {
  const Pixel size = size_of(in);
  const int width = static_cast<int>(size.x);
  const int height = static_cast<int>(size.y);
  const std::vector<Vector2d> polygon = points_of(in, "polygon");
  const PixelBox box = bounding_box(width, height, polygon);
  Json runs = Json::array();
  for (const PixelRun& run : bounding_box_fill(width, height, polygon)) {
    runs.push_back({run.y, run.first, run.last});
  }
  return {{"expect", {box.first_x, box.first_y, box.last_x, box.last_y}},
          {"spans_y_x0_x1excl", runs}};
}

Pixel pixel_of(const JsonRow& in, std::string_view key, std::span<const double> p) {
  const auto good = [](double x) { return x == std::trunc(x) && std::fabs(x) <= kMostSteps; };
  if (p.size() == 2 && good(p[0]) && good(p[1])) {
    return {static_cast<long long>(p[0]), static_cast<long long>(p[1])};
  }
  in.refuse(key, "is no pixel", "give [x, y], whole numbers of 10 million at the most");
}

constexpr Column kOutlineIn[] = {{"size", kJson}, {"polygon", kJson}, {"seed", kJson}};
Json outline(const JsonRow& in) {
  const Pixel size = size_of(in);
  std::vector<Pixel> corners;
  for (const std::vector<double>& p : in.number_lists("polygon", 2)) {
    corners.push_back(pixel_of(in, "polygon", p));
  }
  const Pixel seed = pixel_of(in, "seed", in.numbers("seed"));
  const auto filled = [&](Connectivity connectivity) {
    return outline_fill(static_cast<int>(size.x), static_cast<int>(size.y), corners, seed,
                        connectivity);
  };
  return {{"expect",
           {{"conn4", filled(Connectivity::kFour)}, {"conn8", filled(Connectivity::kEight)}}}};
}

constexpr Column kJunctionsIn[] = {{"vertices", kJson}, {"faces", kJson}, {"I", kJson}};
Json junctions(const JsonRow& in) {
  const PolygonMesh mesh = polygon_mesh_of(in);
  std::vector<double> intensities(mesh.vertices.size());
  if (in.has("I")) intensities = one_for_each(in, "I", mesh.vertices.size());
  Json list = Json::array();
  for (const TJunction& junction : t_junctions(mesh)) {
    list.push_back({{"vertex", junction.vertex},
                    {"face", junction.face},
                    {"edge", junction.edge},
                    {"t", junction.t},
                    {"gap", number_json(intensity_gap(mesh, junction, intensities))}});
  }
  return {{"expect", list}};
}

constexpr Column kMachIn[] = {{"image", kJson}};
Json mach(const JsonRow& in) {
  const std::vector<std::vector<double>> rows = in.number_lists("image", 0);
  const std::size_t width = rows.empty() ? 0 : rows[0].size();
  Image intensity(static_cast<int>(width), static_cast<int>(rows.size()), 1);
  Image bands(static_cast<int>(width), static_cast<int>(rows.size()), 1);
  for (std::size_t y = 0; y < rows.size(); ++y) {
    if (rows[y].size() != width) in.refuse("image", "has rows of several lengths", "");
    for (std::size_t x = 0; x < width; ++x) {
      intensity.view().row(static_cast<int>(y))[x] = static_cast<float>(rows[y][x]);
    }
  }
  mach_bands(intensity.view(), bands.view());
  Json list = Json::array();
  for (int y = 0; y < bands.view().height; ++y) {
    const std::span<const float> row = bands.view().row(y);
    list.push_back(numbers_json(std::vector<double>(row.begin(), row.end())));
  }
  return {{"expect", list}};
}

constexpr std::array kModels{
    ShadeModel{"scanline", "IQ by u, IR by w, the first pixel by t, then I + (IR - IQ)/(xR - xQ)",
               "[Shoaff 4.1, UBC]", kScanlineIn, kExpect, nullptr, scanline},
    ShadeModel{"gouraud_drift", "of float additions; n 2^-24 (|step| + most intensity) bounds it",
               "[Shoaff 4.1]", kDriftIn, kExpect, nullptr, drift},
    ShadeModel{"normal_incremental", "normalize(N1 + (NR - NQ)/(xR - xQ))", "[Phong75, Shoaff 4.2]",
               kNormalsIn, kExpect, nullptr, normals},
    ShadeModel{"barycentric", "areas over the whole area; P = A + beta (B - A) + gamma (C - A)",
               "[UBC]", kBarycentricIn, kBarycentricOut, barycentric_parts},
    ShadeModel{"bounding_box", "[x0, y0, x1, y1), and which of its centres are inside", "[UBC]",
               kBoxIn, kBoxOut, nullptr, box},
    ShadeModel{"outline_fill", "midpoint lines, then a flood from the seed", "[UBC]", kOutlineIn,
               kExpect, nullptr, outline},
    ShadeModel{"t_junctions", "vertices inside of another face's edge; |I - (1 - t) IA - t IB|",
               "[Shoaff 4.3]", kJunctionsIn, kExpect, nullptr, junctions},
    ShadeModel{"mach_bands", "the negative second differences along x and y, added",
               "[Mach65, Shoaff 4.1]", kMachIn, kExpect, nullptr, mach},
};

}  // namespace

std::span<const ShadeModel> scanline_models() { return kModels; }

}  // namespace tristim::tools
