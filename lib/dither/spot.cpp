#include "tristim/dither/spot.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "lib/dither/sine.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

// The places where a spot is examined: an odd number, so that 0 and both ends are among them.
constexpr int kGrid = 65;
constexpr double kPi = 3.14159265358979323846;

double place(int i) { return 2.0 * i / (kGrid - 1) - 1; }

double value_of(const SpotFunction& spot, double x, double y) noexcept { return spot.value(x, y); }
double value_of(const Formula& spot, double x, double y) noexcept { return spot(x, y); }

double value_of(const SpotPicture& spot, double x, double y) noexcept {
  const double across = (x + 1) / 2 * spot.width - 0.5;
  const double down = (1 - y) / 2 * spot.height - 0.5;
  const auto pixel = [&spot](double column, double row) {
    const int i = (static_cast<int>(column) + spot.width) % spot.width;
    const int j = (static_cast<int>(row) + spot.height) % spot.height;
    return double{spot.value[static_cast<std::size_t>(j) * static_cast<std::size_t>(spot.width) +
                             static_cast<std::size_t>(i)]};
  };
  const double left = std::floor(across);
  const double top = std::floor(down);
  const double fx = across - left;
  const double fy = down - top;
  const double upper = pixel(left, top) + (pixel(left + 1, top) - pixel(left, top)) * fx;
  const double lower =
      pixel(left, top + 1) + (pixel(left + 1, top + 1) - pixel(left, top + 1)) * fx;
  return upper + (lower - upper) * fy;
}

std::string name_of(const SpotFunction& spot) { return std::string(spot.name); }
std::string name_of(const Formula& spot) { return spot.text(); }
std::string name_of(const SpotPicture& spot) { return spot.name; }

}  // namespace

double round_spot(double x, double y) noexcept { return 1 - (x * x + y * y); }

double euclidean_spot(double x, double y) noexcept {
  const double u = std::fabs(x);
  const double v = std::fabs(y);
  return u + v <= 1 ? 1 - (u * u + v * v) : (u - 1) * (u - 1) + (v - 1) * (v - 1) - 1;
}

double ellipse_spot(double x, double y) noexcept {
  const double u = std::fabs(x);
  const double v = std::fabs(y);
  const double w = 3 * u + 4 * v - 3;
  const double flat = 0.75;  // of the ellipses' axes
  if (w < 0) return 1 - (u * u + (v / flat) * (v / flat)) / 4;
  if (w > 1) return ((1 - u) * (1 - u) + ((1 - v) / flat) * ((1 - v) / flat)) / 4 - 1;
  return 0.5 - w;
}

double line_spot(double /*x*/, double y) noexcept { return -std::fabs(y); }

double diamond_spot(double x, double y) noexcept {
  const double u = std::fabs(x);
  const double v = std::fabs(y);
  if (u + v <= 0.75) return 1 - (u * u + v * v);
  if (u + v <= 1.23) return 1 - (0.85 * u + v);
  return (u - 1) * (u - 1) + (v - 1) * (v - 1) - 1;
}

double square_spot(double x, double y) noexcept { return -std::max(std::fabs(x), std::fabs(y)); }

double cosine_spot(double x, double y) noexcept {
  return (detail::cosine(kPi * x) + detail::cosine(kPi * y)) / 2;
}

double spot_value(const Spot& spot, double x, double y) noexcept {
  return std::visit([&](const auto& s) { return value_of(s, x, y); }, spot);
}

std::string spot_name(const Spot& spot) {
  return std::visit([](const auto& s) { return name_of(s); }, spot);
}

void check_spot(const Spot& spot) {
  double low = spot_value(spot, 0, 0);
  double high = low;
  for (int j = 0; j < kGrid; ++j) {
    for (int i = 0; i < kGrid; ++i) {
      const double value = spot_value(spot, place(i), place(j));
      if (!std::isfinite(value)) {
        throw std::invalid_argument("spot '" + spot_name(spot) + "' is " + shortest(value) +
                                    " at x = " + shortest(place(i)) + ", y = " +
                                    shortest(place(j)) + ", expected a number in all of the cell");
      }
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (!(low < high)) {
    throw std::invalid_argument("spot '" + spot_name(spot) + "' is " + shortest(low) +
                                " everywhere: no dot can grow");
  }
}

SpotCentres spot_centres(const Spot& spot) noexcept {
  SpotCentres centres;
  double high = spot_value(spot, 0, 0);
  double low = spot_value(spot, 1, 1);
  // Of several places the dot takes the nearest to the middle, the hole the nearest to a corner.
  const auto from_middle = [](double x, double y) { return x * x + y * y; };
  const auto from_corner = [&](double x, double y) {
    return from_middle(1 - std::fabs(x), 1 - std::fabs(y));
  };
  for (int j = 0; j < kGrid; ++j) {
    for (int i = 0; i < kGrid; ++i) {
      const double x = place(i);
      const double y = place(j);
      const double value = spot_value(spot, x, y);
      if (value > high ||
          (value == high && from_middle(x, y) < from_middle(centres.dot_x, centres.dot_y))) {
        high = value;
        centres.dot_x = x;
        centres.dot_y = y;
      }
      if (value < low ||
          (value == low && from_corner(x, y) < from_corner(centres.hole_x, centres.hole_y))) {
        low = value;
        centres.hole_x = x;
        centres.hole_y = y;
      }
    }
  }
  return centres;
}

}  // namespace tristim
