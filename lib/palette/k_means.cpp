#include "lib/palette/means.h"

namespace tristim {

std::vector<Color8> choose_k_means(const PaletteTask& task) {
  constexpr int kRounds = 20;
  const detail::TaskCells task_cells(task);
  const detail::ColorCells& cells = task_cells.cells();
  detail::Places means = detail::starting_means(task, cells.colors.places);
  detail::move_means(cells.colors, {.rounds = kRounds, .fixed = task.fixed.size()}, means);
  return detail::colors_of_means(task, cells, means);
}

}  // namespace tristim
