#pragma once

#include <array>
#include <string_view>

namespace tristim {

/// How the error of a pixel is shared out: three rows from the pixel's own on, the pixel in the
/// middle column.
struct DiffusionKernel {
  std::string_view name;
  int divisor;
  std::array<std::array<int, 5>, 3> weight;
  std::string_view source;
};

inline constexpr DiffusionKernel kFloydSteinberg{.name = "floyd-steinberg",
                                                 .divisor = 16,
                                                 .weight = {{{0, 0, 0, 7, 0},  //
                                                             {0, 3, 5, 1, 0},
                                                             {0, 0, 0, 0, 0}}},
                                                 .source = "[FloydSteinberg76]"};

/// Every kernel. The command line, the docs and the property tests read this list.
inline constexpr std::array kDiffusionKernels{kFloydSteinberg};

}  // namespace tristim
