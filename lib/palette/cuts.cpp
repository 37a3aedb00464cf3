#include "lib/palette/cuts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

#include "tristim/palette/quantize.h"

namespace tristim {
namespace detail {
namespace {

using Vector = std::array<double, 4>;

// Some of the places, in the order of the last cut.
struct Set {
  std::span<std::uint32_t> members;
  double gain = 0;     // by which the rule ranks sets; 0: cannot be cut
  Vector direction{};  // across which it is cut
};

double dot(const Vector& a, const Place& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

struct Moments {
  double weight = 0;
  Vector mean{};
  std::array<Vector, 4> scatter{};  // weighted sums of products about the mean
};

Moments moments(const Places& places, std::span<const std::uint32_t> members) {
  Moments m;
  for (const std::uint32_t i : members) {
    const Place place = places.at(i);
    m.weight += places.weight[i];
    for (std::size_t a = 0; a < 4; ++a) m.mean[a] += double{places.weight[i]} * place[a];
  }
  for (double& mean : m.mean) mean /= m.weight;
  for (const std::uint32_t i : members) {
    const Place place = places.at(i);
    Vector d{};
    for (std::size_t a = 0; a < 4; ++a) d[a] = place[a] - m.mean[a];
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = a; b < 4; ++b) m.scatter[a][b] += places.weight[i] * d[a] * d[b];
    }
  }
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = 0; b < a; ++b) m.scatter[a][b] = m.scatter[b][a];
  }
  return m;
}

// The direction of the largest scatter, by powers of the matrix; what it leaves out is noise.
Vector principal_axis(const std::array<Vector, 4>& scatter, double& variance) {
  constexpr int kPowers = 16;
  Vector axis{1, 0.7, 0.5, 0.3};  // along none of the usual ones
  variance = 0;
  for (int i = 0; i < kPowers; ++i) {
    Vector next{};
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = 0; b < 4; ++b) next[a] += scatter[a][b] * axis[b];
    }
    variance =
        std::sqrt(next[0] * next[0] + next[1] * next[1] + next[2] * next[2] + next[3] * next[3]);
    if (!(variance > 0)) return axis;
    for (std::size_t a = 0; a < 4; ++a) axis[a] = next[a] / variance;
  }
  return axis;
}

class Cutter {
 public:
  Cutter(const Places& places, CutRule rule)
      : places_(places), rule_(rule), order_(places.size()), along_(places.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
  }

  std::vector<std::uint32_t> run(int sets) {
    std::vector<Set> all{judged(order_)};
    const auto gains_less = [&all](std::size_t a, std::size_t b) {
      return all[a].gain != all[b].gain ? all[a].gain < all[b].gain : a > b;
    };
    std::priority_queue<std::size_t, std::vector<std::size_t>, decltype(gains_less)> open(
        gains_less);
    open.push(0);
    while (std::ssize(all) < sets && all[open.top()].gain > 0) {
      const std::size_t worst = open.top();
      open.pop();
      double gained = 0;
      const auto members = all[worst].members;
      const std::size_t first = best_cut(members, all[worst].direction, gained);
      all[worst] = judged(members.first(first));
      all.push_back(judged(members.subspan(first)));
      open.push(worst);
      open.push(all.size() - 1);
    }
    std::vector<std::uint32_t> set(places_.size());
    for (std::size_t s = 0; s < all.size(); ++s) {
      for (const std::uint32_t i : all[s].members) set[i] = static_cast<std::uint32_t>(s);
    }
    return set;
  }

 private:
  Set judged(std::span<std::uint32_t> members) {
    Set set{members, 0, {}};
    if (members.size() < 2) return set;
    const Moments m = moments(places_, members);
    if (rule_ == CutRule::kPrincipalAxis) {
      set.direction = principal_axis(m.scatter, set.gain);
    } else if (rule_ == CutRule::kWidestAxis) {
      std::size_t widest = 0;
      for (std::size_t a = 0; a < 4; ++a) {
        set.gain += m.scatter[a][a];
        if (m.scatter[a][a] > m.scatter[widest][widest]) widest = a;
      }
      set.direction[widest] = 1;
    } else {
      for (int a = 0; a < places_.axes; ++a) {
        Vector axis{};
        axis[static_cast<std::size_t>(a)] = 1;
        double gain = 0;
        best_cut(members, axis, gain);
        if (gain > set.gain) set.gain = gain, set.direction = axis;
      }
    }
    // What rounding leaves of members in one place is no gain.
    if (set.gain <= 1e-12 * m.weight) set.gain = 0;
    return set;
  }

  // Brings the members before the cut along a direction that gains most to the front; how many they
  // are. The gain is w1 w2/(w1 + w2) times the square of the distance of the means. Large sets are
  // cut between one of kBins equal steps, which costs no sorting.
  std::size_t best_cut(std::span<std::uint32_t> members, const Vector& direction, double& gain) {
    constexpr std::size_t kLarge = 2048;
    const std::size_t first = members.size() > kLarge ? cut_in_bins(members, direction, gain) : 0;
    return first > 0 ? first : cut_in_order(members, direction, gain);
  }

