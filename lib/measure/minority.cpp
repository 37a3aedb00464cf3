#include "lib/measure/minority.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "lib/core/parallel.h"
#include "lib/core/trigonometry.h"

namespace tristim::detail {
namespace {

constexpr int kMostSide = 512;
constexpr double kLeastDensity = 1e-4;
constexpr double kMostDensity = 0.12;  // above it the grid itself rules the distances
constexpr std::size_t kLeastPixels = 8;
constexpr std::size_t kMostJudged = 3000;  // whose distance to the nearest is looked for
constexpr std::size_t kDirections = 8;

struct Place {
  int x = 0, y = 0;
};

// Which pixels are of the rarer value.
struct Minority {
  int width = 0, height = 0;
  std::vector<std::uint8_t> set;
  std::vector<Place> places;  // row by row

  bool at(int x, int y) const noexcept {
    return set[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x)] != 0;
  }
};

bool two_values(const LuminanceMap& picture, double darkest, double lightest) {
  return std::all_of(picture.value.begin(), picture.value.end(),
                     [&](double v) { return v == darkest || v == lightest; });
}

Minority minority_of(const LuminanceMap& picture, double rarer) {
  Minority minority{
      std::min(picture.width, kMostSide), std::min(picture.height, kMostSide), {}, {}};
  for (int y = 0; y < minority.height; ++y) {
    for (int x = 0; x < minority.width; ++x) {
      const bool rare = picture.at(x, y) == rarer;
      minority.set.push_back(rare ? 1 : 0);
      if (rare) minority.places.push_back({x, y});
    }
  }
  return minority;
}

// Of eight sectors about the multiples of 22.5 degrees the one that a direction or its opposite is
// in.
std::size_t sector(int dx, int dy) noexcept {
  const double turn = angle_deg(dy, dx) / 180;
  return static_cast<std::size_t>((turn - std::floor(turn)) * kDirections + 0.5) % kDirections;
}

double pairs_at(const Minority& minority, int dx, int dy) {
  std::size_t pairs = 0;
  for (const Place& p : minority.places) {
    const int x = p.x + dx;
    const int y = p.y + dy;
    if (x < 0 || x >= minority.width || y < 0 || y >= minority.height) continue;
    if (minority.at(x, y)) ++pairs;
  }
  // relative to the pairs of places that there are
  return static_cast<double>(pairs) / (static_cast<double>(minority.width - std::abs(dx)) *
                                       static_cast<double>(minority.height - std::abs(dy)));
}

// Pairs at half to one and a half principal wavelengths, by direction.
double worm_figure(const Minority& minority, double wavelength) {
  const int reach = std::min(
      {static_cast<int>(std::ceil(1.5 * wavelength)), minority.width / 2, minority.height / 2});
  std::array<double, kDirections> sum{};
  std::array<double, kDirections> count{};
  // opposite directions have the same pairs, so half of the plane is enough
  for (int dy = 0; dy <= reach; ++dy) {
    for (int dx = dy == 0 ? 1 : -reach; dx <= reach; ++dx) {
      const double distance = std::sqrt(dx * dx + dy * dy);
      if (distance < 0.5 * wavelength || distance > 1.5 * wavelength) continue;
      const std::size_t s = sector(dx, dy);
      sum[s] += pairs_at(minority, dx, dy);
      count[s] += 1;
    }
  }
  double largest = 0;
  double total = 0;
  for (std::size_t s = 0; s < kDirections; ++s) {
    const double mean = sum[s] / std::max(count[s], 1.0);
    largest = std::max(largest, mean);
    total += mean;
  }
  return total > 0 ? largest * kDirections / total : std::numeric_limits<double>::quiet_NaN();
}

// The distance to the nearest other pixel of the minority, rows outwards.
double nearest_distance(const Minority& minority, Place p) {
  const auto infinity = std::numeric_limits<double>::infinity();
  double best = infinity;  // squared
  const auto look = [&](int y, int dy) {
    if (y < 0 || y >= minority.height) return;
    for (int dx = dy == 0 ? 1 : 0; dx < minority.width; ++dx) {
      const double square = static_cast<double>(dx) * dx + static_cast<double>(dy) * dy;
      if (square >= best) return;
      const bool right = p.x + dx < minority.width && minority.at(p.x + dx, y);
      const bool left = p.x - dx >= 0 && minority.at(p.x - dx, y);
      if (right || left) best = square;
    }
  };
  for (int dy = 0; dy < minority.height && static_cast<double>(dy) * dy < best; ++dy) {
    look(p.y + dy, dy);
    if (dy > 0) look(p.y - dy, dy);
  }
  return std::sqrt(best);
}

}  // namespace

std::optional<MinorityFigures> minority_figures(const LuminanceMap& picture, double darkest,
                                                double lightest, double level) {
  const double density = std::min(level, 1 - level);
  if (!(density > kLeastDensity) || density > kMostDensity) return {};
  if (!two_values(picture, darkest, lightest)) return {};
  const Minority minority = minority_of(picture, level <= 0.5 ? lightest : darkest);
  if (minority.places.size() < kLeastPixels) return {};

  const double wavelength = 1 / std::sqrt(density);
  MinorityFigures figures;
  figures.worm = worm_figure(minority, wavelength);
  const std::size_t places = minority.places.size();
  const std::size_t step = places > kMostJudged ? places / kMostJudged + 1 : 1;
  std::vector<double> distances((places + step - 1) / step);
  parallel_for_rows(static_cast<int>(distances.size()), 0, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    distances[at] = nearest_distance(minority, minority.places[at * step]);
  });
  const auto count = static_cast<double>(distances.size());
  const double mean = std::accumulate(distances.begin(), distances.end(), 0.0) / count;
  double square = 0;
  for (const double d : distances) square += (d - mean) * (d - mean);
  figures.nearest_ratio = mean / wavelength;
  figures.nearest_cv = std::sqrt(square / count) / mean;
  return figures;
}

}  // namespace tristim::detail
