#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "lib/dither/half_way.h"
#include "tristim/dither/whole_picture.h"

namespace tristim {
namespace {

constexpr int kSide = 8;
constexpr int kClasses[kSide * kSide] = {
#include "luts/knuth_dot_classes.csv"
};

int class_of(int x, int y) noexcept {
  return kClasses[(y & (kSide - 1)) * kSide + (x & (kSide - 1))];
}

struct Neighbour {
  int dx, dy;
  float weight;
};

constexpr std::array<Neighbour, 8> kNeighbours{
    {{-1, -1, 1}, {0, -1, 2}, {1, -1, 1}, {-1, 0, 2}, {1, 0, 2}, {-1, 1, 1}, {0, 1, 2}, {1, 1, 1}}};

// Neighbours of later classes; weights sum to 1. None of barons.
std::vector<Neighbour> later_neighbours(int x, int y) {
  std::vector<Neighbour> later;
  float sum = 0;
  for (const Neighbour& n : kNeighbours) {
    if (class_of(x + n.dx, y + n.dy) <= class_of(x, y)) continue;
    later.push_back(n);
    sum += n.weight;
  }
  for (Neighbour& n : later) n.weight /= sum;
  return later;
}

// The barons form a lattice: every eighth pixel of a row, in every fourth row, the next row's
// between them. Their errors go on as Sierra's lite kernel sends them.
constexpr Neighbour kBarons[] = {
    {kSide, 0, 0.5F}, {-kSide / 2, kSide / 2, 0.25F}, {kSide / 2, kSide / 2, 0.25F}};

class DotDiffusion {
 public:
  DotDiffusion(ImageView<const float> light, const MixLevels& levels,
               const WholePictureParameters& parameters)
      : light_(light),
        levels_(&levels.light),
        parameters_(&parameters),
        search_(detail::half_way_points(levels.light)),
        received_(light.width, light.height, 1),
        level_(light.width, light.height, 1) {}

  // Every pixel that lies as (x, y) does in its matrix.
  void choose_class(int x, int y) {
    const std::vector<Neighbour> later = later_neighbours(x, y);
    for (int py = y; py < light_.height; py += kSide) {
      for (int px = x; px < light_.width; px += kSide) give(px, py, later, choose(px, py));
    }
  }

  // More than a baron can take its neighbours do, the last first.
  void choose_baron(int x, int y) {
    float error = choose(x, y);
    std::array<Neighbour, kNeighbours.size()> others = kNeighbours;
    std::ranges::sort(others, [&](const Neighbour& a, const Neighbour& b) {
      return class_of(x + a.dx, y + a.dy) > class_of(x + b.dx, y + b.dy);
    });
    for (const Neighbour& other : others) error -= turn(x + other.dx, y + other.dy, error);
    give(x, y, kBarons, error);
  }

  ImageView<const std::uint16_t> level() const noexcept { return level_.view(); }

 private:
  // Takes a level; the error.
  float choose(int x, int y) noexcept {
    const float share = parameters_->share(x, y);
    const float clipped = std::clamp(*light_.pixel(x, y), levels_->front(), levels_->back());
    const float wanted = clipped + *received_.view().pixel(x, y) * share;
    const int level = search_.count_not_above(wanted);
    *level_.view().pixel(x, y) = static_cast<std::uint16_t>(level);
    return (wanted - (*levels_)[static_cast<std::size_t>(level)]) * share;
  }

  bool inside(int x, int y) const noexcept {
    return x >= 0 && y >= 0 && x < light_.width && y < light_.height;
  }

  // At the sides of the picture error is dropped.
  void give(int x, int y, std::span<const Neighbour> to, float error) noexcept {
    for (const Neighbour& n : to) {
      if (inside(x + n.dx, y + n.dy)) {
        *received_.view().pixel(x + n.dx, y + n.dy) += error * n.weight;
      }
    }
  }

  // Moves a pixel to the next level where that takes up more than half a step of `error`; the light
  // that this gives.
  float turn(int x, int y, float error) noexcept {
    if (!inside(x, y) || parameters_->share(x, y) < 1) return 0;
    std::uint16_t& level = *level_.view().pixel(x, y);
    const int to = level + (error > 0 ? 1 : -1);
    if (to < 0 || to >= static_cast<int>(levels_->size())) return 0;
    const float change = (*levels_)[static_cast<std::size_t>(to)] - (*levels_)[level];
    if (std::abs(error) <= std::abs(change) / 2) return 0;
    level = static_cast<std::uint16_t>(to);
    return change;
  }

  ImageView<const float> light_;
  const std::vector<float>* levels_;
  const WholePictureParameters* parameters_;
  LevelSearch search_;
  Raster<float> received_;
  Raster<std::uint16_t> level_;
};

}  // namespace

void dot_diffusion_channel(ImageView<const float> light, const MixLevels& levels,
                           const WholePictureParameters& parameters,
                           ImageView<std::uint16_t> codes) {
  struct Place {
    int x, y;
  };
  std::array<Place, kSide * kSide> by_class{};
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) by_class[static_cast<std::size_t>(class_of(x, y))] = {x, y};
  }
  DotDiffusion diffusion(light, levels, parameters);
  const std::span<const Place> barons = std::span<const Place>(by_class).last(2);
  for (const Place place : std::span(by_class).first(by_class.size() - barons.size())) {
    diffusion.choose_class(place.x, place.y);
  }
  for (int top = 0; top < light.height; top += kSide) {
    for (const Place baron : barons) {
      if (top + baron.y >= light.height) continue;
      for (int x = baron.x; x < light.width; x += kSide) diffusion.choose_baron(x, top + baron.y);
    }
  }
  for (int y = 0; y < light.height; ++y) {
    const auto from = diffusion.level().row(y);
    for (std::size_t x = 0; x < from.size(); ++x) codes.row(y)[x] = levels.code[from[x]];
  }
}

}  // namespace tristim
