#include "tristim/color/observer.h"

#include "tristim/core/find.h"

namespace tristim {
namespace {

constexpr int kFirst = 360;  // nm, of both tables
constexpr int kLast = 830;

Xyz sum(const std::vector<double>& power, const Observer& observer, const SumRule& rule) {
  Xyz xyz;
  for (std::size_t i = 0; i < power.size(); ++i) {
    const Xyz bar = matching_functions(observer, rule.lambda_nm(i));
    xyz.x += power[i] * bar.x;
    xyz.y += power[i] * bar.y;
    xyz.z += power[i] * bar.z;
  }
  return xyz;
}

Xyz scaled(Xyz xyz, double k) { return {xyz.x * k, xyz.y * k, xyz.z * k}; }

}  // namespace

std::span<const Observer> observers() noexcept {
  static const Observer list[] = {
      {"cie1931", "2", find_by_name(spectral_tables(), "cie1931")},
      {"cie1964", "10", find_by_name(spectral_tables(), "cie1964")},
  };
  return list;
}

const Observer* find_observer(std::string_view text) noexcept {
  for (const Observer& observer : observers()) {
    if (observer.field_deg == text) return &observer;
  }
  return find_by_name(observers(), text);
}

Xyz matching_functions(const Observer& observer, int lambda_nm) noexcept {
  if (lambda_nm < kFirst || lambda_nm > kLast) return {};
  const double* row = &observer.table->cells[4 * static_cast<std::size_t>(lambda_nm - kFirst)];
  return {row[1], row[2], row[3]};
}

Xyz xyz_of_light(const Spectrum& power, const Observer& observer, const SumRule& rule) {
  return scaled(sum(sampled(power, rule), observer, rule), kLuminousEfficacy * rule.step_nm);
}

Xyz xyz_of_object(const Spectrum& reflectance, const Spectrum& illuminant, const Observer& observer,
                  const SumRule& rule) {
  const std::vector<double> light = sampled(illuminant, rule);
  std::vector<double> reflected = sampled(reflectance, rule);
  for (std::size_t i = 0; i < light.size(); ++i) reflected[i] *= light[i];
  return scaled(sum(reflected, observer, rule), 1 / sum(light, observer, rule).y);
}

Chromaticity chromaticity_of_light(const Spectrum& power, const Observer& observer,
                                   const SumRule& rule) {
  const Xyz xyz = sum(sampled(power, rule), observer, rule);
  const double total = xyz.x + xyz.y + xyz.z;
  return {xyz.x / total, xyz.y / total};
}

}  // namespace tristim
