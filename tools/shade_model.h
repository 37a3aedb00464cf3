#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tools/shade_json.h"
#include "tristim/color/rgb.h"

namespace tristim::tools {

/// What the values of a column may be.
struct ColumnKind {
  std::string_view parts;  // the last letters of its columns: "xyz"; "" for one column
  std::string_view range;  // in words
  bool (*allows)(double value) = nullptr;  // nullptr: any number
  bool is_text = false;
};

inline constexpr ColumnKind kNumber{"", "a number"};
inline constexpr ColumnKind kVector{"xyz", "a vector, used as given"};
inline constexpr ColumnKind kPoint{"xy", "a point of the plane"};
inline constexpr ColumnKind kColor{"rgb", "linear light or reflectance"};
inline constexpr ColumnKind kWord{"", "a name", nullptr, true};
inline constexpr ColumnKind kJson{"", "JSON", nullptr, true};
inline constexpr ColumnKind kAboveZero{"", "above 0", [](double x) { return x > 0; }};
inline constexpr ColumnKind kNotNegative{"", "0 or more", [](double x) { return x >= 0; }};
inline constexpr ColumnKind kFlag{"", "0 or 1", [](double x) { return x == 0 || x == 1; }};
inline constexpr ColumnKind kCutoff{"", "0 to 180", [](double x) { return x >= 0 && x <= 180; }};

/// A column, or the group of columns that hold the parts of a value: L is Lx, Ly and Lz.
struct Column {
  std::string_view name;
  ColumnKind kind;
};

/// The names of a group's columns.
std::vector<std::string> column_names(const Column& column);

/// The names of all columns, in order.
std::vector<std::string> column_names(std::span<const Column> columns);

/// The values of a row by the names of their columns.
class ShadeRow {
 public:
  explicit ShadeRow(std::span<const Column> columns);

  double number(std::string_view name) const { return numbers_[place(name)]; }
  bool flag(std::string_view name) const { return number(name) != 0; }
  Eigen::Vector2d point(std::string_view name) const;
  Eigen::Vector3d vector(std::string_view name) const;
  Rgb color(std::string_view name) const;
  const std::string& word(std::string_view name) const { return words_[place(name)]; }

  void set(std::string_view name, double value) { numbers_[place(name)] = value; }
  void set(std::string_view name, const Eigen::Vector2d& value);
  void set(std::string_view name, const Eigen::Vector3d& value);
  void set(std::string_view name, const Rgb& value);

  /// By the position of a column among all of them.
  double& at(std::size_t column) { return numbers_[column]; }
  std::string& word_at(std::size_t column) { return words_[column]; }
  std::span<const double> numbers() const { return numbers_; }

 private:
  std::size_t place(std::string_view name) const;

  std::span<const Column> columns_;
  std::vector<double> numbers_;
  std::vector<std::string> words_;
};

/// An illumination model, or another function of the documents. One of `evaluate` (of a CSV row)
/// and `answer` (of a JSON object) is there.
struct ShadeModel {
  std::string_view name;
  std::string_view formula;
  std::string_view source;
  std::span<const Column> inputs;
  std::span<const Column> outputs;
  void (*evaluate)(const ShadeRow& in, ShadeRow& out) = nullptr;
  Json (*answer)(const JsonRow& in) = nullptr;  // what follows the id
};

/// Every model, by topic. A new one is a row of its topic's list.
std::span<const ShadeModel> shade_models();

/// The topics' lists, each in a file of its own.
std::span<const ShadeModel> vector_models();
std::span<const ShadeModel> source_models();
std::span<const ShadeModel> reflection_models();
std::span<const ShadeModel> highlight_models();
std::span<const ShadeModel> microfacet_models();
std::span<const ShadeModel> appearance_models();
std::span<const ShadeModel> radiometry_models();
std::span<const ShadeModel> polygon_models();
std::span<const ShadeModel> spectral_models();
std::span<const ShadeModel> opengl_models();
std::span<const ShadeModel> raster_models();
std::span<const ShadeModel> scanline_models();

}  // namespace tristim::tools
