#include "tools/shade_model.h"

#include <algorithm>
#include <stdexcept>

namespace tristim::tools {
namespace {

std::size_t width(const Column& column) {
  return std::max<std::size_t>(1, column.kind.parts.size());
}

std::size_t total_width(std::span<const Column> columns) {
  std::size_t sum = 0;
  for (const Column& column : columns) sum += width(column);
  return sum;
}

}  // namespace

std::vector<std::string> column_names(const Column& column) {
  if (column.kind.parts.empty()) return {std::string(column.name)};
  std::vector<std::string> names;
  for (const char part : column.kind.parts) names.push_back(std::string(column.name) + part);
  return names;
}

std::vector<std::string> column_names(std::span<const Column> columns) {
  std::vector<std::string> names;
  for (const Column& column : columns) {
    for (std::string& name : column_names(column)) names.push_back(std::move(name));
  }
  return names;
}

ShadeRow::ShadeRow(std::span<const Column> columns)
    : columns_(columns), numbers_(total_width(columns)), words_(numbers_.size()) {}

std::size_t ShadeRow::place(std::string_view name) const {
  std::size_t at = 0;
  for (const Column& column : columns_) {
    if (column.name == name) return at;
    at += width(column);
  }
  throw std::logic_error("no column " + std::string(name));
}

Eigen::Vector2d ShadeRow::point(std::string_view name) const {
  const std::size_t at = place(name);
  return {numbers_[at], numbers_[at + 1]};
}

Eigen::Vector3d ShadeRow::vector(std::string_view name) const {
  const std::size_t at = place(name);
  return {numbers_[at], numbers_[at + 1], numbers_[at + 2]};
}

Rgb ShadeRow::color(std::string_view name) const {
  const std::size_t at = place(name);
  return {numbers_[at], numbers_[at + 1], numbers_[at + 2]};
}

void ShadeRow::set(std::string_view name, const Eigen::Vector2d& value) {
  std::copy_n(value.data(), 2, numbers_.begin() + static_cast<std::ptrdiff_t>(place(name)));
}

void ShadeRow::set(std::string_view name, const Eigen::Vector3d& value) {
  std::copy_n(value.data(), 3, numbers_.begin() + static_cast<std::ptrdiff_t>(place(name)));
}

void ShadeRow::set(std::string_view name, const Rgb& value) {
  set(name, Eigen::Vector3d(value.r, value.g, value.b));
}

std::span<const ShadeModel> shade_models() {
  static const std::vector<ShadeModel> all = [] {
    std::vector<ShadeModel> models;
    for (const auto topic :
         {vector_models(), source_models(), reflection_models(), highlight_models(),
          microfacet_models(), appearance_models(), radiometry_models(), polygon_models(),
          spectral_models(), opengl_models(), raster_models(), scanline_models()}) {
      models.insert(models.end(), topic.begin(), topic.end());
    }
    return models;
  }();
  return all;
}

}  // namespace tristim::tools
