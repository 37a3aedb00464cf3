// What error diffusion costs a pixel: the fast rows, the definition and zimg's library, and
// palettes.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <random>

#include "bench/peers/peers.h"
#include "bench/pictures.h"
#include "tristim/dither/levels.h"
#include "tristim/dither/palette.h"

namespace tristim::bench {
namespace {

constexpr int kRows = 64;  // a band, which the caches hold

Image noise_band() {
  Image band(kWidth, kRows, 1);
  std::ranges::copy(noise(std::size_t{kWidth} * kRows), band.view().data);
  return band;
}

// A channel in a band, as process has them.
void rows_together(benchmark::State& state, int bits) {
  const Image in = noise_band();
  Raster<std::uint16_t> out(kWidth, kRows, 1);
  LevelDiffusion diffusion(levels(bits), kWidth, {.settled = false});
  for (auto _ : state) {
    diffusion.rows(in.view(), out.view());
    benchmark::DoNotOptimize(out.view().data);
  }
  count_pixels(state, kWidth, kRows);
}
BENCHMARK_CAPTURE(rows_together, bits1, 1);
BENCHMARK_CAPTURE(rows_together, bits2, 2);
BENCHMARK_CAPTURE(rows_together, bits8, 8);
BENCHMARK_CAPTURE(rows_together, bits16, 16);

// Other kernels to 1 bit: one way, many rows at a time, or by their definition.
void kernel(benchmark::State& state, const DiffusionKernel& kernel, bool serpentine) {
  const Image in = noise_band();
  Raster<std::uint16_t> out(kWidth, kRows, 1);
  LevelDiffusion diffusion(
      levels(1), kWidth,
      {.kernel = &kernel, .serpentine = serpentine, .jitter = kernel.jitter, .settled = false});
  for (auto _ : state) {
    diffusion.rows(in.view(), out.view());
    benchmark::DoNotOptimize(out.view().data);
  }
  count_pixels(state, kWidth, kRows);
}
BENCHMARK_CAPTURE(kernel, jarvis_one_way, kJarvisJudiceNinke, false);
BENCHMARK_CAPTURE(kernel, jarvis_serpentine, kJarvisJudiceNinke, true);
BENCHMARK_CAPTURE(kernel, stevenson_arce_one_way, kStevensonArce, false);
BENCHMARK_CAPTURE(kernel, blue_diffusion_one_way, kBlueDiffusion, false);
BENCHMARK_CAPTURE(kernel, blue_diffusion_serpentine, kBlueDiffusion, true);
BENCHMARK_CAPTURE(kernel, ostromoukhov_serpentine, kOstromoukhov, true);

void definition(benchmark::State& state, int bits) {
  const Image in = noise_band();
  Raster<std::uint16_t> out(kWidth, kRows, 1);
  LevelDiffusion diffusion(levels(bits), kWidth, {.settled = false});
  for (auto _ : state) {
    for (int y = 0; y < kRows; ++y) {
      diffusion.row({in.view().row(y).data(), kWidth, 1}, {out.view().row(y).data(), kWidth, 1});
    }
    benchmark::DoNotOptimize(out.view().data);
  }
  count_pixels(state, kWidth, kRows);
}
BENCHMARK_CAPTURE(definition, bits1, 1);
BENCHMARK_CAPTURE(definition, bits8, 8);

// Colours of a smooth picture, which stay near each other, and their palette.
Image gradient() {
  Image image(kWidth, kRows, 3);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> grain(-0.02F, 0.02F);
  for (int y = 0; y < kRows; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      float* p = image.view().pixel(x, y);
      const float across = static_cast<float>(x) / kWidth;
      const float down = static_cast<float>(y) / kRows;
      p[0] = across + grain(random);
      p[1] = down * (1 - across) + grain(random);
      p[2] = 1 - down + grain(random);
    }
  }
  return image;
}

void to_palette(benchmark::State& state, int count, int threads) {
  const Image in = gradient();
  const MixPalette palette(entries(count), kMetrics[1], Mix::kLight);
  PaletteDiffusion diffusion(palette, kWidth, {.settled = false});
  Raster<std::uint16_t> indices(kWidth, kRows, 1);
  for (auto _ : state) {
    diffusion.rows(in.view(), indices.view(), threads);
    benchmark::DoNotOptimize(indices.view().data);
  }
  count_pixels(state, kWidth, kRows);
}
BENCHMARK_CAPTURE(to_palette, colors7, 7, 1);
BENCHMARK_CAPTURE(to_palette, colors16, 16, 1);
BENCHMARK_CAPTURE(to_palette, colors16_two_threads, 16, 2)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(to_palette, colors256, 256, 1);

// Encoded numbers to encoded numbers, with its error diffusion: no light.
void zimg_error_diffusion(benchmark::State& state, int bits) {
  const ToBytes diffuse = zimg_plane(kWidth, kRows, bits, ZimgDither::kErrorDiffusion);
  const Samples<float> in(std::size_t{kWidth} * kRows);
  std::ranges::copy(noise(in.size()), in.data());
  const Samples<std::uint8_t> out(in.size());
  for (auto _ : state) {
    diffuse(in.data(), out.data());
    benchmark::ClobberMemory();
  }
  count_pixels(state, kWidth, kRows);
}
BENCHMARK_CAPTURE(zimg_error_diffusion, bits1, 1);
BENCHMARK_CAPTURE(zimg_error_diffusion, bits8, 8);

}  // namespace
}  // namespace tristim::bench
