#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "tristim/color/rgb.h"
#include "tristim/light/normals.h"

namespace tristim::tools {

using Json = nlohmann::ordered_json;

/// An object of the input, or one inside it, that knows its place for messages:
/// "in.json, object 2, lights[1]". Every reader throws Error (kContent) where a member is missing
/// or something else than asked for.
class JsonRow {
 public:
  JsonRow(const Json& object, std::string place);

  bool has(std::string_view key) const;
  const Json& value(std::string_view key) const;
  double number(std::string_view key) const;
  double above_zero(std::string_view key) const;
  double not_negative(std::string_view key) const;
  long long integer(std::string_view key) const;
  std::string text(std::string_view key) const;
  Eigen::Vector3d vector(std::string_view key) const;
  Rgb color(std::string_view key) const;
  JsonRow object(std::string_view key) const;
  std::vector<JsonRow> objects(std::string_view key) const;
  std::vector<std::string> texts(std::string_view key) const;

  /// A list of numbers, and a list of lists of `size` numbers each (0: of any length).
  std::vector<double> numbers(std::string_view key) const;
  std::vector<std::vector<double>> number_lists(std::string_view key, std::size_t size) const;
  std::vector<Eigen::Vector3d> vectors(std::string_view key) const;

  /// Throws Error (kContent): the member `key` is wrong in that way.
  [[noreturn]] void refuse(std::string_view key, const std::string& wrong,
                           const std::string& remedy) const;

 private:
  const Json& object_;
  std::string place_;
};

/// The mesh of the members "vertices" and "faces", which count them from 0.
PolygonMesh polygon_mesh_of(const JsonRow& in);

/// Vectors and colours as lists of numbers; NaN is null, infinity "inf".
Json vector_json(const Eigen::Vector3d& vector);
Json color_json(const Rgb& color);

}  // namespace tristim::tools
