#include "lib/palette/clusters.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/palette/color_cell.h"

namespace tristim::detail {
namespace {

float distance2(const Place& a, const Place& b) {
  float sum = 0;
  for (std::size_t i = 0; i < 4; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

// The places in [first, end) as a group; their weight.
PlaceGroup group_of(const Places& places, std::uint32_t first, std::uint32_t end, double& weight) {
  std::array<double, 4> sum{};
  weight = 0;
  for (std::size_t i = first; i < end; ++i) {
    const double w = places.weight[i];
    weight += w;
    for (std::size_t a = 0; a < 4; ++a) sum[a] += w * places.axis[a][i];
  }
  PlaceGroup group{first, end, {}, 0};
  for (std::size_t a = 0; a < 4; ++a) group.mean[a] = static_cast<float>(sum[a] / weight);
  float farthest2 = 0;
  for (std::size_t i = first; i < end; ++i) {
    farthest2 = std::max(farthest2, distance2(places.at(i), group.mean));
  }
  group.radius = std::sqrt(farthest2);
  return group;
}

// Groups of `below`, those with equal keys together.
template <typename Key>
std::vector<PlaceGroup> groups_by(const Places& means, std::span<const PlaceGroup> below,
                                  Key&& key) {
  std::vector<PlaceGroup> groups;
  for (std::uint32_t i = 0; i < means.size();) {
    std::uint32_t end = i + 1;
    while (end < means.size() && key(end) == key(i)) ++end;
    double weight = 0;
    groups.push_back(group_of(means, i, end, weight));
    for (std::uint32_t g = i; g < end && !below.empty(); ++g) {
      groups.back().radius =
          std::max(groups.back().radius,
                   std::sqrt(distance2(below[g].mean, groups.back().mean)) + below[g].radius);
    }
    i = end;
  }
  return groups;
}

// Entries in planes with their numbers in the palette.
struct Entries {
  std::array<std::vector<float>, 4> axis;
  std::vector<std::uint32_t> number;
  std::size_t size = 0;

  explicit Entries(std::size_t most) : number(most) {
    for (auto& plane : axis) plane.resize(most);
  }
  PlacePlanes planes() const noexcept {
    return {{axis[0].data(), axis[1].data(), axis[2].data(), axis[3].data()}, size};
  }
};

// In lanes, whose steps do not wait for each other.
float least_of(std::span<const float> numbers) {
  std::array<float, 16> least;
  least.fill(std::numeric_limits<float>::infinity());
  std::size_t i = 0;
  for (; i + least.size() <= numbers.size(); i += least.size()) {
    for (std::size_t k = 0; k < least.size(); ++k) {
      least[k] = numbers[i + k] < least[k] ? numbers[i + k] : least[k];
    }
  }
  for (; i < numbers.size(); ++i) least[0] = std::min(least[0], numbers[i]);
  return *std::min_element(least.begin(), least.end());
}

// Walks down the groups with the entries that can be nearest to one of their places.
class GroupSearch {
 public:
  GroupSearch(const GroupedPlaces& places, const Places& entries, Nearest& result)
      : places_(places),
        axes_(std::max(places.places.axes, entries.axes)),
        result_(result),
        search_(place_search()),
        distance2_(entries.size()),
        among_(places.levels.size() + 1, Entries(entries.size())) {
    among_[0].axis = entries.axis;
    among_[0].size = entries.size();
    for (std::uint32_t k = 0; k < entries.size(); ++k) among_[0].number[k] = k;
  }

  void run() {
    for (const PlaceGroup& group : places_.levels.front()) descend(group, 0);
  }

 private:
  // An entry that is nearest to a place of the group is at most two radii farther from its mean
  // than the one that is nearest to that; a little more for rounding.
  void keep_near(const PlaceGroup& group, const Entries& among, Entries& kept) {
    for (std::size_t k = 0; k < among.size; ++k) {
      float sum = 0;
      for (std::size_t a = 0; a < 4; ++a) {
        const float d = among.axis[a][k] - group.mean[a];
        sum += d * d;
      }
      distance2_[k] = sum;
    }
    const float least = least_of({distance2_.data(), among.size});
    const float reach = (std::sqrt(least) + 2 * group.radius) * (1 + 1e-5F) + 1e-6F;
    kept.size = 0;
    for (std::size_t k = 0; k < among.size; ++k) {
      if (distance2_[k] > reach * reach) continue;
      for (std::size_t a = 0; a < 4; ++a) kept.axis[a][kept.size] = among.axis[a][k];
      kept.number[kept.size++] = among.number[k];
    }
  }

  void descend(const PlaceGroup& group, std::size_t level) {
    Entries& kept = among_[level + 1];
    keep_near(group, among_[level], kept);
    if (level + 1 < places_.levels.size()) {
      for (std::uint32_t g = group.first; g < group.end; ++g) {
        descend(places_.levels[level + 1][g], level + 1);
      }
      return;
    }
    std::uint32_t* const index = result_.index.data() + group.first;
    search_.nearest(kept.planes(), planes_of(places_.places, group.first, group.end), axes_, index,
                    result_.distance2.data() + group.first);
    for (std::uint32_t i = 0; i < group.end - group.first; ++i) index[i] = kept.number[index[i]];
  }

  const GroupedPlaces& places_;
  int axes_;
  Nearest& result_;
  PlaceSearch search_;
  std::vector<float> distance2_;
  std::vector<Entries> among_;  // by level: those that the level above has kept
};

// Places that belong to a mean.
struct Cluster {
  double weight = 0;
  std::array<double, 4> sum{};
};

// A distance below which its inverse grows no further.
double least_distance(const Places& places, const Nearest& nearest) {
  double sum = 0;
  double weight = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    sum += places.weight[i] * std::sqrt(double{nearest.distance2[i]});
    weight += places.weight[i];
  }
  return 0.1 * sum / weight + 1e-30;
}

std::vector<Cluster> clusters_of(const Places& places, const Nearest& nearest, std::size_t means,
                                 Lessen lessen) {
  std::vector<Cluster> clusters(means);
  const auto add = [&](std::size_t i, double w) {
    Cluster& cluster = clusters[nearest.index[i]];
    cluster.weight += w;
    for (std::size_t a = 0; a < 4; ++a) cluster.sum[a] += w * places.axis[a][i];
  };
  if (lessen == Lessen::kSquares) {
    for (std::size_t i = 0; i < places.size(); ++i) add(i, places.weight[i]);
    return clusters;
  }
  const std::vector<double> weights = weights_for(lessen, places, nearest);
  for (std::size_t i = 0; i < places.size(); ++i) add(i, weights[i]);
  return clusters;
}

}  // namespace

ColorCells::ColorCells(std::vector<Histogram::Entry> sorted, const Metric& metric)
    : entries(std::move(sorted)) {
  // Translucent colours are in the cell of their colour: alpha varies little between neighbours.
  const auto number = [](const Histogram::Entry& e) { return color_number(e.color); };
  const auto before = [number](const Histogram::Entry& a, const Histogram::Entry& b) {
    return number(a) != number(b) ? number(a) < number(b) : a.color.a < b.color.a;
  };
  if (!std::is_sorted(entries.begin(), entries.end(), before)) {
    std::sort(entries.begin(), entries.end(), before);
  }
  colors.places = places_of(entries, metric);
  const auto cell = [&](std::uint32_t i) { return cell_of(number(entries[i])); };
  const std::vector<PlaceGroup> fine = groups_by(colors.places, {}, cell);
  for (const PlaceGroup& group : fine) {
    double weight = 0;
    for (std::uint32_t i = group.first; i < group.end; ++i) weight += colors.places.weight[i];
    cells.places.push_back(group.mean, static_cast<float>(weight));
  }
  const auto coarse = [&](std::uint32_t g) {
    return coarse_cell_of(number(entries[fine[g].first]));
  };
  colors.levels = {groups_by(cells.places, fine, coarse), fine};
  cells.levels = {groups_by(cells.places, {}, coarse)};
}

GroupedPlaces runs_of(Places places) {
  constexpr std::uint32_t kShort = 16;
  constexpr std::uint32_t kLong = 16;  // short ones
  const auto short_run = [](std::uint32_t i) { return i / kShort; };
  const auto long_run = [](std::uint32_t i) { return i / kLong; };
  GroupedPlaces runs{std::move(places), {}};
  const std::vector<PlaceGroup> fine = groups_by(runs.places, {}, short_run);
  Places means;
  for (const PlaceGroup& group : fine) means.push_back(group.mean, 1);
  runs.levels = {groups_by(means, fine, long_run), fine};
  return runs;
}

Nearest nearest_entries(const GroupedPlaces& places, const Places& entries) {
  Nearest nearest{std::vector<std::uint32_t>(places.places.size()),
                  std::vector<float>(places.places.size())};
  GroupSearch(places, entries, nearest).run();
  return nearest;
}

std::vector<double> weights_for(Lessen lessen, const Places& places, const Nearest& nearest) {
  std::vector<double> weights(places.weight.begin(), places.weight.end());
  if (lessen == Lessen::kSquares) return weights;
  const double least = least_distance(places, nearest);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double distance = std::sqrt(double{nearest.distance2[i]}) + least;
    weights[i] /= lessen == Lessen::kDistances ? distance : std::sqrt(distance);
  }
  return weights;
}

void move_means(const GroupedPlaces& places, const MeanRounds& rounds, Places& means) {
  for (int round = 0; round < rounds.rounds; ++round) {
    const Nearest nearest = nearest_entries(places, means);
    const auto clusters = clusters_of(places.places, nearest, means.size(), rounds.lessen);
    for (std::size_t k = rounds.fixed; k < means.size(); ++k) {
      if (!(clusters[k].weight > 0)) continue;
      for (std::size_t a = 0; a < 4; ++a) {
        means.axis[a][k] = static_cast<float>(clusters[k].sum[a] / clusters[k].weight);
      }
    }
  }
}

}  // namespace tristim::detail
