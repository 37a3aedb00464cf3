// Munsell and colour names: colours a second on one thread. The bound is a million.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "tristim/color/cns.h"
#include "tristim/color/iscc_nbs.h"
#include "tristim/color/munsell.h"

namespace tristim {
namespace {

// Real colours anywhere in the renotation.
std::vector<Munsell> colors() {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Munsell> all;
  while (all.size() < 10000) {
    const Munsell m{100 * unit(random), 10 * unit(random), 40 * unit(random) * unit(random)};
    if (!std::isnan(xyy_to_munsell(munsell_to_xyy(m)).value)) all.push_back(m);
  }
  return all;
}

template <typename Color, typename Function>
void measure(benchmark::State& state, const std::vector<Color>& in, Function&& convert) {
  for (auto _ : state) {
    for (const Color& color : in) benchmark::DoNotOptimize(convert(color));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(in.size()));
}

std::vector<Xyy> stimuli() {
  std::vector<Xyy> all;
  for (const Munsell& m : colors()) all.push_back(munsell_to_xyy(m));
  return all;
}

void from_munsell(benchmark::State& state) { measure(state, colors(), munsell_to_xyy); }
void to_munsell(benchmark::State& state) { measure(state, stimuli(), xyy_to_munsell); }
void to_iscc_nbs(benchmark::State& state) {
  measure(state, stimuli(), [](Xyy xyy) { return iscc_nbs_name(xyy_to_munsell(xyy)); });
}
void to_cns(benchmark::State& state) {
  measure(state, stimuli(), [](Xyy xyy) { return cns_name(xyy_to_munsell(xyy)); });
}

BENCHMARK(from_munsell);
BENCHMARK(to_munsell);
BENCHMARK(to_iscc_nbs);
BENCHMARK(to_cns);

}  // namespace
}  // namespace tristim
