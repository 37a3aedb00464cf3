#include "lib/device/ink_areas.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <utility>

namespace tristim::detail {
namespace {

constexpr std::size_t kInks = 4;
constexpr std::size_t kBlack = 3;
constexpr double kGood = 1e-7;  // of light
constexpr double kDark = 1e-6;  // of light that an ink lets through: none of it is without a slope
constexpr double kOutside = 1e-6;  // of area: what is no more than that out of range is in range

using Three = std::array<double, 3>;

// One plane of areas, normal * areas = offset. With the three lights it leaves single areas.
struct AreaPlane {
  InkAreas normal;
  double offset;
};

// Four linear equations, each row with its right side behind it, by elimination with the largest
// pivot; false where they have no single solution.
bool solve(std::array<std::array<double, kInks + 1>, kInks>& rows, InkAreas& solution) {
  for (std::size_t k = 0; k < kInks; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < kInks; ++i) {
      if (std::fabs(rows[i][k]) > std::fabs(rows[pivot][k])) pivot = i;
    }
    if (!(std::fabs(rows[pivot][k]) > 1e-12)) return false;
    std::swap(rows[k], rows[pivot]);
    for (std::size_t i = k + 1; i < kInks; ++i) {
      const double factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= kInks; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  for (std::size_t k = kInks; k-- > 0;) {
    double sum = rows[k][kInks];
    for (std::size_t j = k + 1; j < kInks; ++j) sum -= rows[k][j] * solution[j];
    solution[k] = sum / rows[k][k];
  }
  return true;
}

// What each ink lets through of a channel.
InkAreas let_through(const InkAbsorption& absorbed, const InkAreas& areas, std::size_t channel) {
  InkAreas through{};
  for (std::size_t i = 0; i < kInks; ++i)
    through[i] = std::max(1 - areas[i] * absorbed[i][channel], kDark);
  return through;
}

// Newton's method for the areas on a plane that print `wanted`; true where it got there. Areas may
// leave [0, 1] a little on the way and at the end.
bool fit_areas(const InkAbsorption& absorbed, const Three& wanted, const AreaPlane& plane,
               InkAreas& areas) {
  constexpr int kMostRounds = 30;
  constexpr double kLeast = -20;
  constexpr double kMost = 3;
  for (int round = 0; round < kMostRounds; ++round) {
    std::array<std::array<double, kInks + 1>, kInks> rows{};
    double off_plane = plane.offset;
    for (std::size_t i = 0; i < kInks; ++i) off_plane -= plane.normal[i] * areas[i];
    double worst = std::fabs(off_plane);
    std::ranges::copy(plane.normal, rows[kBlack].begin());
    rows[kBlack][kInks] = off_plane;
    for (std::size_t j = 0; j < wanted.size(); ++j) {
      const InkAreas through = let_through(absorbed, areas, j);
      const double light = through[0] * through[1] * through[2] * through[3];
      rows[j][kInks] = wanted[j] - light;
      worst = std::max(worst, std::fabs(rows[j][kInks]));
      for (std::size_t i = 0; i < kInks; ++i) {
        rows[j][i] = -absorbed[i][j] * light / through[i];
      }
    }
    if (worst < kGood) return true;
    InkAreas step{};
    if (!solve(rows, step)) return false;
    for (std::size_t i = 0; i < kInks; ++i) {
      areas[i] = std::clamp(areas[i] + step[i], kLeast, kMost);
    }
  }
  return false;
}

// How far an area is out of range, and the plane that bounds it there.
struct Violation {
  double amount = 0;
  AreaPlane bound{};
};

Violation worst_violation(const InkAreas& areas) {
  Violation worst;
  for (std::size_t i = 0; i < kInks; ++i) {
    AreaPlane bare{};
    bare.normal[i] = 1;
    if (-areas[i] > worst.amount) worst = {-areas[i], bare};
    if (areas[i] - 1 > worst.amount) worst = {areas[i] - 1, {bare.normal, 1}};
  }
  return worst;
}

// The areas that print `wanted` lie on a curve, which is entered at a plane and left towards
// whatever bound is broken most. False where that does not end in range.
bool fit_in_range(const InkAbsorption& absorbed, const Three& wanted, AreaPlane plane,
                  InkAreas& areas) {
  constexpr int kMostBounds = 6;
  for (int i = 0; i < kMostBounds; ++i) {
    if (!fit_areas(absorbed, wanted, plane, areas)) return false;
    const Violation worst = worst_violation(areas);
    if (worst.amount <= kOutside) return true;
    plane = worst.bound;
  }
  return false;
}

// The same from the first of several beginnings that leads there, entered where it has `black`.
bool fit_from_any(std::initializer_list<InkAreas> beginnings, const InkAbsorption& absorbed,
                  const Three& wanted, double black, InkAreas& areas) {
  for (const InkAreas& beginning : beginnings) {
    areas = beginning;
    if (fit_in_range(absorbed, wanted, {{0, 0, 0, 1}, black}, areas)) return true;
  }
  return false;
}

InkAreas in_range(InkAreas areas) {
  for (double& area : areas) area = std::clamp(area, 0.0, 1.0);
  return areas;
}

double sum(const InkAreas& areas) { return areas[0] + areas[1] + areas[2] + areas[3]; }

// The most black that leaves every channel its light.
double most_black(const InkAbsorption& absorbed, const Three& wanted) {
  double most = 1;
  for (std::size_t j = 0; j < wanted.size(); ++j) {
    most = absorbed[kBlack][j] > 0 ? std::min(most, (1 - wanted[j]) / absorbed[kBlack][j]) : 0;
  }
  return std::max(most, 0.0);
}

// Least squares in range, area after area: light is linear in each of them.
void descend(const InkAbsorption& absorbed, const Three& wanted, double limit, InkAreas& areas) {
  constexpr int kRounds = 40;
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < kInks; ++i) {
      double slope2 = 0;
      double toward = 0;
      double others = 0;
      for (std::size_t k = 0; k < kInks; ++k) others += k == i ? 0 : areas[k];
      for (std::size_t j = 0; j < wanted.size(); ++j) {
        InkAreas through = let_through(absorbed, areas, j);
        through[i] = 1;
        const double bare = through[0] * through[1] * through[2] * through[3];
        const double slope = bare * absorbed[i][j];
        slope2 += slope * slope;
        toward += slope * (bare - wanted[j]);
      }
      if (!(slope2 > 1e-12)) continue;
      areas[i] = std::clamp(toward / slope2, 0.0, std::clamp(limit - others, 0.0, 1.0));
    }
  }
}

}  // namespace

