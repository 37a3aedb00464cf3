#include "lib/palette/reseat.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace tristim::detail {
namespace {

// What a place's distance costs.
double cost_of(Lessen lessen, double distance2) {
  if (lessen == Lessen::kSquares) return distance2;
  const double distance = std::sqrt(distance2);
  return lessen == Lessen::kDistances ? distance : distance * std::sqrt(distance);
}

// What is known of a mean and its places.
struct Seat {
  double weight = 0;
  double error = 0;
  double loss = 0;                  // about what the error grows by without it
  std::array<double, 4> squares{};  // of the distances from it, by axis
};

double least_distance2(const Places& means, std::size_t k) {
  double least = std::numeric_limits<double>::infinity();
  const Place at = means.at(k);
  for (std::size_t i = 0; i < means.size(); ++i) {
    if (i == k) continue;
    double sum = 0;
    for (std::size_t a = 0; a < 4; ++a) {
      const double d = double{means.axis[a][i]} - at[a];
      sum += d * d;
    }
    least = std::min(least, sum);
  }
  return least;
}

std::vector<Seat> seats_of(const Places& places, const Nearest& nearest, Lessen lessen,
                           const Places& means) {
  // Its places go to several neighbours, the nearest of which is the farthest from most.
  constexpr double kShare = 0.6;
  std::vector<Seat> seats(means.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::uint32_t k = nearest.index[i];
    Seat& seat = seats[k];
    const double w = places.weight[i];
    seat.weight += w;
    seat.error += w * cost_of(lessen, nearest.distance2[i]);
    for (std::size_t a = 0; a < 4; ++a) {
      const double d = double{places.axis[a][i]} - means.axis[a][k];
      seat.squares[a] += w * d * d;
    }
  }
  for (std::size_t k = 0; k < means.size(); ++k) {
    seats[k].loss = kShare * seats[k].weight * cost_of(lessen, least_distance2(means, k));
  }
  return seats;
}

void put(Places& means, std::size_t k, const Place& place) {
  for (std::size_t a = 0; a < 4; ++a) means.axis[a][k] = place[a];
}

// Two means for the places of one, on both sides of it along their widest axis.
void part(const Seat& seat, Places& means, std::size_t crowded, std::size_t spare) {
  constexpr double kAside = 0.8;  // standard deviations
  const auto widest = static_cast<std::size_t>(
      std::max_element(seat.squares.begin(), seat.squares.end()) - seat.squares.begin());
  const auto aside = static_cast<float>(kAside * std::sqrt(seat.squares[widest] / seat.weight));
  Place low = means.at(crowded);
  Place high = low;
  low[widest] -= aside;
  high[widest] += aside;
  put(means, crowded, low);
  put(means, spare, high);
}

// Reseats up to `most` means, each beside one whose error is clearly larger than the loss; how
// many.
int reseat(const std::vector<Seat>& seats, std::size_t fixed, int most, Places& means) {
  constexpr double kClearly = 0.8;
  std::vector<std::size_t> crowded(seats.size() - fixed);
  std::iota(crowded.begin(), crowded.end(), fixed);
  std::vector<std::size_t> spare = crowded;
  std::stable_sort(crowded.begin(), crowded.end(), [&seats](std::size_t a, std::size_t b) {
    return seats[a].error > seats[b].error;
  });
  std::stable_sort(spare.begin(), spare.end(), [&seats](std::size_t a, std::size_t b) {
    return seats[a].loss < seats[b].loss;
  });
  std::vector<bool> taken(seats.size());
  auto next = spare.begin();
  int done = 0;
  for (const std::size_t k : crowded) {
    if (taken[k]) continue;
    while (next != spare.end() && (taken[*next] || *next == k)) ++next;
    if (done == most || next == spare.end() || seats[*next].loss > kClearly * seats[k].error) break;
    taken[k] = taken[*next] = true;
    part(seats[k], means, k, *next);
    ++done;
  }
  return done;
}

double total(const std::vector<Seat>& seats) {
  double sum = 0;
  for (const Seat& seat : seats) sum += seat.error;
  return sum;
}

}  // namespace

void reseat_means(const GroupedPlaces& places, int tries, const MeanRounds& rounds, Places& means) {
  if (means.size() < rounds.fixed + 2) return;
  const auto judged = [&](const Places& at) {
    return seats_of(places.places, nearest_entries(places, at), rounds.lessen, at);
  };
  std::vector<Seat> seats = judged(means);
  int most = static_cast<int>(means.size() / 16) + 1;
  for (int i = 0; i < tries && most > 0; ++i) {
    Places moved = means;
    if (reseat(seats, rounds.fixed, most, moved) == 0) return;
    move_means(places, rounds, moved);
    std::vector<Seat> found = judged(moved);
    if (total(found) < total(seats)) {
      means = std::move(moved);
      seats = std::move(found);
    } else {
      most /= 2;
    }
  }
}

}  // namespace tristim::detail
