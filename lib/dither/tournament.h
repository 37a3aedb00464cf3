#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace tristim::detail {

/// Keeps the best of many numbers while some of them change: a tree of winners, kFanOut contestants
/// a match. Of equal ones the first wins. `Better` is std::less for the least, std::greater for the
/// greatest.
template <typename Better>
class Tournament {
 public:
  /// `numbers` is looked at again and again: the caller changes it in place, and tells.
  explicit Tournament(const std::vector<std::int32_t>& numbers) : numbers_(&numbers) {
    for (std::size_t size = numbers.size(); size > 1;) {
      size = (size + kFanOut - 1) / kFanOut;
      rounds_.push_back({std::vector<std::int32_t>(size), std::vector<std::uint8_t>(size), {}});
    }
    changed(0, numbers.size());
  }

  /// Numbers [begin, end) may have changed.
  void changed(std::size_t begin, std::size_t end) {
    if (!rounds_.empty()) mark(0, begin / kFanOut, (end + kFanOut - 1) / kFanOut);
  }

  /// Which number is the best.
  std::size_t best() {
    for (std::size_t round = 0; round < rounds_.size(); ++round) play(round);
    std::size_t place = 0;
    for (std::size_t round = rounds_.size(); round-- > 0;) {
      place = first_equal(contestants(round), place, rounds_[round].winner[place]);
    }
    return place;
  }

 private:
  static constexpr std::size_t kFanOut = 64;

  struct Round {
    std::vector<std::int32_t> winner;
    std::vector<std::uint8_t> is_stale;
    std::vector<std::size_t> stale;  // those places, each once
  };

  const std::vector<std::int32_t>& contestants(std::size_t round) const {
    return round == 0 ? *numbers_ : rounds_[round - 1].winner;
  }

  void mark(std::size_t round, std::size_t begin, std::size_t end) {
    Round& r = rounds_[round];
    for (std::size_t i = begin; i < end; ++i) {
      if (r.is_stale[i] == 0) r.stale.push_back(i);
      r.is_stale[i] = 1;
    }
  }

  void play(std::size_t round) {
    Round& r = rounds_[round];
    const std::vector<std::int32_t>& all = contestants(round);
    for (const std::size_t i : r.stale) {
      const std::size_t end = std::min(all.size(), (i + 1) * kFanOut);
      std::int32_t winner = all[i * kFanOut];
      for (std::size_t k = i * kFanOut + 1; k < end; ++k) {
        winner = Better()(all[k], winner) ? all[k] : winner;
      }
      r.winner[i] = winner;
      r.is_stale[i] = 0;
      if (round + 1 < rounds_.size()) mark(round + 1, i / kFanOut, i / kFanOut + 1);
    }
    r.stale.clear();
  }

  static std::size_t first_equal(const std::vector<std::int32_t>& all, std::size_t match,
                                 std::int32_t winner) {
    std::size_t place = match * kFanOut;
    while (all[place] != winner) ++place;
    return place;
  }

  const std::vector<std::int32_t>* numbers_;
  std::vector<Round> rounds_;
};

using LeastOf = Tournament<std::less<std::int32_t> >;
using GreatestOf = Tournament<std::greater<std::int32_t> >;

}  // namespace tristim::detail
