#include "lib/dither/mixtures.h"

#include <algorithm>
#include <cmath>

#include "lib/dither/simplices.h"

namespace tristim::detail {
namespace {

using Shares = std::array<float, Mixture::kParts>;

Shares shares_of(const Mixture& mixture, const Mixtures::Color& color) noexcept {
  Shares shares{};
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const auto& by = mixture.share;
    shares[i] = ((by[0][i] * color[0] + by[1][i] * color[1]) + by[2][i] * color[2]) + by[3][i];
  }
  return shares;
}

// NaN counts as 0.
int cell_of(float number) noexcept {
  const float held = number > 0 ? number : 0;
  return held < 1 ? static_cast<int>(std::sqrt(held) * Mixtures::kSide) : Mixtures::kSide - 1;
}

std::size_t cell_of(const Mixtures::Color& color) noexcept {
  const int cell = (cell_of(color[0]) * Mixtures::kSide + cell_of(color[1])) * Mixtures::kSide +
                   cell_of(color[2]);
  return static_cast<std::size_t>(cell);
}

float middle_of_cell(int cell) noexcept {
  const float root = (static_cast<float>(cell) + 0.5F) / Mixtures::kSide;
  return root * root;
}

Mixture mixture_of(const Simplex& simplex, int number, const MixPalette& palette) {
  std::array<std::size_t, Mixture::kParts> order{0, 1, 2, 3};
  const auto brightness = [&](std::size_t i) {
    const int entry = simplex.entry[i];
    return entry < 0 ? -1 : palette.luminance_rank(entry);
  };
  std::sort(order.begin(), order.end(),
            [&brightness](std::size_t a, std::size_t b) { return brightness(a) > brightness(b); });
  Mixture mixture{};
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t from = order[i];
    for (std::size_t k = 0; k < order.size(); ++k) {
      mixture.share[k][i] = static_cast<float>(
          simplex.inverse(static_cast<Eigen::Index>(from), static_cast<Eigen::Index>(k)));
    }
    mixture.entry[i] = simplex.entry[from] >= 0 ? static_cast<std::uint16_t>(simplex.entry[from])
                                                : mixture.entry[i - 1];
    const int next = simplex.next[from] >= 0 ? simplex.next[from] : number;
    mixture.next[i] = static_cast<std::uint16_t>(next);
  }
  mixture.next.back() = static_cast<std::uint16_t>(number);
  return mixture;
}

}  // namespace

Mixtures::Mixtures(const MixPalette& palette) {
  if (palette.size() > kMostEntries) return;
  for (const Simplex& simplex : simplices_of(palette, kMost)) {
    list_.push_back(mixture_of(simplex, static_cast<int>(list_.size()), palette));
  }
  std::size_t at = 0;
  for (int cell = 0; known() && cell < kSide * kSide * kSide; ++cell) {
    const int x = cell / (kSide * kSide);
    const int y = cell / kSide % kSide;
    const int z = cell % kSide;
    Shares shares{};
    at = walk({middle_of_cell(x), middle_of_cell(y), middle_of_cell(z)}, at, shares);
    start_.push_back(static_cast<std::uint16_t>(at));
  }
}

std::size_t Mixtures::walk(const Color& color, std::size_t from, Shares& shares) const noexcept {
  shares = shares_of(list_[from], color);
  for (int step = 1; step < kMostSteps; ++step) {
    std::size_t out = 0;
    while (out < shares.size() && !(shares[out] < -kRounding)) ++out;
    const std::size_t next = list_[from].next[out];
    if (next == from) break;
    from = next;
    shares = shares_of(list_[from], color);
  }
  return from;
}

std::uint16_t Mixtures::entry(const Color& color, float threshold) const noexcept {
  Shares shares{};
  const std::size_t at = walk(color, start_[cell_of(color)], shares);
  // In the order of the vectors' additions.
  const float two = shares[1] + shares[0];
  const float three = (shares[2] + shares[1]) + shares[0];
  const int below =
      (shares[0] < threshold ? 1 : 0) + (two < threshold ? 1 : 0) + (three < threshold ? 1 : 0);
  return list_[at].entry[static_cast<std::size_t>(below)];
}

}  // namespace tristim::detail
