#include "lib/render/io/gltf_values.h"

#include <algorithm>
#include <cstring>

namespace tristim::detail {
namespace {

template <typename T>
T value_of(const unsigned char* at) noexcept {
  T value;
  std::memcpy(&value, at, sizeof value);  // glTF is little-endian, as all we run on
  return value;
}

const unsigned char* place(const GltfValues& values, std::size_t element, int component) noexcept {
  return values.bytes.data() + element * values.stride +
         static_cast<std::size_t>(component) * component_bytes(values.component_type);
}

}  // namespace

std::size_t component_bytes(int component_type) noexcept {
  switch (component_type) {
    case 5120:
    case 5121:
      return 1;
    case 5122:
    case 5123:
      return 2;
    case 5125:
    case 5126:
      return 4;
    default:
      return 0;
  }
}

double gltf_number(const GltfValues& values, std::size_t element, int component) noexcept {
  const unsigned char* at = place(values, element, component);
  const auto scaled = [&](double value, double most) {
    return values.normalized ? std::max(value / most, -1.0) : value;
  };
  switch (values.component_type) {
    case 5120:
      return scaled(value_of<std::int8_t>(at), 127);
    case 5121:
      return scaled(value_of<std::uint8_t>(at), 255);
    case 5122:
      return scaled(value_of<std::int16_t>(at), 32767);
    case 5123:
      return scaled(value_of<std::uint16_t>(at), 65535);
    case 5125:
      return scaled(value_of<std::uint32_t>(at), 4294967295.0);
    default:
      return double{value_of<float>(at)};
  }
}

std::uint32_t gltf_index(const GltfValues& values, std::size_t element) noexcept {
  const unsigned char* at = place(values, element, 0);
  switch (values.component_type) {
    case 5121:
      return *at;
    case 5123:
      return value_of<std::uint16_t>(at);
    default:
      return value_of<std::uint32_t>(at);
  }
}

std::vector<std::uint32_t> triangle_corners(const std::vector<std::uint32_t>& indices, int mode) {
  constexpr int kTriangles = 4;
  constexpr int kStrip = 5;
  std::vector<std::uint32_t> corners;
  if (mode == kTriangles) {
    corners = indices;
    corners.resize(corners.size() / 3 * 3);
    return corners;
  }
  for (std::size_t i = 2; i < indices.size(); ++i) {
    // Every other triangle of a strip runs the other way.
    const bool odd = i % 2 == 1;
    if (mode == kStrip) {
      corners.insert(corners.end(),
                     {indices[i - 2], indices[odd ? i : i - 1], indices[odd ? i - 1 : i]});
    } else {
      corners.insert(corners.end(), {indices[0], indices[i - 1], indices[i]});
    }
  }
  return corners;
}

}  // namespace tristim::detail
