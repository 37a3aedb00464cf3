// What the reducer costs a pixel, beside what memory alone allows: reading float rows and writing
// bytes.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstring>
#include <random>

#include "tristim/core/find.h"
#include "tristim/device/display_file.h"
#include "tristim/pipeline/reduce.h"
#include "tristim/pipeline/stage.h"

namespace tristim {
namespace {

constexpr int kWidth = 3840;
constexpr int kRows = 64;

Image noise() {
  Image image(kWidth, kRows, 3);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> light(0, 1);
  for (int y = 0; y < kRows; ++y) {
    for (float& value : image.view().row(y)) value = light(random);
  }
  return image;
}

void count_pixels(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * kWidth * kRows);
}

// The floor: every float read once, one byte written for each.
void read_floats_write_bytes(benchmark::State& state) {
  const Image in = noise();
  std::vector<std::uint8_t> out(std::size_t{kWidth} * 3 * kRows);
  for (auto _ : state) {
    std::size_t i = 0;
    for (int y = 0; y < kRows; ++y) {
      for (const float value : in.view().row(y)) out[i++] = static_cast<std::uint8_t>(value);
    }
    benchmark::DoNotOptimize(out.data());
  }
  count_pixels(state);
}
BENCHMARK(read_floats_write_bytes);

// The peer that everybody writes first.
void naive_powf(benchmark::State& state) {
  const Image in = noise();
  std::vector<std::uint8_t> out(std::size_t{kWidth} * 3 * kRows);
  for (auto _ : state) {
    std::size_t i = 0;
    for (int y = 0; y < kRows; ++y) {
      for (const float x : in.view().row(y)) {
        const float e = x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1 / 2.4F) - 0.055F;
        out[i++] = static_cast<std::uint8_t>(255 * e + 0.5F);
      }
    }
    benchmark::DoNotOptimize(out.data());
  }
  count_pixels(state);
}
BENCHMARK(naive_powf);

void reduce(benchmark::State& state, const char* device, const char* dither) {
  const Image in = noise();
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
  count_pixels(state);
}
BENCHMARK_CAPTURE(reduce, srgb_nearest, "srgb", "none");
BENCHMARK_CAPTURE(reduce, srgb_bayer8, "srgb", "bayer8");
BENCHMARK_CAPTURE(reduce, srgb_floyd_steinberg, "srgb", "floyd-steinberg");
BENCHMARK_CAPTURE(reduce, laser_clustered8, "laser-300", "clustered8");
BENCHMARK_CAPTURE(reduce, epaper_4grey_floyd_steinberg, "epaper-4grey", "floyd-steinberg");
BENCHMARK_CAPTURE(reduce, epaper_7color_nearest, "epaper-7color", "none");
BENCHMARK_CAPTURE(reduce, epaper_7color_floyd_steinberg, "epaper-7color", "floyd-steinberg");

void convert_primaries(benchmark::State& state) {
  Image band = noise();
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
  count_pixels(state);
}
BENCHMARK(convert_primaries);

}  // namespace
}  // namespace tristim
