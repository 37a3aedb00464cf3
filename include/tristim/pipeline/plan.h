#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "tristim/pipeline/stage.h"

namespace tristim {

/// Light times a matrix, in floats, summed from the left without fused sums; a diagonal matrix
/// multiplies each channel by itself.
struct Multiply {
  Eigen::Matrix3f matrix = Eigen::Matrix3f::Identity();
};

/// One pass over a row.
struct Pass {
  std::variant<Multiply, ToneMap, GamutMap> work;
  std::string stages;  // the names of those that it stands for
};

/// What the pass that makes the codes does with light first.
struct Lead {
  std::optional<Multiply> multiply;
  bool clip = false;   // to [0, 1], counted; NaN becomes 0
  std::string stages;  // as in Pass
};

/// The stages of a chain as they run: row after row, each pass over a row while it lies in the
/// nearest cache.
///
/// Neighbouring stages that multiply, exposure and primaries, are one matrix, whose product is
/// made in double and rounded to floats once. That holds whoever looks on, so codes do not depend
/// on it; one that changes nothing is left out.
struct Plan {
  std::vector<Pass> passes;
  Lead lead;
};

/// `leads`: the pass that makes the codes can multiply and clip first.
Plan plan_chain(std::span<const Stage> stages, bool leads);

/// All passes but the lead, in place.
void apply(const Plan& plan, Band band, StageCounts& counts);

/// The plan in words; `codes` names the pass that makes them.
StepReport explain(const Plan& plan, const std::string& codes);

}  // namespace tristim
