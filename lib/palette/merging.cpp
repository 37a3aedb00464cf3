#include "lib/palette/merging.h"

#include <limits>

namespace tristim::detail {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

// A mean and the one whose merging with it adds least.
struct Mergeable {
  std::array<double, 4> place{};
  double weight = 0;
  std::size_t partner = kNone;
  double cost = std::numeric_limits<double>::infinity();
};

double cost_of(const Mergeable& a, const Mergeable& b) {
  double distance2 = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    distance2 += (a.place[i] - b.place[i]) * (a.place[i] - b.place[i]);
  }
  return distance2 * a.weight * b.weight / (a.weight + b.weight);
}

void find_partner(std::vector<Mergeable>& means, std::size_t i) {
  Mergeable& mean = means[i];
  mean.partner = kNone;
  mean.cost = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < means.size(); ++k) {
    if (k == i) continue;
    const double cost = cost_of(mean, means[k]);
    if (cost < mean.cost) mean.cost = cost, mean.partner = k;
  }
}

void merge_into(Mergeable& mean, const Mergeable& other) {
  const double weight = mean.weight + other.weight;
  for (std::size_t i = 0; i < 4; ++i) {
    mean.place[i] = (mean.weight * mean.place[i] + other.weight * other.place[i]) / weight;
  }
  mean.weight = weight;
}

// The last one takes the place of `gone`.
void take_out(std::vector<Mergeable>& means, std::size_t gone) {
  const std::size_t last = means.size() - 1;
  means[gone] = means[last];
  means.pop_back();
  for (Mergeable& mean : means) {
    if (mean.partner == last) mean.partner = gone;
  }
}

}  // namespace

Places merge_means(const Places& places, std::size_t wanted) {
  std::vector<Mergeable> means;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!(places.weight[i] > 0)) continue;
    means.push_back({{places.axis[0][i], places.axis[1][i], places.axis[2][i], places.axis[3][i]},
                     places.weight[i]});
  }
  for (std::size_t i = 0; i < means.size(); ++i) find_partner(means, i);
  while (means.size() > wanted && means.size() > 1) {
    std::size_t first = 0;
    for (std::size_t i = 1; i < means.size(); ++i) {
      if (means[i].cost < means[first].cost) first = i;
    }
    const std::size_t second = means[first].partner;
    merge_into(means[first], means[second]);
    for (Mergeable& mean : means) {
      if (mean.partner == first || mean.partner == second) mean.partner = kNone;
    }
    means[first].partner = kNone;
    take_out(means, second);
    for (std::size_t i = 0; i < means.size(); ++i) {
      if (means[i].partner == kNone) find_partner(means, i);
    }
  }
  Places merged;
  for (const Mergeable& mean : means) {
    Place place{};
    for (std::size_t i = 0; i < 4; ++i) place[i] = static_cast<float>(mean.place[i]);
    merged.push_back(place, static_cast<float>(mean.weight));
  }
  return merged;
}

}  // namespace tristim::detail
