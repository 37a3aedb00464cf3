// What ordered dither costs: rows of light to codes, beside zimg's library (which dithers encoded
// numbers), in every instruction set; and making masks. Figures are for 3840x2160, one channel.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "tristim/color/transfer.h"
#include "tristim/dither/matrices.h"
#include "tristim/dither/ordered.h"
#ifdef TRISTIM_ZIMG
#include <zimg.h>
#endif

namespace tristim {
namespace {

constexpr int kWidth = 3840;
constexpr int kHeight = 2160;
constexpr int kBand = 32;  // rows: what a pipeline works on at a time stays in cache

std::vector<float> noise() {
  std::vector<float> light(static_cast<std::size_t>(kWidth) * kBand);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> any(0, 1);
  for (float& v : light) v = any(random);
  return light;
}

MixLevels levels(int count, bool srgb) {
  MixLevels mix;
  for (int i = 0; i < count; ++i) {
    const double code = i / (count - 1.0);
    mix.light.push_back(static_cast<float>(srgb ? srgb_decode(code) : code));
    mix.code.push_back(static_cast<std::uint16_t>(i));
  }
  return mix;
}

// A picture's worth of rows, the same band again and again.
void ordered(benchmark::State& state, const char* set, int count, bool srgb, const char* matrix) {
  setenv("TRISTIM_SIMD", set, 1);
  const OrderedDither dither(levels(count, srgb), make_matrix(*find_matrix_recipe(matrix)));
  const std::vector<float> in = noise();
  std::vector<std::uint16_t> out(in.size());
  for (auto _ : state) {
    for (int y = 0; y < kHeight; ++y) {
      const std::ptrdiff_t start = std::ptrdiff_t{y % kBand} * kWidth;
      dither.row({in.data() + start, kWidth, 1}, y, {out.data() + start, kWidth, 1});
    }
    benchmark::DoNotOptimize(out.data());
  }
  state.SetItemsProcessed(state.iterations() * kWidth * kHeight);
  unsetenv("TRISTIM_SIMD");
}

void blue_noise(benchmark::State& state) {
  std::uint64_t seed = 1;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        blue_noise_matrix({.size = static_cast<int>(state.range(0)), .seed = seed++}));
  }
}
BENCHMARK(blue_noise)->Arg(128)->Arg(256)->Arg(512)->Unit(benchmark::kMillisecond);

void blue_noise_frame(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        blue_noise_matrix({.size = static_cast<int>(state.range(0)), .frame = 1}));
  }
}
BENCHMARK(blue_noise_frame)->Arg(64)->Arg(128)->Unit(benchmark::kMillisecond);

#ifdef TRISTIM_ZIMG
// A whole picture through zimg's ordered dither, encoded numbers to 1 or 8 bits.
void zimg_ordered(benchmark::State& state) {
  zimg_image_format from;
  zimg_image_format to;
  zimg_image_format_default(&from, ZIMG_API_VERSION);
  from.width = kWidth;
  from.height = kHeight;
  from.pixel_type = ZIMG_PIXEL_FLOAT;
  from.depth = 32;
  from.pixel_range = ZIMG_RANGE_FULL;
  to = from;
  to.pixel_type = ZIMG_PIXEL_BYTE;
  to.depth = static_cast<unsigned>(state.range(0));
  zimg_graph_builder_params params;
  zimg_graph_builder_params_default(&params, ZIMG_API_VERSION);
  params.dither_type = ZIMG_DITHER_ORDERED;
  zimg_filter_graph* graph = zimg_filter_graph_build(&from, &to, &params);
  if (graph == nullptr) return state.SkipWithError("zimg refuses");
  const std::size_t pixels = static_cast<std::size_t>(kWidth) * kHeight;
  auto* in = static_cast<float*>(std::aligned_alloc(64, pixels * sizeof(float)));
  auto* out = static_cast<std::uint8_t*>(std::aligned_alloc(64, pixels));
  const std::vector<float> band = noise();
  for (std::size_t i = 0; i < pixels; ++i) in[i] = band[i % band.size()];
  std::size_t scratch_size = 0;
  zimg_filter_graph_get_tmp_size(graph, &scratch_size);
  void* scratch = std::aligned_alloc(64, (scratch_size + 63) / 64 * 64);
  zimg_image_buffer_const source{ZIMG_API_VERSION};
  source.plane[0] = {in, kWidth * sizeof(float), ZIMG_BUFFER_MAX};
  zimg_image_buffer target{ZIMG_API_VERSION};
  target.plane[0] = {out, kWidth, ZIMG_BUFFER_MAX};
  for (auto _ : state) {
    zimg_filter_graph_process(graph, &source, &target, scratch, nullptr, nullptr, nullptr, nullptr);
    benchmark::DoNotOptimize(out);
  }
  std::free(scratch);
  std::free(out);
  std::free(in);
  zimg_filter_graph_free(graph);
  state.SetItemsProcessed(state.iterations() * kWidth * kHeight);
}
BENCHMARK(zimg_ordered)->Arg(1)->Arg(8)->Unit(benchmark::kMillisecond);
#endif

const bool registered = [] {
  struct Case {
    const char* name;
    int levels;
    bool srgb;
    const char* matrix;
  };
  constexpr Case kCases[] = {{"1 bit", 2, false, "blue-noise"},
                             {"2 bits", 4, true, "blue-noise"},
                             {"8 bits, even in light", 256, false, "blue-noise"},
                             {"8 bits, sRGB", 256, true, "blue-noise"},
                             {"8 bits, sRGB, d3", 256, true, "d3"}};
  for (const char* set : {"best", "avx2", "sse4", "scalar"}) {
    for (const Case& c : kCases) {
      benchmark::RegisterBenchmark(
          (std::string("ordered, ") + c.name + ", " + set).c_str(),
          [=](benchmark::State& state) { ordered(state, set, c.levels, c.srgb, c.matrix); })
          ->Unit(benchmark::kMillisecond);
    }
  }
  return true;
}();

}  // namespace
}  // namespace tristim
