#include "lib/light/quadrature.h"

#include "lib/core/trigonometry.h"

namespace tristim::detail {
namespace {

constexpr int kCount = 40;

// P_n(x) and its derivative, n = kCount, by the three-term recurrence.
struct Legendre {
  double value, slope;
};

Legendre legendre(double x) noexcept {
  double before = 1;
  double value = x;
  for (int n = 2; n <= kCount; ++n) {
    const double next = ((2 * n - 1) * x * value - (n - 1) * before) / n;
    before = value;
    value = next;
  }
  return {value, kCount * (x * value - before) / (x * x - 1)};
}

std::array<Node, kCount> nodes() noexcept {
  std::array<Node, kCount> all{};
  for (int i = 0; i < kCount; ++i) {
    double x = -sine_cosine_deg(180 * (i + 0.75) / (kCount + 0.5)).cosine;
    for (int step = 0; step < 5; ++step) {
      const Legendre p = legendre(x);
      x -= p.value / p.slope;
    }
    const double slope = legendre(x).slope;
    all[static_cast<std::size_t>(i)] = {(1 + x) / 2, 1 / ((1 - x * x) * slope * slope)};
  }
  return all;
}

}  // namespace

const std::array<Node, kCount>& gauss_legendre() noexcept {
  static const std::array<Node, kCount> all = nodes();
  return all;
}

}  // namespace tristim::detail
