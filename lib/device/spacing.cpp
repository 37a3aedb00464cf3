#include "lib/device/spacing.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "lib/color/cie1976.h"
#include "lib/color/precise_curves.h"
#include "lib/core/math.h"
#include "lib/core/rounding.h"
#include "tristim/color/transfer.h"
#include "tristim/core/text.h"
#include "tristim/device/monotone.h"

namespace tristim {
namespace {

using detail::decimal;
using Dd = detail::DoubleDouble;

// x^y where x may be 0 or below by a rounding: 0 then.
Dd power(Dd x, Dd y) noexcept { return x.hi > 0 ? detail::pow_precise(x, y) : Dd(0); }

constexpr detail::SpacingCurve kRatio{
    [](Dd i, const LevelTable&) noexcept { return detail::log_precise(i); },
    [](Dd p, const LevelTable&) noexcept { return detail::exp_precise(p); }};

constexpr detail::SpacingCurve kLstar{
    [](Dd i, const LevelTable&) noexcept { return detail::cie_lightness(i); },
    [](Dd p, const LevelTable&) noexcept {
      const Dd root = (p + 16) / 116;
      return p.hi > 8 ? root * root * root : p * 27 / 24389;
    }};

Dd peak(const LevelTable& table) noexcept { return decimal(table.peak_cd_m2) / kPqPeak; }
constexpr detail::SpacingCurve kPq{
    [](Dd i, const LevelTable& t) noexcept { return detail::pq_encode_precise(i * peak(t)); },
    [](Dd p, const LevelTable& t) noexcept { return detail::pq_decode_precise(p) / peak(t); }};

constexpr detail::SpacingCurve kSrgb{
    [](Dd i, const LevelTable&) noexcept { return detail::srgb_encode_precise(i); },
    [](Dd p, const LevelTable&) noexcept { return detail::srgb_decode_precise(p); }};

constexpr detail::SpacingCurve kGamma{
    [](Dd i, const LevelTable& t) noexcept { return power(i, 1 / decimal(t.gamma)); },
    [](Dd p, const LevelTable& t) noexcept { return power(p, decimal(t.gamma)); }};

constexpr detail::SpacingCurve kBt1886{
    [](Dd i, const LevelTable&) noexcept { return power(i, Dd(5) / 12); },
    [](Dd p, const LevelTable&) noexcept { return power(p, Dd(12) / 5); }};

constexpr detail::SpacingCurve kMeasured{
    [](Dd i, const LevelTable& t) noexcept {
      const TableResponse& m = *t.measured;
      return Dd(monotone_inverse(m.code, m.luminance, (i * m.luminance.back()).value()));
    },
    [](Dd p, const LevelTable& t) noexcept {
      const TableResponse& m = *t.measured;
      return Dd(monotone_value(m.code, m.luminance, p.value())) / m.luminance.back();
    }};

std::invalid_argument invalid(const std::string& what) { return std::invalid_argument(what); }

void check(const LevelTable& table) {
  const LevelSpacing& spacing = spacing_of(table);
  if (table.n < 1 || table.n > 65535) {
    throw invalid("n: " + std::to_string(table.n) + " is not in 1..65535");
  }
  if (!(table.i0 > 0 && table.i0 < 1)) {
    throw invalid("i0: " + shortest(table.i0) + " is not between 0 and 1");
  }
  if (!(table.gamma > 0) || !std::isfinite(table.gamma)) {
    throw invalid("gamma: " + shortest(table.gamma) + " is not above 0");
  }
  if (!(table.peak_cd_m2 > 0) || !std::isfinite(table.peak_cd_m2)) {
    throw invalid("peak: " + shortest(table.peak_cd_m2) + " is not above 0");
  }
  if (spacing.curve == &kRatio && table.from_zero) {
    throw invalid("from zero: there is no ratio to 0");
  }
  if (spacing.curve == &kMeasured && !table.measured) {
    throw invalid("spacing: measured needs a measured response");
  }
}

}  // namespace

const std::vector<LevelSpacing>& level_spacings() {
  static const std::vector<LevelSpacing> spacings = {
      {"ratio", "I_j = I0^((n-j)/n), r = (1/I0)^(1/n)", "[Shoaff 2.1.1]", &kRatio},
      {"lstar", "equal steps of L*", "[CIE15 8.2.1]", &kLstar},
      {"pq", "equal steps of PQ, intensity 1 at the peak luminance", "[ST2084]", &kPq},
      {"srgb", "equal steps of the sRGB curve", "[IEC61966]", &kSrgb},
      {"gamma", "equal steps of I^(1/gamma)", "[Shoaff 2.1.1]", &kGamma},
      {"bt1886", "equal steps of the BT.1886 signal: I_j = a max(j/n + b, 0)^2.4, I_0 the black",
       "[BT1886 annex 1]", &kBt1886},
      {"measured", "equal steps of the code of a measured response", "[FritschButland84]",
       &kMeasured}};
  return spacings;
}

const LevelSpacing& spacing_of(const LevelTable& table) {
  return table.spacing != nullptr ? *table.spacing : level_spacings().front();
}

double lowest_intensity(const LevelTable& table) noexcept { return table.from_zero ? 0 : table.i0; }

namespace detail {

LevelPositions::LevelPositions(const LevelTable& table)
    : table_(table), curve_(*spacing_of(table).curve) {
  check(table);
  low_ = curve_.position(table.from_zero ? Dd(0) : decimal(table.i0), table);
  high_ = curve_.position(1, table);
}

Dd LevelPositions::intensity(int j) const noexcept {
  if (j == 0) return table_.from_zero ? Dd(0) : decimal(table_.i0);
  if (j == table_.n) return 1;
  return curve_.intensity(low_ + (high_ - low_) * j / table_.n, table_);
}

Dd LevelPositions::position(double intensity) const noexcept {
  return (curve_.position(decimal(intensity), table_) - low_) / (high_ - low_) * table_.n;
}

int LevelPositions::nearest(double intensity) const noexcept {
  if (intensity <= 0) return 0;
  if (intensity > 1) return table_.n;
  const Dd place = position(intensity);
  if (!(place.hi > 0)) return 0;
  const double j = round_half_up(place);
  return static_cast<int>(std::min(j, double(table_.n)));
}

}  // namespace detail
}  // namespace tristim
