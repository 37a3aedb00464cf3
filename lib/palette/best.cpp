#include "lib/palette/means.h"

namespace tristim {
namespace {

// Of so few colours the mean distance is lessened, not its square, and that takes more rounds.
constexpr int kFew = 32;

// Cells for each colour, from which on they can stand for the colours in them.
constexpr std::size_t kCellsEach = 16;

}  // namespace

std::vector<Color8> choose_best(const PaletteTask& task) {
  const detail::TaskCells task_cells(task);
  const detail::ColorCells& cells = task_cells.cells();
  const bool few = task.colors <= kFew;
  const bool by_cells =
      cells.cells.places.size() / kCellsEach >= static_cast<std::size_t>(task.colors);
  const detail::GroupedPlaces& start = by_cells ? cells.cells : cells.colors;
  detail::MeanRounds rounds{.rounds = few ? 30 : 10, .fixed = task.fixed.size(), .distances = few};
  detail::Places means = detail::starting_means(task, start.places);
  detail::move_means(start, rounds, means);
  rounds.rounds = few ? 10 : 3;
  if (by_cells) detail::move_means(cells.colors, rounds, means);
  return detail::colors_of_means(task, cells, means);
}

}  // namespace tristim
