#pragma once

#include <algorithm>
#include <array>
#include <bit>

#include "tristim/color/models.h"

namespace tristim::detail {

// What turns the functions between value types into edges of the tree of models.

/// Components to a value type of up to four doubles, and back.
template <typename Color>
Color color_of(const Components& c) noexcept {
  std::array<double, sizeof(Color) / sizeof(double)> parts{};
  std::copy_n(c.begin(), parts.size(), parts.begin());
  return std::bit_cast<Color>(parts);
}

template <typename Color>
Components components_of(const Color& color) noexcept {
  const auto parts = std::bit_cast<std::array<double, sizeof(Color) / sizeof(double)>>(color);
  Components c{};
  std::copy_n(parts.begin(), parts.size(), c.begin());
  return c;
}

/// The type that a function takes first.
template <typename Result, typename First, typename... Rest>
First first_of(Result (*)(First, Rest...) noexcept);

/// The edge of a function from one value type to another: edge<rgb_to_hsv>.
template <auto function>
Components edge(const Components& c, const ModelContext& /*context*/) {
  return components_of(function(color_of<decltype(first_of(function))>(c)));
}

/// The edge of a function that takes the XYZ of the white as well: white_edge<xyz_to_lab>.
template <auto function>
Components white_edge(const Components& c, const ModelContext& context) {
  return components_of(
      function(color_of<decltype(first_of(function))>(c), white_xyz(context.white)));
}

/// Its matrix by the first three components.
Components matrix_edge(const Components& c, const ModelContext& context);

Components decode_edge(const Components& c, const ModelContext& context);
Components encode_edge(const Components& c, const ModelContext& context);

}  // namespace tristim::detail
