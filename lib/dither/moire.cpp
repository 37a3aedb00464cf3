#include "tristim/dither/moire.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tristim {
namespace {

struct Frequency {
  double x = 0, y = 0;
};

// Along the dots and along the diagonals; the other directions are turns by 90 degrees.
std::array<Frequency, 2> frequencies(const ReachedScreen& screen) {
  const double length = std::sqrt(double(screen.a) * screen.a + double(screen.b) * screen.b);
  const double x = screen.lpi * screen.a / length;
  const double y = screen.lpi * screen.b / length;
  return {Frequency{x, y}, Frequency{x - y, y + x}};
}

double slowest_difference(const ReachedScreen& a, const ReachedScreen& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const Frequency& f : frequencies(a)) {
    for (Frequency g : frequencies(b)) {
      for (int turn = 0; turn < 4; ++turn) {
        const double x = f.x - g.x;
        const double y = f.y - g.y;
        least = std::min(least, std::sqrt(x * x + y * y));
        g = {-g.y, g.x};
      }
    }
  }
  return least;
}

}  // namespace

std::vector<Beat> beats(std::span<const ReachedScreen> screens, double least) {
  constexpr double kSame = 1e-9;  // of the ruling: what roundings leave
  std::vector<Beat> all;
  for (std::size_t i = 0; i < screens.size(); ++i) {
    for (std::size_t j = i + 1; j < screens.size(); ++j) {
      const double ruling = std::min(screens[i].lpi, screens[j].lpi);
      double lpi = slowest_difference(screens[i], screens[j]);
      if (lpi < kSame * ruling) lpi = 0;
      all.push_back({i, j, lpi, ruling / lpi, lpi > 0 && lpi < least * ruling});
    }
  }
  return all;
}

}  // namespace tristim
