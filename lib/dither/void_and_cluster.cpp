#include "lib/dither/void_and_cluster.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tristim::detail {
namespace {

// Wider than the 1.5 of the source: fewer clumps in the mid tones.
constexpr double kSigma = 1.9;

// Dots as sparse as one in so many cells no longer feel each other: sigma is doubled, and again at
// a quarter of that, so that the first and the last ranks are spread evenly too.
constexpr std::size_t kSparse = 64;

// A generator of 64 bits with a formula: the standard's distributions differ between libraries
// [Steele14].
class SplitMix {
 public:
  explicit SplitMix(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() noexcept {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  std::size_t below(std::size_t bound) noexcept {
    return static_cast<std::size_t>((next() >> 32) * bound >> 32);
  }

 private:
  std::uint64_t state_;
};

class VoidAndCluster {
 public:
  VoidAndCluster(const Torus& torus, std::uint64_t seed)
      : torus_(torus), random_(seed), chance_(torus.cells()) {
    for (std::int32_t& c : chance_) {
      c = static_cast<std::int32_t>(random_.below(Crowding::kChances));
    }
  }

  std::vector<std::size_t> order() {
    const std::size_t half = std::max<std::size_t>(torus_.cells() / 2, 1);
    Crowding crowding(torus_, kSigma, chance_);
    std::vector<std::size_t> first = even_start(crowding);
    std::vector<std::size_t> order = thinned(first);
    std::reverse(order.begin(), order.end());
    while (order.size() < half) {
      order.push_back(crowding.largest_void());
      crowding.put(order.back());
    }
    // From half on the cells without dots are the few: they go as the dots came.
    std::vector<std::size_t> dark;
    for (std::size_t cell = 0; cell < torus_.cells(); ++cell) {
      if (!crowding.has_dot(cell)) dark.push_back(cell);
    }
    for (const std::size_t cell : thinned(std::move(dark))) order.push_back(cell);
    return order;
  }

 private:
  // A tenth of the cells, moved one by one from the tightest cluster to the largest void until that
  // is where the dot came from. Each move lowers the sum of all crowding, so there is an end.
  std::vector<std::size_t> even_start(Crowding& crowding) {
    std::vector<std::size_t> cells(torus_.cells());
    std::iota(cells.begin(), cells.end(), std::size_t{0});
    const std::size_t count = std::max<std::size_t>(cells.size() / 10, 1);
    for (std::size_t i = 0; i < count; ++i) {
      std::swap(cells[i], cells[i + random_.below(cells.size() - i)]);
      crowding.put(cells[i]);
    }
    for (;;) {
      const std::size_t cluster = crowding.tightest_cluster();
      crowding.take(cluster);
      const std::size_t gap = crowding.largest_void();
      crowding.put(gap);
      if (gap == cluster) break;
    }
    std::vector<std::size_t> dots;
    for (std::size_t cell = 0; cell < torus_.cells(); ++cell) {
      if (crowding.has_dot(cell)) dots.push_back(cell);
    }
    return dots;
  }

  // `dots` in the order in which they go when the tightest cluster loses one each time.
  std::vector<std::size_t> thinned(std::vector<std::size_t> dots) {
    std::vector<std::size_t> gone;
    double sigma = kSigma;
    std::size_t sparse = torus_.cells() / kSparse;
    while (!dots.empty()) {
      Crowding crowding(torus_, sigma, chance_);
      for (const std::size_t dot : dots) crowding.put(dot);
      for (std::size_t left = dots.size(); left > sparse; --left) {
        gone.push_back(crowding.tightest_cluster());
        crowding.take(gone.back());
      }
      std::erase_if(dots, [&](std::size_t dot) { return !crowding.has_dot(dot); });
      sigma *= 2;
      sparse = dots.size() > 1 ? sparse / 4 : 0;
    }
    return gone;
  }

  Torus torus_;
  SplitMix random_;
  std::vector<std::int32_t> chance_;
};

}  // namespace

std::vector<std::size_t> void_and_cluster(const Torus& torus, std::uint64_t seed) {
  return VoidAndCluster(torus, seed).order();
}

}  // namespace tristim::detail
