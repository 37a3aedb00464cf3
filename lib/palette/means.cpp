#include "lib/palette/means.h"

#include <algorithm>
#include <array>
#include <set>

namespace tristim::detail {
namespace {

// The worst colours of the picture, one for each that is missing, none twice.
void fill_up(const PaletteTask& task, const ColorCells& cells, const Nearest& nearest,
             std::vector<Color8>& palette) {
  std::set<Color8> taken(palette.begin(), palette.end());
  taken.insert(task.fixed.begin(), task.fixed.end());
  std::vector<std::uint32_t> worst(cells.entries.size());
  for (std::uint32_t i = 0; i < worst.size(); ++i) worst[i] = i;
  const auto error = [&](std::uint32_t i) {
    return nearest.distance2[i] * cells.colors.places.weight[i];
  };
  std::sort(worst.begin(), worst.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (error(a) != error(b)) return error(a) > error(b);
    return cells.entries[a].color < cells.entries[b].color;
  });
  for (const std::uint32_t i : worst) {
    if (std::ssize(palette) == task.colors) return;
    const Color8 color = cells.entries[i].color;
    if (taken.insert(color).second) palette.push_back(color);
  }
}

}  // namespace

Places starting_means(const PaletteTask& task, const Places& places) {
  Places means;
  const Placer placer(*task.metric);
  for (const Color8 color : task.fixed) means.push_back(placer(color), 0);
  const auto set = cut_places(places, task.colors, CutRule::kPrincipalAxis);
  struct Sums {
    double weight = 0;
    std::array<double, 4> place{};
  };
  std::vector<Sums> sums(*std::max_element(set.begin(), set.end()) + 1);
  for (std::size_t i = 0; i < set.size(); ++i) {
    Sums& s = sums[set[i]];
    s.weight += places.weight[i];
    for (std::size_t a = 0; a < 4; ++a) s.place[a] += double{places.weight[i]} * places.axis[a][i];
  }
  for (const Sums& s : sums) {
    Place mean{};
    for (std::size_t a = 0; a < 4; ++a) mean[a] = static_cast<float>(s.place[a] / s.weight);
    means.push_back(mean, 0);
  }
  return means;
}

std::vector<Color8> colors_of_means(const PaletteTask& task, const ColorCells& cells,
                                    const Places& means) {
  const Nearest nearest = nearest_entries(cells.colors, means);
  const auto fixed = static_cast<std::uint32_t>(task.fixed.size());
  std::vector<Histogram::Entry> entries;
  std::vector<std::uint32_t> set;
  for (std::size_t i = 0; i < cells.entries.size(); ++i) {
    if (nearest.index[i] < fixed) continue;
    entries.push_back(cells.entries[i]);
    set.push_back(nearest.index[i] - fixed);
  }
  std::vector<Color8> palette;
  std::set<Color8> taken(task.fixed.begin(), task.fixed.end());
  for (const Color8 color : set_means(entries, set)) {
    if (taken.insert(color).second) palette.push_back(color);
  }
  if (std::ssize(palette) < task.colors) fill_up(task, cells, nearest, palette);
  return palette;
}

}  // namespace tristim::detail
