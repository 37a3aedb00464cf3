#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tristim::detail {

/// The numbers of a glTF accessor, whose bytes were checked to be there.
struct GltfValues {
  std::span<const unsigned char> bytes;
  std::size_t stride = 0;   // bytes from one element to the next
  std::size_t count = 0;    // elements
  int component_type = 0;   // 5120 byte, 5121 ubyte, 5122 short, 5123 ushort, 5125 uint, 5126 float
  int components = 0;       // of an element
  bool normalized = false;  // integers stand for 0..1 or -1..1
};

/// How many bytes a component has; 0 for an unknown type.
std::size_t component_bytes(int component_type) noexcept;

/// A component of an element [GLTF2 3.6.2].
double gltf_number(const GltfValues& values, std::size_t element, int component) noexcept;

/// An element of one unsigned integer.
std::uint32_t gltf_index(const GltfValues& values, std::size_t element) noexcept;

/// The numbers of the corners of triangles, three each, of the modes 4 (triangles), 5 (strips) and
/// 6 (fans) [GLTF2 3.7.2.1].
std::vector<std::uint32_t> triangle_corners(const std::vector<std::uint32_t>& indices, int mode);

}  // namespace tristim::detail
