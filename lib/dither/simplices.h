#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tristim/dither/palette.h"

namespace tristim::detail {

/// Four columns of the linear program that lib/dither/mixtures.h tells of: entries of a palette, or
/// directions in which a colour gives up what the entries do not mix.
struct Simplex {
  std::array<int, 4> column;  // ascending
  std::array<int, 4> entry;   // of the palette; -1: a direction
  std::array<int, 4> next;    // the simplex beyond the face opposite to that column; -1: none
  Eigen::Matrix4d inverse;    // (r, g, b, 1) to the shares of the columns
};

/// The simplices of a palette, each next to others, in which all colours lie; none where they would
/// be more than `most`.
std::vector<Simplex> simplices_of(const MixPalette& palette, std::size_t most);

}  // namespace tristim::detail
