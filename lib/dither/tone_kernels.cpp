#include <algorithm>
#include <cstddef>

#include "tristim/dither/kernel.h"

namespace tristim {
namespace {

using Tones = std::array<ToneWeights, kTones>;

constexpr double kOstromoukhovWeights[][3] = {
#include "luts/ostromoukhov_2001.csv"
};
static_assert(std::size(kOstromoukhovWeights) == kTones);

struct KeyWeights {
  int level;
  double next, below_last, below;
};
constexpr KeyWeights kZhouFangWeights[] = {
#include "luts/zhou_fang_2003.csv"
};

// How far the threshold of 128 is raised at most, as a share of 127, by input level: the authors'
// program, linear in between.
struct KeyStrength {
  int level;
  double strength;
};
constexpr KeyStrength kZhouFangStrengths[] = {
    {0, 0},     {40, 0.30},  {44, 0.34},  {64, 0.50},  {80, 1},  {85, 1},
    {95, 0.17}, {102, 0.50}, {107, 0.70}, {112, 0.79}, {127, 1},
};

ToneWeights shares(double next, double below_last, double below) {
  const double sum = next + below_last + below;
  return {static_cast<float>(next / sum), static_cast<float>(below_last / sum),
          static_cast<float>(below / sum)};
}

// Two keys around a level and how far it is from the first to the second.
template <typename Key>
struct Between {
  const Key* from;
  const Key* to;
  double fraction;
  double mix(double a, double b) const { return a + (b - a) * fraction; }
};

template <typename Key, std::size_t N>
Between<Key> between(const Key (&keys)[N], int level) {
  const Key* to =
      std::find_if(keys, keys + N, [level](const Key& key) { return key.level >= level; });
  const Key* from = to == keys ? to : to - 1;
  const int gap = std::max(to->level - from->level, 1);
  return {from, to, static_cast<double>(level - from->level) / gap};
}

// Interpolated as shares, not as the integers of the table, which have different sums.
ToneWeights zhou_fang(int level) {
  const auto at = between(kZhouFangWeights, level);
  const double from = at.from->next + at.from->below_last + at.from->below;
  const double to = at.to->next + at.to->below_last + at.to->below;
  ToneWeights weights = shares(at.mix(at.from->next / from, at.to->next / to),
                               at.mix(at.from->below_last / from, at.to->below_last / to),
                               at.mix(at.from->below / from, at.to->below / to));
  const auto strength = between(kZhouFangStrengths, level);
  constexpr double kRange = 127.0 / 255;
  weights.raise =
      static_cast<float>(kRange * strength.mix(strength.from->strength, strength.to->strength));
  return weights;
}

}  // namespace

std::span<const ToneWeights> ostromoukhov_tones() {
  static const Tones tones = [] {
    Tones all{};
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto& w = kOstromoukhovWeights[i];
      all[i] = shares(w[0], w[1], w[2]);
    }
    return all;
  }();
  return tones;
}

std::span<const ToneWeights> zhou_fang_tones() {
  static const Tones tones = [] {
    Tones all{};
    for (int i = 0; i < kTones; ++i) all[static_cast<std::size_t>(i)] = zhou_fang(i);
    return all;
  }();
  return tones;
}

std::size_t tone_index(float fraction) noexcept {
  constexpr int kLast = 2 * kTones - 1;
  const int level = static_cast<int>(std::clamp(fraction, 0.0F, 1.0F) * kLast + 0.5F);
  return static_cast<std::size_t>(level < kTones ? level : kLast - level);
}

}  // namespace tristim
