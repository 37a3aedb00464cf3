#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "lib/core/parallel.h"
#include "tristim/dither/whole_picture.h"

namespace tristim {
namespace {

constexpr int kReach = 10;  // of what a pixel's error does to the seen error of others
constexpr int kWidth = 2 * kReach + 1;
constexpr int kOwnEffort = 12;

// What may be done to a pixel. Of sparse dots the eye would rather see none: there the search only
// moves dots, which keeps the tone.
enum Freedom : std::uint8_t { kHeld, kTrades, kChanges };
constexpr float kSparse = 0.045F;

// How the errors of two pixels add up in the eye, by their distance: the autocorrelation of its
// point spread. Its transform is the square of the sensitivity exp(-f / k), so it is
// (1 + (r/r0)^2)^(-3/2), r0 = S / (pi k) at S pixels a degree; brought to 0 at the reach.
std::array<float, kWidth * kWidth> eye_correlation() {
  constexpr double kPi = 3.14159265358979323846;
  constexpr double kPixelsPerDegree = 40;
  constexpr double kDecay = 5.1689;  // .525 ln L + 3.91 cycles a degree at L = 11 cd/m2
  constexpr double kRadius = kPixelsPerDegree / (kPi * kDecay);
  constexpr double kEnd2 = (kReach + 1) * (kReach + 1);
  std::array<float, kWidth * kWidth> table{};
  for (int y = -kReach; y <= kReach; ++y) {
    for (int x = -kReach; x <= kReach; ++x) {
      const double r2 = x * x + y * y;
      const double s = 1 + r2 / (kRadius * kRadius);
      const double taper = std::max(1 - r2 / kEnd2, 0.0);
      table[static_cast<std::size_t>((y + kReach) * kWidth + x + kReach)] =
          static_cast<float>(taper * taper / (s * std::sqrt(s)));
    }
  }
  return table;
}

// One pixel's light by `change`, and that of a neighbour at (dx, dy) back, where there is one.
struct Move {
  int to_level = 0;
  int dx = 0, dy = 0;
  float change = 0;
  float gain = 0;  // how much less the eye sees, at least kLeastGain to be taken
};

constexpr float kLeastGain = 1e-6F;  // far above the rounding of sums, far below what is seen

class DirectSearch {
 public:
  DirectSearch(ImageView<const float> light, const MixLevels& levels,
               const WholePictureParameters& parameters)
      : width_(light.width),
        height_(light.height),
        threads_(parameters.threads),
        levels_(&levels.light),
        level_(light.width, light.height, 1),
        freedom_(light.width, light.height, 1),
        seen_(light.width + 2 * kReach, light.height + 2 * kReach, 1) {
    begin(light, levels, parameters);
  }

  // Goes once over the picture; whether anything changed.
  bool pass();

  ImageView<const std::uint16_t> level() const noexcept { return level_.view(); }

 private:
  void begin(ImageView<const float> light, const MixLevels& levels,
             const WholePictureParameters& parameters);
  std::uint8_t freedom_at(float target, float nearest) const noexcept;
  void see(const Raster<float>& error);
  bool pass_tile(int left, int top);
  Move best_move(int x, int y) const noexcept;
  void weigh(int x, int y, int to_level, Move& best) const noexcept;
  void weigh_trade(int x, int y, int dx, int dy, Move& best) const noexcept;
  void change(int x, int y, float by) noexcept;
  float light_at(int x, int y) const noexcept { return (*levels_)[*level_.view().pixel(x, y)]; }
  float seen_at(int x, int y) const noexcept { return *seen_.view().pixel(x + kReach, y + kReach); }
  float correlation(int dx, int dy) const noexcept {
    return correlation_[static_cast<std::size_t>((dy + kReach) * kWidth + dx + kReach)];
  }

