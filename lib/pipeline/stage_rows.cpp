#include "lib/pipeline/stage_rows.h"

#include <algorithm>

#include "lib/core/instruction_set.h"

namespace tristim::detail {
namespace {

void multiply(const float (&m)[3][3], float* rgb, std::size_t pixels) {
  for (std::size_t i = 0; i < pixels; ++i, rgb += 3) {
    const float r = rgb[0];
    const float g = rgb[1];
    const float b = rgb[2];
    for (int k = 0; k < 3; ++k) rgb[k] = m[k][0] * r + m[k][1] * g + m[k][2] * b;
  }
}

StageCounts clip(float* rgb, std::size_t pixels) {
  StageCounts counts;
  for (std::size_t i = 0; i < pixels; ++i, rgb += 3) {
    const bool below = rgb[0] < 0 || rgb[1] < 0 || rgb[2] < 0;
    const bool above = rgb[0] > 1 || rgb[1] > 1 || rgb[2] > 1;
    counts.out_of_gamut += below ? 1 : 0;
    counts.clipped += above ? 1 : 0;
    // in this order NaN, which an overflow before may have left, becomes 0
    for (int c = 0; c < 3; ++c) rgb[c] = std::min(std::max(0.0F, rgb[c]), 1.0F);
  }
  return counts;
}

}  // namespace

const StageKernels& scalar_stage_kernels() noexcept {
  static constexpr StageKernels kScalar{"scalar", multiply, clip};
  return kScalar;
}

const StageKernels& stage_kernels() {
  static const StageKernels* const simd = chosen_instruction_set(simd_stage_kernels());
  return simd == nullptr ? scalar_stage_kernels() : *simd;
}

}  // namespace tristim::detail
