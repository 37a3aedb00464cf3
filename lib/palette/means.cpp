#include "lib/palette/means.h"

#include <algorithm>
#include <array>
#include <set>

#include "lib/palette/merging.h"

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

// The weighted means of sets of places.
Places means_of_sets(const Places& places, std::span<const std::uint32_t> set) {
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
  Places means;
  for (const Sums& s : sums) {
    Place mean{};
    for (std::size_t a = 0; a < 4; ++a) mean[a] = static_cast<float>(s.place[a] / s.weight);
    means.push_back(mean, static_cast<float>(s.weight));
  }
  return means;
}

// How many sets are merged to `colors`: the fewer colours, the more, since merging is quick then.
int sets_for(int colors) { return colors <= 32 ? 16 * colors : 2 * colors; }

// The counts of colours by what their errors weigh.
std::vector<Histogram::Entry> weighted_entries(const ColorCells& cells, const Nearest& nearest,
                                               Lessen lessen) {
  std::vector<Histogram::Entry> entries = cells.entries;
  if (lessen != Lessen::kDistances) return entries;
  const std::vector<double> weights = weights_for(lessen, cells.colors.places, nearest);
  const double most = *std::max_element(weights.begin(), weights.end());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    entries[i].count = 1 + static_cast<std::uint64_t>(weights[i] / most * 0x1p20);
  }
  return entries;
}

}  // namespace

Places starting_means(const PaletteTask& task, const Places& places, bool merged) {
  // Merging takes the square of the sets' number.
  constexpr int kMostMerged = 512;
  const bool merges = merged && task.colors <= kMostMerged;
  const int sets = merges ? sets_for(task.colors) : task.colors;
  Places chosen = means_of_sets(places, cut_places(places, sets, CutRule::kPrincipalAxis));
  if (merges) chosen = merge_means(chosen, static_cast<std::size_t>(task.colors));
  Places means;
  const Placer placer(*task.metric);
  for (const Color8 color : task.fixed) means.push_back(placer(color), 0);
  for (std::size_t i = 0; i < chosen.size(); ++i) means.push_back(chosen.at(i), 0);
  return means;
}

std::vector<Color8> colors_of_means(const PaletteTask& task, const ColorCells& cells,
                                    const Places& means, Lessen lessen) {
  const Nearest nearest = nearest_entries(cells.colors, means);
  const auto fixed = static_cast<std::uint32_t>(task.fixed.size());
  std::vector<Histogram::Entry> entries = weighted_entries(cells, nearest, lessen);
  std::vector<std::uint32_t> set;
  set.reserve(entries.size());
  std::size_t kept = 0;  // of the entries, those that are nearest to no fixed colour
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (nearest.index[i] < fixed) continue;
    entries[kept++] = entries[i];
    set.push_back(nearest.index[i] - fixed);
  }
  entries.resize(kept);
  std::vector<Color8> palette;
  std::set<Color8> taken(task.fixed.begin(), task.fixed.end());
  for (const Color8 color : set_means(entries, set)) {
    if (taken.insert(color).second) palette.push_back(color);
  }
  if (std::ssize(palette) < task.colors) fill_up(task, cells, nearest, palette);
  return palette;
}

}  // namespace tristim::detail
