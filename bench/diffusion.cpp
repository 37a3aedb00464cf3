// What error diffusion costs a pixel: the fast rows, the definition and zimg's library, and
// palettes.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <random>

#include "tristim/color/transfer.h"
#include "tristim/dither/levels.h"
#include "tristim/dither/palette.h"

#ifdef TRISTIM_ZIMG
#include <zimg.h>
#endif

namespace tristim {
namespace {

constexpr int kWidth = 3840;
constexpr int kRows = 64;  // a band, which the caches hold

Image noise(int channels) {
  Image image(kWidth, kRows, channels);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> light(0, 1);
  for (int y = 0; y < kRows; ++y) {
    for (float& value : image.view().row(y)) value = light(random);
  }
  return image;
}

MixLevels levels(int bits) {
  MixLevels made;
  const int last = (1 << bits) - 1;
  for (int i = 0; i <= last; ++i) {
    made.light.push_back(static_cast<float>(srgb_decode(static_cast<double>(i) / last)));
    made.code.push_back(static_cast<std::uint16_t>(i));
  }
  return made;
}

void count_pixels(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * kWidth * kRows);
}

// A channel in a band, as process has them.
void rows_together(benchmark::State& state, int bits) {
  const Image in = noise(1);
  Raster<std::uint16_t> out(kWidth, kRows, 1);
  LevelDiffusion diffusion(levels(bits), kWidth, {.settled = false});
  for (auto _ : state) {
    diffusion.rows(in.view(), out.view());
    benchmark::DoNotOptimize(out.view().data);
  }
  count_pixels(state);
}
BENCHMARK_CAPTURE(rows_together, bits1, 1);
BENCHMARK_CAPTURE(rows_together, bits2, 2);
BENCHMARK_CAPTURE(rows_together, bits8, 8);
BENCHMARK_CAPTURE(rows_together, bits16, 16);

// Other kernels to 1 bit: one way, many rows at a time, or by their definition.
void kernel(benchmark::State& state, const DiffusionKernel& kernel, bool serpentine) {
  const Image in = noise(1);
  Raster<std::uint16_t> out(kWidth, kRows, 1);
  LevelDiffusion diffusion(
      levels(1), kWidth,
      {.kernel = &kernel, .serpentine = serpentine, .jitter = kernel.jitter, .settled = false});
  for (auto _ : state) {
    diffusion.rows(in.view(), out.view());
    benchmark::DoNotOptimize(out.view().data);
  }
  count_pixels(state);
}
BENCHMARK_CAPTURE(kernel, jarvis_one_way, kJarvisJudiceNinke, false);
BENCHMARK_CAPTURE(kernel, jarvis_serpentine, kJarvisJudiceNinke, true);
BENCHMARK_CAPTURE(kernel, stevenson_arce_one_way, kStevensonArce, false);
BENCHMARK_CAPTURE(kernel, blue_diffusion_one_way, kBlueDiffusion, false);
BENCHMARK_CAPTURE(kernel, blue_diffusion_serpentine, kBlueDiffusion, true);
BENCHMARK_CAPTURE(kernel, ostromoukhov_serpentine, kOstromoukhov, true);

void definition(benchmark::State& state, int bits) {
  const Image in = noise(1);
  Raster<std::uint16_t> out(kWidth, kRows, 1);
  LevelDiffusion diffusion(levels(bits), kWidth, {.settled = false});
  for (auto _ : state) {
    for (int y = 0; y < kRows; ++y) {
      diffusion.row({in.view().row(y).data(), kWidth, 1}, {out.view().row(y).data(), kWidth, 1});
    }
    benchmark::DoNotOptimize(out.view().data);
  }
  count_pixels(state);
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

std::vector<Rgb> entries(int count) {
  std::vector<Rgb> all{{0, 0, 0}, {1, 1, 1}, {1, 0, 0},  {0, 1, 0},
                       {0, 0, 1}, {1, 1, 0}, {1, 0.5, 0}};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> light(0, 1);
  while (static_cast<int>(all.size()) < count) {
    const double r = light(random);
    const double g = light(random);
    all.push_back({r, g, light(random)});
  }
  all.resize(static_cast<std::size_t>(count));
  return all;
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
  count_pixels(state);
}
BENCHMARK_CAPTURE(to_palette, colors7, 7, 1);
BENCHMARK_CAPTURE(to_palette, colors16, 16, 1);
BENCHMARK_CAPTURE(to_palette, colors16_two_threads, 16, 2)->UseRealTime();
BENCHMARK_CAPTURE(to_palette, colors256, 256, 1);

#ifdef TRISTIM_ZIMG
// Encoded numbers to encoded numbers, with its error diffusion: no light.
void zimg_error_diffusion(benchmark::State& state, int bits) {
  zimg_image_format from;
  zimg_image_format_default(&from, ZIMG_API_VERSION);
  from.width = kWidth;
  from.height = kRows;
  from.pixel_type = ZIMG_PIXEL_FLOAT;
  from.color_family = ZIMG_COLOR_GREY;
  from.pixel_range = ZIMG_RANGE_FULL;
  zimg_image_format to = from;
  to.pixel_type = ZIMG_PIXEL_BYTE;
  to.depth = static_cast<unsigned>(bits);
  zimg_graph_builder_params options;
  zimg_graph_builder_params_default(&options, ZIMG_API_VERSION);
  options.dither_type = ZIMG_DITHER_ERROR_DIFFUSION;
  zimg_filter_graph* graph = zimg_filter_graph_build(&from, &to, &options);
  if (graph == nullptr) return state.SkipWithError("zimg refuses");
  std::size_t scratch_size = 0;
  zimg_filter_graph_get_tmp_size(graph, &scratch_size);
  const std::unique_ptr<void, decltype(&std::free)> scratch(
      std::aligned_alloc(64, (scratch_size + 63) / 64 * 64), &std::free);
  const std::unique_ptr<void, decltype(&std::free)> in(
      std::aligned_alloc(64, sizeof(float) * kWidth * kRows), &std::free);
  const std::unique_ptr<void, decltype(&std::free)> out(std::aligned_alloc(64, kWidth * kRows),
                                                        &std::free);
  const Image picture = noise(1);
  for (int y = 0; y < kRows; ++y) {
    std::ranges::copy(picture.view().row(y), static_cast<float*>(in.get()) + y * kWidth);
  }
  zimg_image_buffer_const source{ZIMG_API_VERSION, {}};
  source.plane[0] = {in.get(), static_cast<std::ptrdiff_t>(sizeof(float) * kWidth),
                     ZIMG_BUFFER_MAX};
  zimg_image_buffer target{ZIMG_API_VERSION, {}};
  target.plane[0] = {out.get(), kWidth, ZIMG_BUFFER_MAX};
  for (auto _ : state) {
    zimg_filter_graph_process(graph, &source, &target, scratch.get(), nullptr, nullptr, nullptr,
                              nullptr);
    benchmark::DoNotOptimize(out.get());
  }
  zimg_filter_graph_free(graph);
  count_pixels(state);
}
BENCHMARK_CAPTURE(zimg_error_diffusion, bits1, 1);
BENCHMARK_CAPTURE(zimg_error_diffusion, bits8, 8);
#endif

}  // namespace
}  // namespace tristim
