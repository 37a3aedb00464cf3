#include "lib/dither/nearest_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tristim::detail {
namespace {

using Color = MixPalette::Color;

// Numbers of cells: below 0, below 1, and all.
constexpr int kBelow = 5;
constexpr int kBelowOne = 49;
constexpr int kAll = 1 << ColorGrid::kBits;

// An entry is left out of a cell only where it is this much too far for the tangents, which are not
// the metric itself.
constexpr float kRoom = 1.1F;

// The square root is what the eye makes of light, roughly; the toe keeps its slope finite at 0.
double height(double light) {
  constexpr double kToe = 0.01;
  return std::sqrt(light + kToe);
}

int cell_number(double value) {
  if (value < 0) return static_cast<int>((1 - value / double{ColorGrid::kLow}) * kBelow);
  const double from = value < 1 ? 0 : 1;
  const double to = value < 1 ? 1 : double{ColorGrid::kHigh};
  const int first = value < 1 ? kBelow : kBelowOne;
  const int last = value < 1 ? kBelowOne : kAll;
  const double part = (height(value) - height(from)) / (height(to) - height(from));
  return first + std::min(static_cast<int>(part * (last - first)), last - first - 1);
}

bool same(const Color& a, const Color& b) {
  return std::equal(a.begin(), a.end(), b.begin(),
                    [](float x, float y) { return std::abs(x - y) < MixPalette::kEqual; });
}

}  // namespace

ColorGrid::ColorGrid() {
  std::array<int, std::size_t{1} << kBits> count{};
  for (std::size_t i = 0; i < kSteps; ++i) {
    const double value = (static_cast<double>(i) + 0.5) / double{kStepsPerUnit} + double{kLow};
    const auto number = static_cast<std::size_t>(cell_number(value));
    number_[i] = static_cast<std::uint8_t>(number);
    middle_[number] += static_cast<float>(value);
    ++count[number];
  }
  for (std::size_t i = 0; i < count.size(); ++i) {
    const auto steps = static_cast<float>(std::max(count[i], 1));
    middle_[i] /= steps;
    reach_[i] = steps / (2 * kStepsPerUnit);
  }
}

NearestCells::NearestCells(const MixPalette& palette)
    : palette_(&palette), cells_(ColorGrid::kCells), holds_entry_(ColorGrid::kCells, false) {
  for (int i = 0; i < palette.size(); ++i) {
    place_.push_back(palette.place(palette.entry(i)));
    for (int corner = 0; corner < 8; ++corner) {
      Color near = palette.entry(i);
      for (std::size_t c = 0; c < 3; ++c) {
        near[c] += (corner >> c & 1) != 0 ? MixPalette::kEqual : -MixPalette::kEqual;
      }
      holds_entry_[grid_.cell(near)] = true;
    }
  }
}

// With p the place of a colour and a that of an entry, |p - a|^2 is |p|^2 + |a|^2 - 2 a.p, and p is
// about p(m) + J (color - m) beside the middle m.
void NearestCells::fill(std::size_t cell) {
  const Color middle = grid_.middle(cell);
  const Color reach = grid_.reach(cell);
  const Color place = palette_->place(middle);
  std::array<Color, 3> tangent{};  // by number of the colour
  for (std::size_t c = 0; c < 3; ++c) {
    Color beside = middle;
    beside[c] += reach[c];
    const Color there = palette_->place(beside);
    for (std::size_t i = 0; i < 3; ++i) tangent[c][i] = (there[i] - place[i]) / reach[c];
  }
  std::vector<Candidate> all;
  for (const Color& entry : place_) {
    Candidate candidate{{}, 0, static_cast<std::int32_t>(all.size())};
    for (std::size_t k = 0; k < 3; ++k) {
      candidate.height += entry[k] * entry[k] - 2 * entry[k] * place[k];
      for (std::size_t c = 0; c < 3; ++c) candidate.slope[c] -= 2 * entry[k] * tangent[c][k];
    }
    all.push_back(candidate);  // its height is that of the middle as yet
  }
  const Candidate best =
      *std::min_element(all.begin(), all.end(),
                        [](const Candidate& a, const Candidate& b) { return a.height < b.height; });
  cells_[cell].first = static_cast<std::uint32_t>(candidates_.size());
  for (Candidate& candidate : all) {
    float gain = 0;  // at most, on the way from the middle to a corner
    for (std::size_t c = 0; c < 3; ++c) {
      gain += std::abs(candidate.slope[c] - best.slope[c]) * reach[c];
    }
    if (candidate.height - best.height > gain * kRoom) continue;
    for (std::size_t c = 0; c < 3; ++c) candidate.height -= candidate.slope[c] * middle[c];
    candidates_.push_back(candidate);
    ++cells_[cell].count;
  }
}

std::span<const NearestCells::Candidate> NearestCells::candidates(std::size_t cell) {
  if (cells_[cell].count == 0) fill(cell);
  return std::span(candidates_).subspan(cells_[cell].first, cells_[cell].count);
}

int NearestCells::equal_candidate(const Color& color) {
  for (const Candidate& candidate : candidates(grid_.cell(color))) {
    if (same(color, palette_->entry(candidate.entry))) return candidate.entry;
  }
  return -1;
}

int NearestCells::nearest(const Color& color) {
  int best = 0;
  float least = std::numeric_limits<float>::infinity();
  for (const Candidate& candidate : candidates(grid_.cell(color))) {
    const std::array<float, 3>& slope = candidate.slope;
    const float height =
        ((slope[0] * color[0] + slope[1] * color[1]) + slope[2] * color[2]) + candidate.height;
    if (height < least) {
      least = height;
      best = candidate.entry;
    }
  }
  return best;
}

}  // namespace tristim::detail
