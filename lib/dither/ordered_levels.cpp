#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "lib/dither/ordered_kernels.h"

namespace tristim::detail {
namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();

constexpr std::size_t kFewLevels = 8;

// Bins of an eighth of an octave to 1/32768.
constexpr int kCoarsestShift = 20;
constexpr int kFinestShift = 8;
constexpr std::size_t kMostBins = 32768;  // 256 kB

// Rounding moves a light by 1/4 rank at most where ranks times steps stay below that.
constexpr double kExactRanks = 0x1p22;

bool are_even(const std::vector<float>& light, double ranks) {
  const double first = light.front();
  const double span = light.back() - first;
  const auto steps = static_cast<double>(light.size() - 1);
  if (ranks * steps > kExactRanks) return false;
  const double rounding = 0x1p-24 * std::max(std::fabs(first), std::fabs(double{light.back()}));
  for (std::size_t i = 0; i < light.size(); ++i) {
    const double place = first + span * static_cast<double>(i) / steps;
    if (std::fabs(light[i] - place) > rounding) return false;
  }
  return true;
}

std::int32_t bits_of(float x) { return std::bit_cast<std::int32_t>(x); }

}  // namespace

OrderedLevels::OrderedLevels(const MixLevels& mix, int matrix_ranks)
    : lowest(mix.light.front()),
      highest(mix.light.back()),
      ranks(static_cast<float>(matrix_ranks)),
      ranks_per_light(ranks / (highest - lowest)),
      levels_per_light(static_cast<float>(mix.light.size() - 1) / (highest - lowest)),
      last(static_cast<float>(mix.light.size() - 1)),
      search(mix.light),
      codes(mix.code.begin(), mix.code.end()) {
  for (std::size_t i = 0; i < mix.light.size(); ++i) {
    const bool is_last = i + 1 == mix.light.size();
    const float step = is_last ? 0 : mix.light[i + 1] - mix.light[i];
    levels.push_back({mix.light[i], is_last ? 0 : ranks / step});
    codes_count = (i == 0 || codes_count) && codes[i] == codes[0] + static_cast<std::int32_t>(i);
  }
  if (mix.light.size() == 1) return;
  if (mix.light.size() == 2) {
    way = LevelsWay::kTwo;
  } else if (are_even(mix.light, ranks)) {
    way = LevelsWay::kEven;
  } else if (mix.light.size() <= kFewLevels) {
    way = LevelsWay::kFew;
  } else if (mix.light[1] > 0) {
    int bin_shift = kCoarsestShift;
    while (bin_shift >= kFinestShift && !make_bins(bin_shift)) --bin_shift;
    if (bins.empty()) return;
    way = LevelsWay::kBins;
    guess = guess_between(mix.light);
  }
}

// False where two levels begin in one bin.
bool OrderedLevels::make_bins(int bin_shift) {
  bins.clear();
  shift = bin_shift;
  first_bin = bits_of(levels[1].light) >> shift;
  const auto count =
      static_cast<std::size_t>((bits_of(levels.back().light) >> shift) - first_bin + 1);
  if (count > kMostBins) return false;
  bins.assign(count, {kNever, 0});
  for (std::size_t i = 1; i < levels.size(); ++i) {
    const auto bin = static_cast<std::size_t>((bits_of(levels[i].light) >> shift) - first_bin);
    if (bins[bin].knot != kNever) {
      bins.clear();
      return false;
    }
    bins[bin].knot = levels[i].light;
  }
  std::uint32_t lower = 0;
  for (Bin& bin : bins) {
    bin.lower = lower;
    if (bin.knot != kNever) ++lower;
  }
  return true;
}

}  // namespace tristim::detail
