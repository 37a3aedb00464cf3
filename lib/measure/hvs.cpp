#include <cmath>
#include <limits>
#include <stdexcept>

#include "lib/core/fast_exp.h"
#include "lib/core/math.h"
#include "lib/measure/fourier.h"
#include "lib/measure/statistics.h"
#include "tristim/measure/vision.h"

namespace tristim {
namespace {

constexpr int kMostBorder = 64;

// Mannos and Sakrison's curve [Sullivan91 eq 5].
double mannos_sakrison(double f) noexcept {
  const double t = 0.114 * f;
  return 2.2 * (0.192 + t) * detail::fast_exp(-detail::fast_exp(1.1 * detail::log(t)));
}

// Powers of the two pictures in a plane, inside of its border.
struct Powers {
  double signal = 0, error = 0;
};

Powers powers_inside(const detail::ComplexPlane& plane, int border, int width, int height) {
  Powers powers;
  for (int y = border; y < border + height; ++y) {
    const std::complex<double>* row = plane.row(y);
    for (int x = border; x < border + width; ++x) {
      powers.signal += row[x].real() * row[x].real();
      powers.error += row[x].imag() * row[x].imag();
    }
  }
  return powers;
}

double snr(const detail::ComplexPlane& spectrum, const Viewing& viewing, int border, int width,
           int height) {
  const double scale = viewing.samples_per_degree;
  detail::ComplexPlane seen = spectrum;
  detail::multiply(seen, [&](int x, int y) {
    return viewing.filter->response(detail::frequency_of(x, seen.width) * scale,
                                    detail::frequency_of(y, seen.height) * scale);
  });
  detail::inverse_transform(seen);
  const Powers powers = powers_inside(seen, border, width, height);
  return powers.error > 0 ? detail::decibels(powers.signal / powers.error)
                          : std::numeric_limits<double>::infinity();
}

}  // namespace

double nasanen_response(double fx, double fy) noexcept {
  constexpr double kFall = 0.525 * 2.397895272798370544 + 3.91;  // .525 ln 11 + 3.91
  return detail::fast_exp(-std::sqrt(fx * fx + fy * fy) / kFall);
}

double campbell_response(double fx, double fy) noexcept {
  constexpr double kPeak = 7.89;    // cycles per degree
  constexpr double kOblique = 0.7;  // sensitivity to frequencies at 45 degrees
  const double square = fx * fx + fy * fy;
  if (square == 0) return 1;
  // cos 4t of the direction t
  const double cosine_square = fx * fx / square;
  const double cosine4 = 8 * cosine_square * (cosine_square - 1) + 1;
  const double f = std::sqrt(square) / ((1 - kOblique) / 2 * cosine4 + (1 + kOblique) / 2);
  if (f <= kPeak) return 1;
  static const double at_peak = mannos_sakrison(kPeak);
  return mannos_sakrison(f) / at_peak;
}

std::vector<double> hvs_snr(const LuminanceMap& reference, const LuminanceMap& result,
                            std::span<const Viewing> viewings) {
  detail::check_sizes(reference, result);
  const int border = std::min(kMostBorder, std::min(reference.width, reference.height) / 2);
  detail::ComplexPlane spectrum = detail::mirrored_plane(
      reference.width, reference.height, border, detail::PlaneSize::kFast, [&](int x, int y) {
        const double light = reference.at(x, y);
        return std::complex<double>(light, result.at(x, y) - light);
      });
  detail::forward_transform(spectrum);
  if (reference.value == result.value) {  // no error: not even that of a transform
    return std::vector<double>(viewings.size(), std::numeric_limits<double>::infinity());
  }
  std::vector<double> all;
  for (const Viewing& viewing : viewings) {
    if (!(viewing.samples_per_degree > 0)) {
      throw std::invalid_argument("samples per degree are not above 0");
    }
    all.push_back(snr(spectrum, viewing, border, reference.width, reference.height));
  }
  return all;
}

}  // namespace tristim
