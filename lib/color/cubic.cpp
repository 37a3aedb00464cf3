#include "lib/color/cubic.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tristim::detail {
namespace {

// Between `from` and `to`: where the cubic turns, in the order of the way, then `to`.
struct Stops {
  std::array<double, 3> at{};
  int count = 0;

  void add(double t, double from, double to) noexcept {
    if (t > std::min(from, to) && t < std::max(from, to)) at[static_cast<std::size_t>(count++)] = t;
  }
};

Stops stops(const Cubic& cubic, double from, double to) noexcept {
  const auto& [c0, c1, c2, c3] = cubic.c;
  Stops found;
  const double discriminant = c2 * c2 - 3 * c3 * c1;
  if (discriminant > 0) {
    const double q = -(c2 + std::copysign(std::sqrt(discriminant), c2));
    found.add(q / (3 * c3), from, to);  // out of range where c3 is 0
    found.add(c1 / q, from, to);
  }
  if (found.count == 2 && (found.at[0] > found.at[1]) == (from < to)) {
    std::swap(found.at[0], found.at[1]);
  }
  found.at[static_cast<std::size_t>(found.count++)] = to;
  return found;
}

// The root between two places of different signs with no turn in between, by Newton's method
// within a bracket that shrinks.
double root_between(const Cubic& cubic, double inside, double outside) noexcept {
  constexpr double kEnough = 0x1p-52;
  double t = (inside + outside) / 2;
  for (int i = 0; i < 60; ++i) {
    const double value = cubic(t);
    (value >= 0 ? inside : outside) = t;
    double next = t - value / cubic.slope(t);
    const bool bracketed = next > std::min(inside, outside) && next < std::max(inside, outside);
    if (!bracketed) next = (inside + outside) / 2;
    if (std::fabs(next - t) <= kEnough * t) return next;
    t = next;
  }
  return t;
}

}  // namespace

Places roots_and_turns(const Cubic& cubic, double from, double to) noexcept {
  Places places;
  const auto add = [&](double t) { places.at[static_cast<std::size_t>(places.count++)] = t; };
  double before = from;
  const Stops way = stops(cubic, from, to);
  for (int i = 0; i < way.count; ++i) {
    const double stop = way.at[static_cast<std::size_t>(i)];
    const bool was_inside = cubic(before) >= 0;
    if (was_inside != (cubic(stop) >= 0)) {
      add(was_inside ? root_between(cubic, before, stop) : root_between(cubic, stop, before));
    }
    if (stop != to) add(stop);
    before = stop;
  }
  return places;
}

double first_outside(const Cubic& cubic, double from, double to) noexcept {
  double before = from;
  const Stops way = stops(cubic, from, to);
  for (int i = 0; i < way.count; ++i) {
    const double stop = way.at[static_cast<std::size_t>(i)];
    if (cubic(stop) < 0) return root_between(cubic, before, stop);
    before = stop;
  }
  return to;
}

}  // namespace tristim::detail
