#include "lib/palette/means.h"
#include "lib/palette/reseat.h"

namespace tristim {
namespace {

// Between squares, which PSNR counts, and distances, as the mean of CIEDE2000 does; of few colours,
// where the far ones are lost anyway, distances alone, but not of so few that all are far.
constexpr int kFew = 32;
constexpr int kVeryFew = 8;

// More are reseated no more: that takes the square of their number.
constexpr int kMostReseated = 512;

// Cells for each colour, from which on they can stand for the colours in them.
constexpr std::size_t kCellsEach = 16;

detail::Lessen lessen_for(int colors) {
  const bool few = colors <= kFew && colors > kVeryFew;
  return few ? detail::Lessen::kDistances : detail::Lessen::kBetween;
}

}  // namespace

std::vector<Color8> choose_best(const PaletteTask& task) {
  const detail::TaskCells task_cells(task);
  const detail::ColorCells& cells = task_cells.cells();
  const bool few = task.colors <= kFew;
  const bool by_cells =
      cells.cells.places.size() / kCellsEach >= static_cast<std::size_t>(task.colors);
  const detail::GroupedPlaces& places = by_cells ? cells.cells : cells.colors;
  detail::MeanRounds rounds{few ? 12 : 6, task.fixed.size(), lessen_for(task.colors)};
  detail::Places means = detail::starting_means(task, places.places, /*merged=*/true);
  detail::move_means(places, rounds, means);
  if (task.colors <= kMostReseated) {
    rounds.rounds = 3;
    detail::reseat_means(places, few ? 20 : 8, rounds, means);
  }
  if (!few) rounds.lessen = detail::Lessen::kSquares;
  rounds.rounds = few ? 8 : 3;
  detail::move_means(places, rounds, means);
  rounds.rounds = few ? 4 : 1;
  if (by_cells) detail::move_means(cells.colors, rounds, means);
  return detail::colors_of_means(task, cells, means, rounds.lessen);
}

}  // namespace tristim
