#include "lib/dither/crowding.h"

#include <algorithm>
#include <cmath>

#include "lib/core/math.h"

namespace tristim::detail {
namespace {

// What a dot adds to its own cell. A dot in every cell adds 2 pi sigma^2 as much, or 1.6e9 with the
// sigma of void_and_cluster.cpp, time included; wider Gaussians are for few dots.
constexpr double kOwnWeight = 1 << 26;

constexpr double kReach = 6;  // sigmas; there a weight is below 1

std::int32_t whole(double weight) {
  return static_cast<std::int32_t>(std::floor(kOwnWeight * weight + 0.5));
}

int wrapped(int at, int ring) { return (at % ring + ring) % ring; }

}  // namespace

Crowding::Bell Crowding::bell(int ring, double sigma) {
  const int reach = static_cast<int>(kReach * sigma);
  const int length = std::min(ring, 2 * reach + 1);
  Bell result{-(length / 2), std::vector<double>(static_cast<std::size_t>(length))};
  for (int offset = -reach; offset <= reach; ++offset) {
    const double r = offset / sigma;
    const int place = wrapped(offset - result.first, ring);
    result.weight[static_cast<std::size_t>(place)] += detail::exp(-r * r / 2);
  }
  return result;
}

Crowding::Crowding(const Torus& torus, double sigma, const std::vector<std::int32_t>& chance)
    : torus_(torus),
      across_(bell(torus.width, sigma)),
      down_(bell(torus.height, sigma)),
      along_(bell(torus.slices, sigma)),
      crowding_(torus.cells()),
      greatest_(crowding_),
      least_(crowding_) {
  for (std::size_t i = 0; i < chance.size(); ++i) crowding_[i] = kNoDot + chance[i];
  for (const double down : down_.weight) {
    for (const double across : across_.weight) plane_.push_back(whole(down * across));
  }
  for (const double along : along_.weight) time_.push_back(whole(along));
}

template <typename Add>
void Crowding::change(std::size_t cell, Add add) {
  const auto width = static_cast<std::size_t>(torus_.width);
  const std::size_t slice_cells = width * static_cast<std::size_t>(torus_.height);
  const int x = static_cast<int>(cell % width);
  const int y = static_cast<int>(cell % slice_cells / width);
  const int slice = static_cast<int>(cell / slice_cells);
  const auto run = [&](std::size_t begin, const std::int32_t* weight, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) add(crowding_[begin + i], weight[i]);
    greatest_.changed(begin, begin + count);
    least_.changed(begin, begin + count);
  };
  const std::size_t length = across_.weight.size();
  const auto left = static_cast<std::size_t>(wrapped(x + across_.first, torus_.width));
  const std::size_t until_seam = std::min(length, width - left);
  for (std::size_t i = 0; i < down_.weight.size(); ++i) {
    const int row = wrapped(y + down_.first + static_cast<int>(i), torus_.height);
    const std::size_t start =
        static_cast<std::size_t>(slice) * slice_cells + static_cast<std::size_t>(row) * width;
    const std::int32_t* weight = &plane_[i * length];
    run(start + left, weight, until_seam);
    if (until_seam < length) run(start, weight + until_seam, length - until_seam);
  }
  for (std::size_t i = 0; i < time_.size(); ++i) {
    const int other = wrapped(slice + along_.first + static_cast<int>(i), torus_.slices);
    if (other == slice) continue;
    run(static_cast<std::size_t>(other) * slice_cells + cell % slice_cells, &time_[i], 1);
  }
}

void Crowding::put(std::size_t cell) {
  change(cell, [](std::int32_t& sum, std::int32_t weight) { sum += weight; });
  crowding_[cell] -= kNoDot;
}

void Crowding::take(std::size_t cell) {
  crowding_[cell] += kNoDot;
  change(cell, [](std::int32_t& sum, std::int32_t weight) { sum -= weight; });
}

}  // namespace tristim::detail
