#pragma once

#include <array>
#include <vector>

#include "tristim/color/rgb.h"

namespace tristim::detail {

/// The colour of a highlight by the cosine of the angle V.H: a light times Os times Fresnel's term,
/// summed over all wavelengths once for each of its places, so that it costs the same in RGB and in
/// 81 samples.
class FresnelTable {
 public:
  FresnelTable() = default;
  /// `color(cosine)` for 0..1.
  template <class F>
  explicit FresnelTable(F&& color) {
    for (int i = -1; i <= kSteps + 1; ++i) {
      // Beyond its ends the curve goes on as a cubic does.
      places_.push_back(i < 0 || i > kSteps ? Rgb{} : color(static_cast<double>(i) / kSteps));
    }
    places_.front() = beyond(places_[1], places_[2], places_[3], places_[4]);
    const std::size_t n = places_.size();
    places_.back() = beyond(places_[n - 2], places_[n - 3], places_[n - 4], places_[n - 5]);
  }

  bool empty() const noexcept { return places_.empty(); }

  /// By a cubic through four places. Within 1e-6 for indices of 1.01 and
  /// more; where light comes from the denser side, less near the critical angle.
  Rgb at(double cosine) const noexcept;

 private:
  static constexpr int kSteps = 1024;
  static Rgb beyond(const Rgb& a, const Rgb& b, const Rgb& c, const Rgb& d) noexcept {
    const auto next = [](double p, double q, double r, double s) {
      return 4 * p - 6 * q + 4 * r - s;
    };
    return {next(a.r, b.r, c.r, d.r), next(a.g, b.g, c.g, d.g), next(a.b, b.b, c.b, d.b)};
  }

  std::vector<Rgb> places_;  // one in front of cosine 0 and one behind 1
};

}  // namespace tristim::detail
