// What palettes cost for a picture of 3840x2160: counting, choosing 256 colours, mapping every
// pixel to them; beside libimagequant where it is installed. Processor time, one thread.
//
// The picture is a stand-in for a photograph: smooth light with noise, some 600,000 colours.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>

#include "bench/pictures.h"
#include "tristim/core/find.h"
#include "tristim/palette/quantize.h"
#include "tristim/palette/remap.h"

#ifdef TRISTIM_IMAGEQUANT
#include <libimagequant.h>
#endif

namespace tristim::bench {
namespace {

const Raster<std::uint8_t>& picture() {
  static const Raster<std::uint8_t> made = [] {
    Raster<std::uint8_t> rounded(kWidth, kHeight, 3);
    photograph([&](int x, int y, const std::array<double, 3>& codes) {
      std::ranges::transform(codes, rounded.view().pixel(x, y),
                             [](double code) { return static_cast<std::uint8_t>(code); });
    });
    return rounded;
  }();
  return made;
}

Histogram counted() {
  Histogram histogram;
  histogram.add(picture().view());
  return histogram;
}

void count(benchmark::State& state) {
  picture();
  for (auto _ : state) benchmark::DoNotOptimize(counted());
}
BENCHMARK(count)->Unit(benchmark::kMillisecond);

// Counting and choosing.
void choose(benchmark::State& state, const char* method, int colors) {
  picture();
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        build_palette(counted(), *find_by_name(kPaletteMethods, method), {.colors = colors}));
  }
}
BENCHMARK_CAPTURE(choose, popularity, "popularity", 256)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(choose, median_cut, "median-cut", 256)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(choose, octree, "octree", 256)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(choose, principal_cut, "principal-cut", 256)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(choose, wu, "wu", 256)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(choose, best_16, "best", 16)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(choose, best_256, "best", 256)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(choose, best_4096, "best", 4096)->Unit(benchmark::kMillisecond);

// Choosing alone, which grows no faster than K log K with K colours.
void best_of(benchmark::State& state) {
  const Histogram histogram = counted();
  for (auto _ : state) {
    benchmark::DoNotOptimize(build_palette(histogram, *find_by_name(kPaletteMethods, "best"),
                                           {.colors = static_cast<int>(state.range(0))}));
  }
}
BENCHMARK(best_of)->RangeMultiplier(8)->Range(2, 65536)->Unit(benchmark::kMillisecond);

// All of it: the picture's codes to positions, of its upper rows.
void best_and_map(benchmark::State& state) {
  const auto rows = static_cast<int>(state.range(0));
  Raster<std::uint16_t> positions(kWidth, rows, 1);
  const auto codes = picture().view().rows(0, rows);
  for (auto _ : state) {
    Histogram histogram;
    histogram.add(codes);
    const Quantized best = quantize(histogram, *find_by_name(kPaletteMethods, "best"), {});
    best.map.map(codes, positions.view());
    benchmark::DoNotOptimize(positions.view().data);
  }
}
BENCHMARK(best_and_map)
    ->Arg(kHeight)
    ->Arg(kHeight / 2)
    ->Arg(kHeight / 4)
    ->Unit(benchmark::kMillisecond);

// For scale.
void copy(benchmark::State& state) {
  const auto& from = picture();
  Raster<std::uint8_t> to(kWidth, kHeight, 3);
  for (auto _ : state) {
    for (int y = 0; y < kHeight; ++y) {
      std::ranges::copy(from.view().row(y), to.view().row(y).begin());
    }
    benchmark::DoNotOptimize(to.view().data);
  }
}
BENCHMARK(copy)->Unit(benchmark::kMillisecond);

#ifdef TRISTIM_IMAGEQUANT
void imagequant(benchmark::State& state) {
  const auto& from = picture();
  std::vector<std::uint8_t> rgba;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const std::uint8_t* p = from.view().pixel(x, y);
      rgba.insert(rgba.end(), {p[0], p[1], p[2], 255});
    }
  }
  std::vector<std::uint8_t> positions(std::size_t{kWidth} * kHeight);
  for (auto _ : state) {
    liq_attr* attributes = liq_attr_create();
    liq_set_speed(attributes, static_cast<int>(state.range(0)));
    liq_image* image = liq_image_create_rgba(attributes, rgba.data(), kWidth, kHeight, 0);
    liq_result* result = nullptr;
    if (liq_image_quantize(image, attributes, &result) != LIQ_OK) {
      state.SkipWithError("liq_image_quantize");
    } else {
      liq_set_dithering_level(result, 0);
      liq_write_remapped_image(result, image, positions.data(), positions.size());
      liq_result_destroy(result);
    }
    liq_image_destroy(image);
    liq_attr_destroy(attributes);
  }
}
// Its slowest, its usual and its fastest speed.
BENCHMARK(imagequant)
    ->Arg(1)
    ->Arg(4)
    ->Arg(10)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
#endif

}  // namespace
}  // namespace tristim::bench
