// What the reducer costs a pixel, device by device, and stages before it; chain.cpp has the whole
// beside what memory allows.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstring>

#include "bench/pictures.h"
#include "tristim/core/find.h"
#include "tristim/device/display_file.h"
#include "tristim/pipeline/reduce.h"
#include "tristim/pipeline/stage.h"

namespace tristim::bench {
namespace {

constexpr int kRows = 64;  // a band, which the caches hold

Image noise_band() {
  Image band(kWidth, kRows, 3);
  std::ranges::copy(noise(std::size_t{kWidth} * kRows * 3), band.view().data);
  return band;
}

void reduce(benchmark::State& state, const char* device, const char* dither) {
  const Image in = noise_band();
  const Display display = load_display(device);
  ReduceOptions options;
  options.dither = find_by_name(dither_methods(), dither)->method;
  options.metric = *find_by_name(kMetrics, "oklab-toe");
  Reducer reducer(display, options, kWidth);
  Image band(kWidth, kRows, 3);
  Raster<std::uint16_t> codes(kWidth, kRows, reducer.samples());
  for (auto _ : state) {
    for (int y = 0; y < kRows; ++y) {
      std::memcpy(band.view().row(y).data(), in.view().row(y).data(),
                  in.view().row(y).size_bytes());
    }
    reducer.reduce({band.view(), 0}, codes.view());
    benchmark::DoNotOptimize(codes.view().data);
  }
  count_pixels(state, kWidth, kRows);
}
BENCHMARK_CAPTURE(reduce, srgb_nearest, "srgb", "none");
BENCHMARK_CAPTURE(reduce, srgb_bayer8, "srgb", "bayer8");
BENCHMARK_CAPTURE(reduce, srgb_floyd_steinberg, "srgb", "floyd-steinberg");
BENCHMARK_CAPTURE(reduce, laser_clustered8, "laser-300", "clustered8");
BENCHMARK_CAPTURE(reduce, epaper_4grey_floyd_steinberg, "epaper-4grey", "floyd-steinberg");
BENCHMARK_CAPTURE(reduce, epaper_7color_nearest, "epaper-7color", "none");
BENCHMARK_CAPTURE(reduce, epaper_7color_floyd_steinberg, "epaper-7color", "floyd-steinberg");

void convert_primaries(benchmark::State& state) {
  Image band = noise_band();
  const Stage stage =
      ConvertPrimaries{rgb_from_rgb(find_by_name(primaries_list(), "display-p3")->primaries,
                                    Primaries{}, Adaptation::kBradford),
                       {},
                       {},
                       Adaptation::kBradford};
  StageCounts counts;
  for (auto _ : state) {
    apply(stage, {band.view(), 0}, counts);
    benchmark::DoNotOptimize(band.view().data);
  }
  count_pixels(state, kWidth, kRows);
}
BENCHMARK(convert_primaries);

}  // namespace
}  // namespace tristim::bench
