#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "tristim/pipeline/plan.h"

namespace tristim::detail {

/// A matrix as kernels take it.
struct RowMatrix {
  explicit RowMatrix(const Multiply& multiply);
  float m[3][3];
  bool diagonal;
};

/// What stages do to the pixels of a row, three floats each, in one instruction set; all of them
/// give the same floats.
struct StageKernels {
  std::string_view name;

  /// m[0][0] r + m[0][1] g + m[0][2] b, summed from the left; of a diagonal matrix m[0][0] r.
  void (*multiply)(const RowMatrix& matrix, float* rgb, std::size_t pixels) = nullptr;

  /// Counts pixels with a channel below 0 and above 1, and clips all to [0, 1]; NaN becomes 0.
  StageCounts (*clip)(float* rgb, std::size_t pixels) = nullptr;

  /// Both, as they are wanted (the matrix may be null), from pixels to a row for each channel.
  StageCounts (*split)(const RowMatrix* matrix, bool clipped, const float* rgb, std::size_t pixels,
                       float* const (&planes)[3]) = nullptr;
};

/// The definition.
const StageKernels& scalar_stage_kernels() noexcept;

/// By Highway, for every instruction set that this processor has, best first.
std::span<const StageKernels> simd_stage_kernels();

/// A plan's lead as rows take it, from pixels to a row for each channel.
class RowLead {
 public:
  explicit RowLead(const Lead& lead);
  StageCounts split(std::span<const float> rgb, float* const (&planes)[3]) const;

 private:
  std::optional<RowMatrix> matrix_;
  bool clip_;
};

/// Those that the environment's TRISTIM_SIMD names, else the best.
const StageKernels& stage_kernels();

}  // namespace tristim::detail
