#include "tristim/measure/texture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/measure/fourier.h"
#include "lib/measure/minority.h"
#include "lib/measure/statistics.h"

namespace tristim {
namespace {

constexpr int kSegmentSide = 128;
constexpr int kLeastSide = 8;
constexpr double kFlat = 1e-9;  // range of luminance below which there is no texture

// Power by frequency, averaged over segments; the mean of the picture is taken out.
struct Periodogram {
  int side = 0;
  int segments = 0;
  std::vector<double> power;
  double total = 0;

  double at(int x, int y) const noexcept {
    return power[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) +
                 static_cast<std::size_t>(x)];
  }
};

// A triangle without its zeros at the ends, scaled so that the window keeps the power.
std::vector<double> bartlett_window(int side) {
  std::vector<double> window;
  double squares = 0;
  for (int k = 1; k <= side; ++k) {
    window.push_back(1 - std::fabs(2.0 * k / (side + 1) - 1));
    squares += window.back() * window.back();
  }
  for (double& w : window) w /= std::sqrt(squares);
  return window;
}

Periodogram periodogram(const LuminanceMap& picture, double mean) {
  Periodogram result;
  result.side = std::min({kSegmentSide, picture.width, picture.height});
  const int side = result.side;
  const std::vector<double> window = bartlett_window(side);
  result.power.resize(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  for (int top = 0; top + side <= picture.height; top += side / 2) {
    for (int left = 0; left + side <= picture.width; left += side / 2) {
      detail::ComplexPlane segment(side, side);
      for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
          segment.row(y)[x] = (picture.at(left + x, top + y) - mean) *
                              window[static_cast<std::size_t>(x)] *
                              window[static_cast<std::size_t>(y)];
        }
      }
      detail::forward_transform(segment);
      for (std::size_t i = 0; i < result.power.size(); ++i) {
        result.power[i] += std::norm(segment.value[i]);
      }
      ++result.segments;
    }
  }
  for (double& p : result.power) p /= result.segments;
  result.power[0] = 0;
  for (const double p : result.power) result.total += p;
  return result;
}

// The frequency of a coefficient times the side.
double radius_of(int x, int y, int side) noexcept {
  const int fx = std::min(x, side - x);
  const int fy = std::min(y, side - y);
  return std::sqrt(static_cast<double>(fx * fx + fy * fy));
}

RadialSpectrum radial(const Periodogram& periodogram) {
  struct Sums {
    double count = 0, power = 0, square = 0;
  };
  const int side = periodogram.side;
  std::vector<Sums> sums;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const auto ring = static_cast<std::size_t>(std::lround(radius_of(x, y, side)));
      if (sums.size() <= ring) sums.resize(ring + 1);
      const double power = periodogram.at(x, y);
      sums[ring].count += 1;
      sums[ring].power += power;
      sums[ring].square += power * power;
    }
  }
  RadialSpectrum spectrum;
  spectrum.segments = periodogram.segments;
  const double variance = periodogram.total / static_cast<double>(periodogram.power.size());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    RadialSpectrum::Ring ring;
    ring.frequency = static_cast<double>(i) / side;
    const double mean = sums[i].count > 0 ? sums[i].power / sums[i].count : 0;
    ring.power = mean / variance;
    if (mean > 0) {
      const double spread = sums[i].square / sums[i].count - mean * mean;
      ring.anisotropy = std::max(spread, 0.0) / (mean * mean);
    }
    spectrum.rings.push_back(ring);
  }
  return spectrum;
}

// Rings near the centre have few frequencies, those beyond 1/2 are cut off by the corners, and
// rings without power say nothing.
double mean_anisotropy_db(const RadialSpectrum& spectrum) {
  double strongest = 0;
  for (const RadialSpectrum::Ring& ring : spectrum.rings) {
    strongest = std::max(strongest, ring.power);
  }
  double sum = 0;
  int count = 0;
  for (const RadialSpectrum::Ring& ring : spectrum.rings) {
    const bool inside = ring.frequency > 0.05 && ring.frequency < 0.5;
    if (!inside || !(ring.power > strongest * 1e-6)) continue;
    sum += detail::decibels(std::max(ring.anisotropy, 1e-6));
    ++count;
  }
  return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

// Shares of the power: at low frequencies, and at (.5, .5), (0, .5), (.5, 0) and beside them.
void set_shares(const Periodogram& periodogram, TextureFigures& figures) {
  const int side = periodogram.side;
  const auto near_half = [side](int i) { return std::abs(i - side / 2) <= 1; };
  const auto near_zero = [side](int i) { return i <= 1 || i == side - 1; };
  double low = 0;
  double low_count = 0;
  double checker = 0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double power = periodogram.at(x, y);
      const double f = radius_of(x, y, side) / side;
      if (f > 0 && f <= figures.principal / 2) {
        low += power;
        low_count += 1;
      }
      const bool corner = near_half(x) && near_half(y);
      const bool edge = (near_half(x) && near_zero(y)) || (near_zero(x) && near_half(y));
      if (corner || edge) checker += power;
    }
  }
  figures.low_share = low / periodogram.total;
  figures.low_white = low_count / static_cast<double>(periodogram.power.size());
  figures.checker_share = checker / periodogram.total;
  figures.peak_share =
      *std::max_element(periodogram.power.begin(), periodogram.power.end()) / periodogram.total;
}

double mean_of(const LuminanceMap& picture, int left, int right, int top, int bottom) {
  double sum = 0;
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) sum += picture.at(x, y);
  }
  return sum / (static_cast<double>(right - left) * static_cast<double>(bottom - top));
}

double edge_bias(const LuminanceMap& picture) {
  const int w = picture.width;
  const int h = picture.height;
  const double centre = mean_of(picture, w / 4, 3 * w / 4, h / 4, 3 * h / 4);
  return std::fabs(mean_of(picture, 0, w, 0, 8) - centre) / std::max(centre, 1e-9);
}

// The frequency of the evenest pattern of a level [Ulichney87].
double principal_frequency(double level) noexcept {
  const double minority = std::min(level, 1 - level);
  return minority <= 0.25 ? std::sqrt(minority) : 0.5;
}

}  // namespace

std::optional<TextureFigures> texture_figures(const LuminanceMap& picture) {
  if (std::min(picture.width, picture.height) < kLeastSide) return {};
  const auto [least, most] = std::minmax_element(picture.value.begin(), picture.value.end());
  if (!(*most - *least >= kFlat)) return {};
  const double mean = mean_of(picture, 0, picture.width, 0, picture.height);
  TextureFigures figures;
  figures.level = (mean - *least) / (*most - *least);
  figures.principal = principal_frequency(figures.level);
  const Periodogram power = periodogram(picture, mean);
  figures.spectrum = radial(power);
  figures.anisotropy_db = mean_anisotropy_db(figures.spectrum);
  set_shares(power, figures);
  figures.edge_bias = edge_bias(picture);
  figures.minority = detail::minority_figures(picture, *least, *most, figures.level);
  return figures;
}

}  // namespace tristim
