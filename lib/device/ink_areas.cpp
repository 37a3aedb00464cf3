#include "lib/device/ink_areas.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>

namespace tristim::detail {
namespace {

constexpr std::size_t kInks = 4;
constexpr std::size_t kBlack = 3;
constexpr double kGood = 1e-7;     // of light
constexpr double kOutside = 1e-6;  // of area: what is no more than that out of range is in range

using Three = std::array<double, 3>;

constexpr Eigen::Index kPlaneRow = 3;  // of the equations, behind three lights

constexpr Eigen::Index at(std::size_t i) { return static_cast<Eigen::Index>(i); }

// One plane of areas, normal * areas = offset. With the three lights it leaves single areas.
struct AreaPlane {
  InkAreas normal;
  double offset;
};

// False where the equations have no single solution.
bool solve(const Eigen::Matrix4d& factors, const Eigen::Vector4d& right,
           Eigen::Vector4d& solution) {
  const Eigen::PartialPivLU<Eigen::Matrix4d> lu(factors);
  if (!(lu.matrixLU().diagonal().cwiseAbs().minCoeff() > 1e-12)) return false;
  solution = lu.solve(right);
  return true;
}

// The light of a channel that all inks but one let through, by that one.
InkAreas without_each(const InkAbsorption& absorbed, const InkAreas& areas, std::size_t channel) {
  InkAreas through{};
  for (std::size_t i = 0; i < kInks; ++i) through[i] = 1 - areas[i] * absorbed[i][channel];
  const double colours = through[0] * through[1];
  const double others = through[2] * through[3];
  return {through[1] * others, through[0] * others, colours * through[3], colours * through[2]};
}

// Newton's method for the areas on a plane that print `wanted`; true where it got there. Areas may
// leave [0, 1] a little on the way and at the end.
bool fit_areas(const InkAbsorption& absorbed, const Three& wanted, const AreaPlane& plane,
               InkAreas& areas) {
  constexpr int kMostRounds = 14;
  constexpr double kLeast = -20;
  constexpr double kMost = 3;
  for (int round = 0; round < kMostRounds; ++round) {
    Eigen::Matrix4d factors;
    Eigen::Vector4d off;
    off[kPlaneRow] = plane.offset;
    for (std::size_t i = 0; i < kInks; ++i) {
      off[kPlaneRow] -= plane.normal[i] * areas[i];
      factors(kPlaneRow, at(i)) = plane.normal[i];
    }
    for (std::size_t j = 0; j < wanted.size(); ++j) {
      const InkAreas without = without_each(absorbed, areas, j);
      off[at(j)] = wanted[j] - without[0] * (1 - areas[0] * absorbed[0][j]);
      for (std::size_t i = 0; i < kInks; ++i) factors(at(j), at(i)) = -absorbed[i][j] * without[i];
    }
    if (off.cwiseAbs().maxCoeff() < kGood) return true;
    Eigen::Vector4d step;
    if (!solve(factors, off, step)) return false;
    for (std::size_t i = 0; i < kInks; ++i) {
      areas[i] = std::clamp(areas[i] + step[at(i)], kLeast, kMost);
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

enum class Fit {
  kInRange,
  kOutOfRange,  // found, but bounds are broken by turns
  kLost,        // not found
};

// The areas that print `wanted` lie on a curve, which is entered at a plane and left towards
// whatever bound is broken most.
Fit fit_in_range(const InkAbsorption& absorbed, const Three& wanted, AreaPlane plane,
                 InkAreas& areas) {
  constexpr int kMostBounds = 4;
  for (int i = 0; i < kMostBounds; ++i) {
    if (!fit_areas(absorbed, wanted, plane, areas)) return Fit::kLost;
    const Violation worst = worst_violation(areas);
    if (worst.amount <= kOutside) return Fit::kInRange;
    plane = worst.bound;
  }
  return Fit::kOutOfRange;
}

// The same from the first of several beginnings that is not lost, entered where it has `black`.
Fit fit_from_any(std::initializer_list<InkAreas> beginnings, const InkAbsorption& absorbed,
                 const Three& wanted, double black, InkAreas& areas) {
  Fit fit = Fit::kLost;
  for (const InkAreas& beginning : beginnings) {
    areas = beginning;
    fit = fit_in_range(absorbed, wanted, {{0, 0, 0, 1}, black}, areas);
    if (fit != Fit::kLost) break;
  }
  return fit;
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

// The area of one ink, up to `most`, that comes nearest to `wanted`: light is linear in it.
double nearest_area(const InkAbsorption& absorbed, const Three& wanted, const InkAreas& areas,
                    std::size_t ink, double most) {
  double slope2 = 0;
  double toward = 0;
  for (std::size_t j = 0; j < wanted.size(); ++j) {
    const double bare = without_each(absorbed, areas, j)[ink];
    const double slope = bare * absorbed[ink][j];
    slope2 += slope * slope;
    toward += slope * (bare - wanted[j]);
  }
  return slope2 > 1e-12 ? std::clamp(toward / slope2, 0.0, most) : std::min(areas[ink], most);
}

// Least squares in range, area after area.
void descend(const InkAbsorption& absorbed, const Three& wanted, double limit, InkAreas& areas) {
  constexpr int kMostRounds = 40;
  constexpr double kStill = 1e-5;
  for (int round = 0; round < kMostRounds; ++round) {
    double moved = 0;
    for (std::size_t i = 0; i < kInks; ++i) {
      const double others = sum(areas) - areas[i];
      const double most = std::clamp(limit - others, 0.0, 1.0);
      const double area = nearest_area(absorbed, wanted, areas, i, most);
      moved = std::max(moved, std::fabs(area - areas[i]));
      areas[i] = area;
    }
    if (moved < kStill) return;
  }
}

}  // namespace

InkAreas solve_areas(const InkAbsorption& absorbed, const Three& wanted, const InkAreas& first,
                     double limit) noexcept {
  constexpr InkAreas kNone{0, 0, 0, 0};
  constexpr InkAreas kHalf{0.5, 0.5, 0.5, 0};
  InkAreas areas{};
  Fit fit = fit_from_any({first, kHalf}, absorbed, wanted, first[kBlack], areas);
  if (fit == Fit::kLost) fit = fit_from_any({kHalf}, absorbed, wanted, 0, areas);
  const bool fits = fit == Fit::kInRange;
  if (fits && sum(areas) <= limit + kOutside) return in_range(areas);
  // The other end of the curve, with as little ink as there can be, keeps the limit where any does.
  InkAreas least{};
  const double most = most_black(absorbed, wanted);
  const bool ends = fit != Fit::kOutOfRange && fit_from_any({kNone, fits ? areas : kHalf}, absorbed,
                                                            wanted, most, least) == Fit::kInRange;
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
