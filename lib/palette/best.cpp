#include "lib/palette/means.h"

namespace tristim {

std::vector<Color8> choose_best(const PaletteTask& task) {
  constexpr int kFew = 32;         // colours whose mean distance counts, not its square
  constexpr int kCellRounds = 10;  // over cells, which are fewer than colours
  constexpr int kColorRounds = 2;
  constexpr int kCellsEach = 8;  // cells of a colour, so that they can stand for their colours
  const detail::ColorCells cells(task.entries, *task.metric);
  const bool coarse = cells.cells.places.size() / kCellsEach >= std::size_t(task.colors);
  const detail::GroupedPlaces& start = coarse ? cells.cells : cells.colors;
  detail::MeanRounds rounds{.rounds = coarse ? kCellRounds : 0,
                            .fixed = task.fixed.size(),
                            .distances = task.colors <= kFew};
  detail::Places means = detail::starting_means(task, start.places);
  detail::move_means(start, rounds, means);
  rounds.rounds = kColorRounds;
  detail::move_means(cells.colors, rounds, means);
  return detail::colors_of_means(task, cells, means);
}

}  // namespace tristim