  // 0 where all are in one step.
  std::size_t cut_in_bins(std::span<std::uint32_t> members, const Vector& direction, double& gain) {
    constexpr std::size_t kBins = 512;
    float low = std::numeric_limits<float>::infinity();
    float high = -low;
    for (const std::uint32_t i : members) {
      along_[i] = static_cast<float>(dot(direction, places_.at(i)));
      low = std::min(low, along_[i]);
      high = std::max(high, along_[i]);
    }
    if (!(high > low)) return 0;
    const float steps = static_cast<float>(kBins - 1) / (high - low);
    const auto bin = [&](std::uint32_t i) {
      return static_cast<std::size_t>((along_[i] - low) * steps);
    };
    struct Sums {
      double weight = 0, along = 0;
    };
    std::array<Sums, kBins> bins{};
    Sums all;
    for (const std::uint32_t i : members) {
      const double w = places_.weight[i];
      const double along = w * (along_[i] - low);
      bins[bin(i)].weight += w;
      bins[bin(i)].along += along;
      all.weight += w;
      all.along += along;
    }
    Sums below;
    std::size_t best = 0;
    gain = 0;
    for (std::size_t b = 0; b + 1 < kBins; ++b) {
      below.weight += bins[b].weight;
      below.along += bins[b].along;
      const double above = all.weight - below.weight;
      if (!(below.weight > 0) || !(above > 0)) continue;
      const double moment = below.along - all.along * (below.weight / all.weight);
      const double reached = moment * moment * all.weight / (below.weight * above);
      if (reached > gain) gain = reached, best = b;
    }
    const auto second = std::stable_partition(members.begin(), members.end(),
                                              [&](std::uint32_t i) { return bin(i) <= best; });
    return second == members.end() ? 0 : static_cast<std::size_t>(second - members.begin());
  }

  std::size_t cut_in_order(std::span<std::uint32_t> members, const Vector& direction,
                           double& gain) {
    for (const std::uint32_t i : members) {
      along_[i] = static_cast<float>(dot(direction, places_.at(i)));
    }
    std::sort(members.begin(), members.end(), [&](std::uint32_t a, std::uint32_t b) {
      return along_[a] != along_[b] ? along_[a] < along_[b] : a < b;
    });
    double weight = 0;
    double sum = 0;
    for (const std::uint32_t i : members) {
      weight += places_.weight[i];
      sum += double{places_.weight[i]} * along_[i];
    }
    const double mean = sum / weight;
    double low_weight = 0;
    double low_sum = 0;  // about the mean
    std::size_t best = 1;
    gain = 0;
    for (std::size_t i = 0; i + 1 < members.size(); ++i) {
      const double w = places_.weight[members[i]];
      low_weight += w;
      low_sum += w * (along_[members[i]] - mean);
      if (along_[members[i]] == along_[members[i + 1]]) continue;
      const double reached = low_sum * low_sum * weight / (low_weight * (weight - low_weight));
      if (reached > gain) gain = reached, best = i + 1;
    }
    return best;
  }

  const Places& places_;
  CutRule rule_;
  std::vector<std::uint32_t> order_;
  std::vector<float> along_;
};

}  // namespace

std::vector<std::uint32_t> cut_places(const Places& places, int sets, CutRule rule) {
  return Cutter(places, rule).run(sets);
}

std::vector<Color8> set_means(std::span<const Histogram::Entry> entries,
                              std::span<const std::uint32_t> set) {
  struct Sums {
    std::array<std::uint64_t, 3> color{};
    std::uint64_t alpha = 0, count = 0;
  };
  std::vector<Sums> sums(set.empty() ? 0 : *std::max_element(set.begin(), set.end()) + 1);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto& [c, count] = entries[i];
    Sums& s = sums[set[i]];
    s.color[0] += c.r * c.a * count;
    s.color[1] += c.g * c.a * count;
    s.color[2] += c.b * c.a * count;
    s.alpha += c.a * count;
    s.count += count;
  }
  const auto mean = [](std::uint64_t sum, std::uint64_t n) {
    return n == 0 ? std::uint8_t{0} : static_cast<std::uint8_t>((2 * sum + n) / (2 * n));
  };
  std::vector<Color8> means;
  for (const Sums& s : sums) {
    if (s.count == 0) continue;
    means.push_back({mean(s.color[0], s.alpha), mean(s.color[1], s.alpha),
                     mean(s.color[2], s.alpha), mean(s.alpha, s.count)});
  }
  return means;
}

}  // namespace detail

namespace {

std::vector<Color8> choose_by_cuts(const PaletteTask& task, detail::CutRule rule) {
  const detail::Places places = detail::places_of(task.entries, *task.metric);
  return detail::set_means(task.entries, detail::cut_places(places, task.colors, rule));
}

}  // namespace

std::vector<Color8> choose_variance_cut(const PaletteTask& task) {
  return choose_by_cuts(task, detail::CutRule::kWidestAxis);
}
std::vector<Color8> choose_principal_cut(const PaletteTask& task) {
  return choose_by_cuts(task, detail::CutRule::kPrincipalAxis);
}
std::vector<Color8> choose_wu(const PaletteTask& task) {
  return choose_by_cuts(task, detail::CutRule::kBestAxis);
}

}  // namespace tristim