InkAreas solve_areas(const InkAbsorption& absorbed, const Three& wanted, const InkAreas& first,
                     double limit) noexcept {
  constexpr InkAreas kNone{0, 0, 0, 0};
  constexpr InkAreas kHalf{0.5, 0.5, 0.5, 0};
  InkAreas areas{};
  const bool fits = fit_from_any({first, kHalf}, absorbed, wanted, first[kBlack], areas) ||
                    fit_from_any({kHalf}, absorbed, wanted, 0, areas);
  if (fits && sum(areas) <= limit + kOutside) return in_range(areas);
  // The other end of the curve, with as little ink as there can be, keeps the limit where any does.
  InkAreas least{};
  const double most = most_black(absorbed, wanted);
  const bool ends = fit_from_any({kNone, fits ? areas : kHalf}, absorbed, wanted, most, least);
  if (!ends || sum(least) > limit + kOutside) {
    areas = ends ? least : first;
    descend(absorbed, wanted, limit, areas);
    return in_range(areas);
  }
  areas = least;
  const bool limited = fits && fit_areas(absorbed, wanted, {{1, 1, 1, 1}, limit}, areas) &&
                       worst_violation(areas).amount <= kOutside;
  return in_range(limited ? areas : least);
}

}  // namespace tristim::detail
