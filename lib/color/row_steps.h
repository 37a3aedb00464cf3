#pragma once

#include <vector>

#include "lib/color/row_kernels.h"
#include "tristim/color/conversion.h"

namespace tristim::detail {

/// One step of a row: a kernel, or where a model has none the edge, pixel by pixel.
struct RowStep {
  RowKernel kernel = {};
  RowParameters parameters{};
  Edge edge = nullptr;
  ModelContext context = {};
};

/// The steps of a conversion by `kernels`; neighbouring matrices become one.
std::vector<RowStep> row_steps(const ColorConversion& conversion, const RowKernels& kernels);

}  // namespace tristim::detail
