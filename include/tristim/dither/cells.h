#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace tristim {

/// A level of an n x n cell of pixels that have 2^m values each [Shoaff 2.1.2].
struct CellLevel {
  std::int64_t level = 0;  // k, 0 to n^2 (2^m - 1)
  double intensity = 0;    // k / (n^2 (2^m - 1)), in light
  int value = 0;           // of every pixel: k div n^2
  int raised = 0;          // how many pixels have one more: k mod n^2
};

/// How many levels such a cell has: n^2 (2^m - 1) + 1. Throws std::invalid_argument where n is not
/// 1 to 256 or m not 1 to 16.
std::int64_t cell_level_count(int n, int bits);

/// Level k of it, 0 <= k < cell_level_count().
CellLevel cell_level(int n, int bits, std::int64_t k);

/// How many colours cells of a device with so many bits for each of its channels make: the product
/// of the channels' levels. A 2 x 2 cell of a 3-bit device (1, 1, 1) has 5 x 5 x 5 = 125.
std::int64_t cell_color_count(int n, std::span<const int> bits);

}  // namespace tristim
