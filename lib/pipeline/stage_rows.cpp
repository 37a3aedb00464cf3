#include "lib/pipeline/stage_rows.h"

#include <algorithm>

#include "lib/core/instruction_set.h"

namespace tristim::detail {
namespace {

void multiply_pixel(const RowMatrix& matrix, float* rgb) {
  const auto& m = matrix.m;
  const float r = rgb[0];
  const float g = rgb[1];
  const float b = rgb[2];
  for (int k = 0; k < 3; ++k) {
    rgb[k] = matrix.diagonal ? m[k][k] * rgb[k] : m[k][0] * r + m[k][1] * g + m[k][2] * b;
  }
}

void clip_pixel(float* rgb, StageCounts& counts) {
  const bool below = rgb[0] < 0 || rgb[1] < 0 || rgb[2] < 0;
  const bool above = rgb[0] > 1 || rgb[1] > 1 || rgb[2] > 1;
  counts.out_of_gamut += below ? 1 : 0;
  counts.clipped += above ? 1 : 0;
  // in this order NaN, which an overflow before may have left, becomes 0
  for (int c = 0; c < 3; ++c) rgb[c] = std::min(std::max(0.0F, rgb[c]), 1.0F);
}

void multiply(const RowMatrix& matrix, float* rgb, std::size_t pixels) {
  for (std::size_t i = 0; i < pixels; ++i) multiply_pixel(matrix, rgb + 3 * i);
}

StageCounts clip(float* rgb, std::size_t pixels) {
  StageCounts counts;
  for (std::size_t i = 0; i < pixels; ++i) clip_pixel(rgb + 3 * i, counts);
  return counts;
}

StageCounts split(const RowMatrix* matrix, bool clipped, const float* rgb, std::size_t pixels,
                  float* const (&planes)[3]) {
  StageCounts counts;
  for (std::size_t i = 0; i < pixels; ++i) {
    float pixel[3] = {rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]};
    if (matrix != nullptr) multiply_pixel(*matrix, pixel);
    if (clipped) clip_pixel(pixel, counts);
    for (int c = 0; c < 3; ++c) planes[c][i] = pixel[c];
  }
  return counts;
}

}  // namespace

RowMatrix::RowMatrix(const Multiply& multiply) : diagonal(multiply.matrix.isDiagonal(0)) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) m[i][j] = multiply.matrix(i, j);
  }
}

const StageKernels& scalar_stage_kernels() noexcept {
  static constexpr StageKernels kScalar{"scalar", multiply, clip, split};
  return kScalar;
}

const StageKernels& stage_kernels() {
  static const StageKernels* const simd = chosen_instruction_set(simd_stage_kernels());
  return simd == nullptr ? scalar_stage_kernels() : *simd;
}

RowLead::RowLead(const Lead& lead) : clip_(lead.clip) {
  if (lead.multiply) matrix_.emplace(*lead.multiply);
}

StageCounts RowLead::split(std::span<const float> rgb, float* const (&planes)[3]) const {
  return stage_kernels().split(matrix_ ? &*matrix_ : nullptr, clip_, rgb.data(), rgb.size() / 3,
                               planes);
}

}  // namespace tristim::detail
