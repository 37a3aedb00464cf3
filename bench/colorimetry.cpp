// What colorimetry of single colours costs on one core; a million colours a second is the aim.
#include <benchmark/benchmark.h>

#include <random>
#include <vector>

#include "tristim/color/cct.h"
#include "tristim/color/illuminant.h"
#include "tristim/color/observer.h"
#include "tristim/color/wavelength.h"

namespace tristim {
namespace {

constexpr std::size_t kColors = 4096;

// Colours about the white, as lamps and pictures have them.
std::vector<Chromaticity> colors() {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> offset(-0.1, 0.1);
  std::vector<Chromaticity> all;
  for (std::size_t i = 0; i < kColors; ++i) {
    all.push_back({kD65.x + offset(random), kD65.y + offset(random)});
  }
  return all;
}

template <typename Function>
void each_color(benchmark::State& state, Function function) {
  const std::vector<Chromaticity> all = colors();
  for (auto _ : state) {
    for (const Chromaticity c : all) benchmark::DoNotOptimize(function(c));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kColors));
}

void correlated_color_temperature(benchmark::State& state) {
  each_color(state, [](Chromaticity c) { return color_temperature(c); });
}
BENCHMARK(correlated_color_temperature);

void dominant_wavelengths(benchmark::State& state) {
  each_color(state, [](Chromaticity c) { return dominant_wavelength(c, kD65); });
}
BENCHMARK(dominant_wavelengths);

void planckian_chromaticities(benchmark::State& state) {
  double kelvins = 1000;
  for (auto _ : state) benchmark::DoNotOptimize(planckian_chromaticity(kelvins += 1));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(planckian_chromaticities);

void spectra_to_xyz(benchmark::State& state) {
  const Spectrum light = illuminant_spectrum(illuminants()[5]);
  const Spectrum grey{{380, 780}, {0.2, 0.3}};
  for (auto _ : state) {
    benchmark::DoNotOptimize(xyz_of_object(grey, light, observers()[0]));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(spectra_to_xyz);

}  // namespace
}  // namespace tristim
