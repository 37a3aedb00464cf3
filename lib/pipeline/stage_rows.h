#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "tristim/pipeline/stage.h"

namespace tristim::detail {

/// What stages do to the pixels of a row, three floats each, in one instruction set; all of them
/// give the same floats.
struct StageKernels {
  std::string_view name;

  /// Multiplies by a matrix of rows: m[0][0] r + m[0][1] g + m[0][2] b, summed from the left.
  void (*multiply)(const float (&m)[3][3], float* rgb, std::size_t pixels) = nullptr;

  /// Counts pixels with a channel below 0 and above 1, and clips all to [0, 1]; NaN becomes 0.
  StageCounts (*clip)(float* rgb, std::size_t pixels) = nullptr;
};

/// The definition.
const StageKernels& scalar_stage_kernels() noexcept;

/// By Highway, for every instruction set that this processor has, best first.
std::span<const StageKernels> simd_stage_kernels();

/// Those that the environment's TRISTIM_SIMD names, else the best.
const StageKernels& stage_kernels();

}  // namespace tristim::detail
