#pragma once

#include <optional>

#include "lib/color/row_kernels.h"
#include "tristim/color/rgb_curve.h"

namespace tristim::detail {

/// A curve and its inverse in rows.
struct CurveKernels {
  RowKernel encode, decode;
  RowParameters parameters{};
};

/// Those of `curve` among `kernels`, where it has any.
std::optional<CurveKernels> curve_kernels(const RgbCurve& curve, const RowKernels& kernels);

}  // namespace tristim::detail
