#include "tristim/palette/mixing.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "lib/core/math.h"
#include "tristim/color/oklab.h"
#include "tristim/color/transfer.h"

namespace tristim {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

constexpr std::size_t kMost = 256;
constexpr std::size_t kFew = 32;

// More rounds and finer mixtures where they count for more and cost less.
constexpr int kRoundsOfFew = 12;
constexpr int kRoundsOfMany = 3;
constexpr int kStepsOfFew = 16;
constexpr int kStepsOfMany = 8;

constexpr double kPassedOn = 0.95;  // of an error, as diffusion to such palettes does
constexpr double kToe = 0.1;        // of the places in Oklab
constexpr double kNoise = 0.02;     // what an entry's distance counts beside that of the mixture
constexpr double kWay = 0.6;        // of the way to the optimum, which the next mixtures move

// Pixels of nearly one colour: 5 bits a channel.
struct Bin {
  Vector3d light = Vector3d::Zero();
  double weight = 0;
};

Vector3d light_of(Color8 c) {
  static const std::array<double, 256> decoded = [] {
    std::array<double, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
      table[i] = srgb_decode(static_cast<double>(i) / 255);
    }
    return table;
  }();
  return {decoded[c.r], decoded[c.g], decoded[c.b]};
}

std::uint8_t code_of(double light) {
  return static_cast<std::uint8_t>(255 * srgb_encode(std::clamp(light, 0.0, 1.0)) + 0.5);
}

// An error in light counts by the slope of lightness.
double slope(const Vector3d& light) {
  const double y = 0.2126 * light.x() + 0.7152 * light.y() + 0.0722 * light.z();
  return detail::pow(y + 0.01, -4.0 / 3);
}

std::vector<Bin> bins_of(const std::vector<Histogram::Entry>& entries) {
  std::vector<Bin> cells(std::size_t{1} << 15);
  for (const Histogram::Entry& entry : entries) {
    const Color8& c = entry.color;
    const int cell = (c.r >> 3) << 10 | (c.g >> 3) << 5 | c.b >> 3;
    Bin& bin = cells[static_cast<std::size_t>(cell)];
    bin.light += static_cast<double>(entry.count) * light_of(c);
    bin.weight += static_cast<double>(entry.count);
  }
  std::erase_if(cells, [](const Bin& bin) { return bin.weight == 0; });
  for (Bin& bin : cells) {
    bin.light /= bin.weight;
    bin.weight *= slope(bin.light);
  }
  return cells;
}

// The entries in planes, for a search that compilers make vectors of.
struct Entries {
  std::vector<Vector3d> light;
  std::array<std::vector<float>, 3> place;
  std::vector<float> distance;  // scratch

  explicit Entries(const std::vector<Vector3d>& lights) : light(lights), distance(lights.size()) {
    for (const Vector3d& c : lights) {
      const std::array<float, 3> at = place_of(c);
      for (std::size_t i = 0; i < 3; ++i) place[i].push_back(at[i]);
    }
  }

  static std::array<float, 3> place_of(const Vector3d& c) {
    const Oklab lab = linear_srgb_to_oklab_with_toe({c.x(), c.y(), c.z()}, kToe);
    return {static_cast<float>(lab.l), static_cast<float>(lab.a), static_cast<float>(lab.b)};
  }

  std::size_t nearest(const Vector3d& c) {
    const std::array<float, 3> at = place_of(c);
    for (std::size_t i = 0; i < distance.size(); ++i) {
      const float dx = place[0][i] - at[0];
      const float dy = place[1][i] - at[1];
      const float dz = place[2][i] - at[2];
      distance[i] = dx * dx + dy * dy + dz * dz;
    }
    return static_cast<std::size_t>(std::min_element(distance.begin(), distance.end()) -
                                    distance.begin());
  }
};

// The shares of entries in the mixtures of all bins, as normal equations: `between` entries, and of
// entries and colours.
struct Mixtures {
  Eigen::MatrixXd between;
  Eigen::MatrixX3d with_colors;
  Eigen::VectorXd used;
};

Mixtures mix(const std::vector<Bin>& bins, Entries& entries, int steps) {
  const auto n = static_cast<Index>(entries.light.size());
  Mixtures sums{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixX3d::Zero(n, 3),
                Eigen::VectorXd::Zero(n)};
  std::vector<Index> plan(static_cast<std::size_t>(steps));
  for (const Bin& bin : bins) {
    Vector3d owed = Vector3d::Zero();
    for (Index& chosen : plan) {
      const Vector3d wanted = bin.light + owed;
      const std::size_t nearest = entries.nearest(wanted);
      owed = kPassedOn * (wanted - entries.light[nearest]);
      chosen = static_cast<Index>(nearest);
    }
    const double part = bin.weight / steps;
    for (const Index i : plan) {
      sums.used[i] += part;
      sums.with_colors.row(i) += part * bin.light.transpose();
      for (const Index j : plan) sums.between(i, j) += part / steps;
    }
  }
  return sums;
}

// The entries that make the mixtures come nearest to their colours; those that little depends on
// stay about where they are.
Eigen::MatrixX3d optimum(const Mixtures& sums, const Eigen::MatrixX3d& now) {
  constexpr double kStay = 1e-4;
  const auto n = static_cast<double>(sums.used.size());
  const Eigen::VectorXd stay = kStay * sums.used.array() + 1e-6 * sums.used.sum() / n;
  Eigen::MatrixXd left = sums.between;
  left.diagonal() += kNoise * sums.used + stay;
  const Eigen::MatrixX3d right = (1 + kNoise) * sums.with_colors + stay.asDiagonal() * now;
  return left.ldlt().solve(right);
}

bool holds_all(const std::vector<Color8>& palette, const std::vector<Histogram::Entry>& entries) {
  if (entries.size() > palette.size()) return false;
  const std::set<Color8> colors(palette.begin(), palette.end());
  return std::all_of(entries.begin(), entries.end(), [&colors](const Histogram::Entry& entry) {
    return colors.contains(entry.color);
  });
}

}  // namespace

std::vector<Color8> refine_for_mixing(const Histogram& histogram, std::vector<Color8> palette,
                                      std::size_t keep) {
  const std::vector<Histogram::Entry> counted = histogram.entries();
  if (palette.size() > kMost || keep >= palette.size() || holds_all(palette, counted)) {
    return palette;
  }
  const std::vector<Bin> bins = bins_of(counted);
  const bool few = palette.size() <= kFew;
  std::vector<Vector3d> lights;
  for (const Color8& c : palette) lights.push_back(light_of(c));
  for (int round = 0; round < (few ? kRoundsOfFew : kRoundsOfMany); ++round) {
    Entries entries(lights);
    const Mixtures sums = mix(bins, entries, few ? kStepsOfFew : kStepsOfMany);
    Eigen::MatrixX3d now(static_cast<Index>(lights.size()), 3);
    for (std::size_t i = 0; i < lights.size(); ++i) now.row(static_cast<Index>(i)) = lights[i];
    const Eigen::MatrixX3d best = optimum(sums, now);
    for (std::size_t i = keep; i < lights.size(); ++i) {
      const Vector3d to = best.row(static_cast<Index>(i)).transpose();
      lights[i] = (lights[i] + kWay * (to - lights[i])).cwiseMax(0).cwiseMin(1);
    }
  }
  for (std::size_t i = keep; i < palette.size(); ++i) {
    palette[i] = {code_of(lights[i].x()), code_of(lights[i].y()), code_of(lights[i].z()),
                  palette[i].a};
  }
  return palette;
}

}  // namespace tristim
