#include "tools/shade_json.h"

#include <cmath>

#include "tools/report.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

// A number, or one of the texts that stand for those that JSON has not.
std::optional<double> number_of(const Json& json) {
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) {
    const auto value = parse_number(json.get_ref<const std::string&>());
    if (value && std::isinf(*value)) return value;
  }
  return std::nullopt;
}

}  // namespace

JsonRow::JsonRow(const Json& object, std::string place)
    : object_(object), place_(std::move(place)) {
  if (!object_.is_object()) {
    throw Error(ErrorKind::kContent, place_, "is no object", "write { \"name\": value, ... }");
  }
}

void JsonRow::refuse(std::string_view key, const std::string& wrong,
                     const std::string& remedy) const {
  throw Error(ErrorKind::kContent, place_, "'" + std::string(key) + "' " + wrong, remedy);
}

bool JsonRow::has(std::string_view key) const { return object_.contains(key); }

const Json& JsonRow::value(std::string_view key) const {
  const auto found = object_.find(key);
  if (found == object_.end()) {
    refuse(key, "is missing", "add it or give --" + std::string(key));
  }
  return *found;
}

double JsonRow::number(std::string_view key) const {
  const auto number = number_of(value(key));
  if (!number) refuse(key, "is no number", "write digits without quotes");
  return *number;
}

double JsonRow::above_zero(std::string_view key) const {
  const double x = number(key);
  if (!(x > 0)) refuse(key, "is " + shortest(x), "give a number above 0");
  return x;
}

double JsonRow::not_negative(std::string_view key) const {
  const double x = number(key);
  if (!(x >= 0)) refuse(key, "is " + shortest(x), "give a number of 0 or more");
  return x;
}

long long JsonRow::integer(std::string_view key) const {
  constexpr double kLargest = 1e9;
  const double x = number(key);
  if (x != std::trunc(x) || !(std::fabs(x) <= kLargest)) {
    refuse(key, "is " + shortest(x), "give a whole number of 1e9 at the most");
  }
  return static_cast<long long>(x);
}

std::string JsonRow::text(std::string_view key) const {
  const Json& json = value(key);
  if (!json.is_string()) refuse(key, "is no text", "put it in quotes");
  return json.get<std::string>();
}

std::vector<double> JsonRow::numbers(std::string_view key) const {
  const Json& json = value(key);
  std::vector<double> all;
  for (const Json& part : json.is_array() ? json : Json()) {
    const auto number = number_of(part);
    if (!number) break;
    all.push_back(*number);
  }
  if (!json.is_array() || all.size() != json.size()) {
    refuse(key, "is no list of numbers", "write [1, 2, 3]");
  }
  return all;
}

Eigen::Vector3d JsonRow::vector(std::string_view key) const {
  const std::vector<double> v = numbers(key);
  if (v.size() != 3) refuse(key, "has " + std::to_string(v.size()) + " numbers", "give 3");
  return {v[0], v[1], v[2]};
}

Rgb JsonRow::color(std::string_view key) const {
  const Eigen::Vector3d v = vector(key);
  return {v.x(), v.y(), v.z()};
}

JsonRow JsonRow::object(std::string_view key) const {
  return {value(key), place_ + ", " + std::string(key)};
}

std::vector<JsonRow> JsonRow::objects(std::string_view key) const {
  const Json& json = value(key);
  if (!json.is_array()) refuse(key, "is no list", "write [{ ... }, { ... }]");
  std::vector<JsonRow> all;
  for (std::size_t i = 0; i < json.size(); ++i) {
    all.emplace_back(json[i], place_ + ", " + std::string(key) + "[" + std::to_string(i) + "]");
  }
  return all;
}

std::vector<std::string> JsonRow::texts(std::string_view key) const {
  const Json& json = value(key);
  std::vector<std::string> all;
  for (const Json& part : json.is_array() ? json : Json()) {
    if (part.is_string()) all.push_back(part.get<std::string>());
  }
  if (!json.is_array() || all.size() != json.size()) {
    refuse(key, "is no list of texts", "write [\"01\", \"10\"]");
  }
  return all;
}

std::vector<std::vector<double>> JsonRow::number_lists(std::string_view key,
                                                       std::size_t size) const {
  const Json& json = value(key);
  if (!json.is_array()) refuse(key, "is no list", "write [[1, 2, 3], [4, 5, 6]]");
  std::vector<std::vector<double>> all;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const std::string name = std::string(key) + "[" + std::to_string(i) + "]";
    const Json one{{name, json[i]}};
    all.push_back(JsonRow(one, place_).numbers(name));
    if (size != 0 && all.back().size() != size) {
      refuse(name, "has " + std::to_string(all.back().size()) + " numbers",
             "give " + std::to_string(size));
    }
  }
  return all;
}

std::vector<Eigen::Vector3d> JsonRow::vectors(std::string_view key) const {
  std::vector<Eigen::Vector3d> all;
  for (const std::vector<double>& v : number_lists(key, 3)) all.emplace_back(v[0], v[1], v[2]);
  return all;
}

PolygonMesh polygon_mesh_of(const JsonRow& in) {
  PolygonMesh mesh{.vertices = in.vectors("vertices"), .faces = {}, .planes = {}};
  const auto count = static_cast<double>(mesh.vertices.size());
  for (const std::vector<double>& numbers : in.number_lists("faces", 0)) {
    std::vector<std::size_t>& face = mesh.faces.emplace_back();
    for (const double number : numbers) {
      const bool good = number >= 0 && number < count && number == std::trunc(number);
      if (!good) in.refuse("faces", "names a vertex that is not there", "count from 0");
      face.push_back(static_cast<std::size_t>(number));
    }
  }
  return mesh;
}

Json vector_json(const Eigen::Vector3d& vector) {
  return {number_json(vector.x()), number_json(vector.y()), number_json(vector.z())};
}

Json color_json(const Rgb& color) { return vector_json({color.r, color.g, color.b}); }

}  // namespace tristim::tools
