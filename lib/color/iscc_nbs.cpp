#include "tristim/color/iscc_nbs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tristim {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr double kNeutral = 0.5;  // chroma below which boxes of every hue are alike

constexpr IsccNbsName kNames[] = {
#include "luts/iscc_nbs_names.csv"
};

struct Range {
  double begin, end;
  constexpr bool contains(double x) const { return begin <= x && x < end; }
};

struct Block {
  Range hue, value, chroma;
  int number;
};

// In order of hue: those of one slice of hues stand together.
constexpr Block kBlocks[] = {
#include "luts/iscc_nbs_blocks.csv"
};

// Hues of the boxes go from 1 to 101.
constexpr int kFirstHue = 1;
constexpr int kHues = 100;

// Where the blocks of each whole hue number begin. Hues of boxes are whole numbers.
constexpr auto kBegin = [] {
  std::array<short, kHues + 1> begin{};
  int block = 0;
  for (int i = 0; i < kHues; ++i) {
    while (kBlocks[block].hue.end <= kFirstHue + i) ++block;
    begin[static_cast<std::size_t>(i)] = static_cast<short>(block);
  }
  return begin;
}();

// The number in [1, 101) that a hue is; 1 where there is none.
double hue_in_range(double hue) noexcept {
  if (!std::isfinite(hue)) return kFirstHue;
  const double turned = std::fmod(hue - kFirstHue, kHues);
  const double position = turned < 0 ? turned + kHues : turned;
  return kFirstHue + (position < kHues ? position : 0);
}

}  // namespace

std::span<const IsccNbsName> iscc_nbs_names() noexcept { return kNames; }

const IsccNbsName* iscc_nbs_name(Munsell munsell) noexcept {
  if (!(munsell.value >= 0 && munsell.chroma >= 0)) return nullptr;
  if (!std::isfinite(munsell.hue) && munsell.chroma >= kNeutral) return nullptr;
  const double hue = hue_in_range(munsell.hue);
  const auto slice = static_cast<std::size_t>(hue - kFirstHue);
  for (const Block* block = kBlocks + kBegin[slice]; block != std::end(kBlocks); ++block) {
    if (block->value.contains(munsell.value) && block->chroma.contains(munsell.chroma)) {
      return &kNames[block->number - 1];
    }
  }
  return nullptr;
}

}  // namespace tristim
