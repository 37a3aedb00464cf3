#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lib/lut/io/text_lines.h"
#include "tristim/lut/lut.h"

// What several formats do with tables.
namespace tristim::detail {

/// The steps of a Lut that is a table, a shaper and a table, or a shaper alone; nullptr for what it
/// does not have. A Lut of other steps has none of them.
struct LutParts {
  const LutPoints* points = nullptr;
  const Lut1D* curves = nullptr;
  const Lut3D* cube = nullptr;
};
LutParts parts_of(const Lut& lut) noexcept;

/// Whether the three channels have the same range, or the same curve over it.
bool equal_channels(const LutRange& range) noexcept;
bool equal_channels(const Lut1D& curves) noexcept;

/// Where colour `index` of a cube with red fastest lies when blue is fastest.
std::size_t blue_fastest(std::size_t index, std::size_t size) noexcept;

/// Reads rows of three numbers, as many as a table of `size` has; each line is a row.
Lut1D read_curve_rows(TextLines& lines, int size);
Lut3D read_cube_rows(TextLines& lines, int size);

/// The integer from 0 to `most` that stands for a value in [0, 1], rounded half up.
std::uint16_t table_code(float value, int most) noexcept;

/// The highest integer of so many bits.
constexpr int most_of_bits(int bits) noexcept { return (1 << bits) - 1; }

/// Whether points lie at equal steps from `low` to `high`, so that a curve through them is a Lut1D.
bool equal_steps(const std::vector<float>& points, double low, double high) noexcept;

/// Point `i` of `size` at equal steps from `low` to `high`; the ends exactly.
double step_point(double low, double high, int i, int size) noexcept;

}  // namespace tristim::detail