  int width_, height_, threads_;
  const std::vector<float>* levels_;
  Raster<std::uint16_t> level_;
  Raster<std::uint8_t> freedom_;
  Raster<float> seen_;  // the error, correlated, with margins
  std::array<float, kWidth* kWidth> correlation_ = eye_correlation();
};

// Begins with diffusion to what the strength leaves of the light.
void DirectSearch::begin(ImageView<const float> light, const MixLevels& levels,
                         const WholePictureParameters& parameters) {
  MixLevels positions{levels.light, std::vector<std::uint16_t>(levels.light.size())};
  std::iota(positions.code.begin(), positions.code.end(), std::uint16_t{0});
  LevelDiffusion diffusion(positions, width_,
                           {.kernel = &kBlueDiffusion,
                            .serpentine = kBlueDiffusion.serpentine,
                            .jitter = kBlueDiffusion.jitter,
                            .seed = parameters.seed});
  LevelDiffusion nearest(positions, width_, {.settled = false});
  const std::vector<float> no_share(static_cast<std::size_t>(width_), 0.0F);
  std::vector<float> target(no_share.size());
  std::vector<std::uint16_t> nearest_level(no_share.size());
  Raster<float> error(width_, height_, 1);
  for (int y = 0; y < height_; ++y) {
    nearest.row({light.row(y).data(), width_, 1}, {nearest_level.data(), width_, 1}, no_share);
    for (int x = 0; x < width_; ++x) {
      const auto at = static_cast<std::size_t>(x);
      const float share = parameters.share(x, y);
      const float from = levels.light[nearest_level[at]];
      const float wanted = std::clamp(light.row(y)[at], levels.light.front(), levels.light.back());
      target[at] = share == 1 ? wanted : from + share * (wanted - from);
      *freedom_.view().pixel(x, y) = freedom_at(target[at], from);
    }
    diffusion.row({target.data(), width_, 1}, {level_.view().row(y).data(), width_, 1});
    for (int x = 0; x < width_; ++x) {
      const auto at = static_cast<std::size_t>(x);
      if (*freedom_.view().pixel(x, y) == kHeld) *level_.view().pixel(x, y) = nearest_level[at];
      *error.view().pixel(x, y) = light_at(x, y) - target[at];
    }
  }
  see(error);
}

std::uint8_t DirectSearch::freedom_at(float target, float nearest) const noexcept {
  if (target == nearest) return kHeld;
  const auto above = std::ranges::upper_bound(*levels_, target);
  const auto upper = above == levels_->end() ? above - 1 : above;
  const float step = *upper - *(upper - 1);
  return std::abs(target - nearest) < kSparse * step ? kTrades : kChanges;
}

// Correlates the error with the eye; outside of the picture there is none.
void DirectSearch::see(const Raster<float>& error) {
  detail::parallel_for_rows(height_ + 2 * kReach, threads_, [&](int row) {
    float* sum = seen_.view().row(row).data();
    for (int ky = 0; ky < kWidth; ++ky) {
      const int y = row - ky;
      if (y < 0 || y >= height_) continue;
      const float* from = error.view().row(y).data();
      const float* weight = &correlation_[static_cast<std::size_t>(ky * kWidth)];
      for (int kx = 0; kx < kWidth; ++kx) {
        for (int x = 0; x < width_; ++x) sum[x + kx] += weight[kx] * from[x];
      }
    }
  });
}

void DirectSearch::weigh(int x, int y, int to_level, Move& best) const noexcept {
  if (to_level < 0 || to_level >= static_cast<int>(levels_->size())) return;
  const float by = (*levels_)[static_cast<std::size_t>(to_level)] - light_at(x, y);
  const float gain = -by * (by * correlation(0, 0) + 2 * seen_at(x, y));
  if (gain > best.gain) best = {to_level, 0, 0, by, gain};
}

void DirectSearch::weigh_trade(int x, int y, int dx, int dy, Move& best) const noexcept {
  const int nx = x + dx;
  const int ny = y + dy;
  if (nx < 0 || ny < 0 || nx >= width_ || ny >= height_) return;
  const std::uint16_t other = *level_.view().pixel(nx, ny);
  if (other == *level_.view().pixel(x, y) || *freedom_.view().pixel(nx, ny) == kHeld) return;
  const float by = (*levels_)[other] - light_at(x, y);
  const float gain =
      -2 * by * (by * (correlation(0, 0) - correlation(dx, dy)) + seen_at(x, y) - seen_at(nx, ny));
  if (gain > best.gain) best = {other, dx, dy, by, gain};
}

Move DirectSearch::best_move(int x, int y) const noexcept {
  Move best{.gain = kLeastGain};
  const int level = *level_.view().pixel(x, y);
  if (*freedom_.view().pixel(x, y) == kChanges) {
    weigh(x, y, level - 1, best);
    weigh(x, y, level + 1, best);
  }
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) weigh_trade(x, y, dx, dy, best);
  }
  return best;
}

void DirectSearch::change(int x, int y, float by) noexcept {
  for (int ky = 0; ky < kWidth; ++ky) {
    float* seen = seen_.view().row(y + ky).data() + x;
    const float* weight = &correlation_[static_cast<std::size_t>(ky * kWidth)];
    for (int kx = 0; kx < kWidth; ++kx) seen[kx] += by * weight[kx];
  }
}

// Tiles of one colour of a 2 x 2 pattern are farther apart than a change reaches: they may go at
// the same time, and the result does not depend on which goes first.
constexpr int kTile = 64;
static_assert(kTile > 2 * (kReach + 1));

bool DirectSearch::pass_tile(int left, int top) {
  bool changed = false;
  for (int y = top; y < std::min(top + kTile, height_); ++y) {
    for (int x = left; x < std::min(left + kTile, width_); ++x) {
      if (*freedom_.view().pixel(x, y) == kHeld) continue;
      const Move move = best_move(x, y);
      if (move.change == 0) continue;
      if (move.dx != 0 || move.dy != 0) {
        *level_.view().pixel(x + move.dx, y + move.dy) = *level_.view().pixel(x, y);
        change(x + move.dx, y + move.dy, -move.change);
      }
      *level_.view().pixel(x, y) = static_cast<std::uint16_t>(move.to_level);
      change(x, y, move.change);
      changed = true;
    }
  }
  return changed;
}

bool DirectSearch::pass() {
  const int columns = (width_ + kTile - 1) / kTile;
  const int rows = (height_ + kTile - 1) / kTile;
  std::vector<std::uint8_t> changed(static_cast<std::size_t>(columns) *
                                    static_cast<std::size_t>(rows));
  for (int colour = 0; colour < 4; ++colour) {
    detail::parallel_for_rows((rows + 1) / 2, threads_, [&](int pair) {
      const int row = 2 * pair + colour / 2;
      for (int column = colour % 2; row < rows && column < columns; column += 2) {
        if (pass_tile(column * kTile, row * kTile)) {
          changed[static_cast<std::size_t>(row * columns + column)] = 1;
        }
      }
    });
  }
  return std::ranges::count(changed, 1) > 0;
}

}  // namespace

void direct_search_channel(ImageView<const float> light, const MixLevels& levels,
                           const WholePictureParameters& parameters,
                           ImageView<std::uint16_t> codes) {
  DirectSearch search(light, levels, parameters);
  const int passes = parameters.effort > 0 ? parameters.effort : kOwnEffort;
  for (int i = 0; i < passes && search.pass(); ++i) continue;
  for (int y = 0; y < light.height; ++y) {
    const auto from = search.level().row(y);
    for (std::size_t x = 0; x < from.size(); ++x) codes.row(y)[x] = levels.code[from[x]];
  }
}

}  // namespace tristim
