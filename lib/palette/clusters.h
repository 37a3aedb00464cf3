#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/palette/places.h"
#include "lib/palette/search.h"

namespace tristim::detail {

/// Neighbouring places.
struct PlaceGroup {
  std::uint32_t first = 0, end = 0;  // of the places, or of the groups one level below
  Place mean{};
  float radius = 0;  // no place of the group is farther from the mean
};

/// Places in an order in which neighbours are together, in groups of groups: what holds for a group
/// is found once for all of its places.
struct GroupedPlaces {
  Places places;
  std::vector<std::vector<PlaceGroup>> levels;  // the coarsest first; of the last, groups of places
};

/// Colours by cells of 4 x 4 x 4 codes, those by cells of 16 x 16 x 16.
struct ColorCells {
  std::vector<Histogram::Entry> entries;  // in the order of Histogram::neighbours()
  GroupedPlaces colors;                   // their places
  GroupedPlaces cells;                    // the weighted means of the fine cells

  /// Entries in that order; in any other they are put into it.
  ColorCells(std::vector<Histogram::Entry> colors, const Metric& metric);
};

/// Places in the order that they have, by runs: neighbours of a row are mostly alike.
GroupedPlaces runs_of(Places places);

struct Nearest {
  std::vector<std::uint32_t> index;
  std::vector<float> distance2;
};

/// The nearest of `entries` to each place, exactly as PlaceSearch finds it among all: a group asks
/// only those that can be nearest to one of its places.
Nearest nearest_entries(const GroupedPlaces& places, const Places& entries);

/// What means lessen: the squares of distances, distances, or what lies between (to the power of
/// 1.5).
enum class Lessen { kSquares, kBetween, kDistances };

/// What each place weighs: by its weight, and 1/distance or its root for what is to be lessened.
std::vector<double> weights_for(Lessen lessen, const Places& places, const Nearest& nearest);

/// How means move.
struct MeanRounds {
  int rounds = 0;
  std::size_t fixed = 0;  // of the means, the first, which stay where they are
  Lessen lessen = Lessen::kSquares;
};

/// Moves each of `means` to the weighted mean of the places nearest to it, over and over [Lloyd82].
/// A mean without places stays.
void move_means(const GroupedPlaces& places, const MeanRounds& rounds, Places& means);

}  // namespace tristim::detail
