#pragma once

#include <optional>
#include <vector>

#include "lib/palette/clusters.h"
#include "lib/palette/cuts.h"
#include "tristim/palette/quantize.h"

namespace tristim::detail {

/// The cells of a task, its own or made for it.
class TaskCells {
 public:
  explicit TaskCells(const PaletteTask& task) : given_(task.cells) {
    if (given_ == nullptr) {
      made_.emplace(std::vector(task.entries.begin(), task.entries.end()), *task.metric);
    }
  }
  const ColorCells& cells() const noexcept { return given_ != nullptr ? *given_ : *made_; }

 private:
  const ColorCells* given_;
  std::optional<ColorCells> made_;
};

/// Means to begin with: the fixed colours' places, then those of the sets of a principal cut;
/// `merged`: of more sets, which are merged.
Places starting_means(const PaletteTask& task, const Places& places, bool merged = false);

/// The colours that are nearest to each mean but the fixed ones, as their mean in codes, weighted
/// for what is lessened; those of means without colours, or with an equal mean, are the farthest
/// from what is there.
std::vector<Color8> colors_of_means(const PaletteTask& task, const ColorCells& cells,
                                    const Places& means, Lessen lessen = Lessen::kSquares);

}  // namespace tristim::detail
