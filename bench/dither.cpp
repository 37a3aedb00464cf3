// What ordered dither costs: rows of light to codes, beside zimg's library (which dithers encoded
// numbers), in every instruction set; to palettes; and making masks. Figures are for 3840x2160, one
// channel.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "bench/peers/peers.h"
#include "bench/pictures.h"
#include "tristim/dither/matrices.h"
#include "tristim/dither/ordered.h"
#include "tristim/dither/palette.h"

namespace tristim::bench {
namespace {

constexpr int kBand = 32;  // rows: what a pipeline works on at a time stays in cache
constexpr std::size_t kBandSamples = std::size_t{kWidth} * kBand;

// A picture's worth of rows, the same band again and again.
void ordered(benchmark::State& state, const char* set, int bits, bool srgb, const char* matrix) {
  setenv("TRISTIM_SIMD", set, 1);
  const OrderedDither dither(levels(bits, srgb), make_matrix(*find_matrix_recipe(matrix)));
  const std::vector<float> in = noise(kBandSamples);
  std::vector<std::uint16_t> out(in.size());
  for (auto _ : state) {
    for (int y = 0; y < kHeight; ++y) {
      const std::ptrdiff_t start = std::ptrdiff_t{y % kBand} * kWidth;
      dither.row({in.data() + start, kWidth, 1}, y, {out.data() + start, kWidth, 1});
    }
    benchmark::DoNotOptimize(out.data());
  }
  count_pixels(state, kWidth, kHeight);
  unsetenv("TRISTIM_SIMD");
}

// A whole picture, what the dither keeps from pixel to pixel kept from round to round.
void ordered_to_palette(benchmark::State& state) {
  static const Image in = photograph_light();
  const MixPalette palette(entries(static_cast<int>(state.range(0))), kMetrics[1], Mix::kLight);
  const PaletteOrdered dither(palette, make_matrix(*find_matrix_recipe("bayer8")));
  std::vector<std::uint16_t> indices(kWidth);
  for (auto _ : state) {
    for (int y = 0; y < kHeight; ++y) dither.row(y, in.view().row(y), indices);
    benchmark::DoNotOptimize(indices.data());
  }
  count_pixels(state, kWidth, kHeight);
}
BENCHMARK(ordered_to_palette)->Arg(7)->Arg(16)->Arg(256)->Unit(benchmark::kMillisecond);

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

// A whole picture through zimg's ordered dither, encoded numbers to 1 or 8 bits.
void zimg_ordered(benchmark::State& state) {
  const ToBytes dither =
      zimg_plane(kWidth, kHeight, static_cast<int>(state.range(0)), ZimgDither::kOrdered);
  const Samples<float> in(std::size_t{kWidth} * kHeight);
  const Samples<std::uint8_t> out(in.size());
  const std::vector<float> band = noise(kBandSamples);
  for (std::size_t i = 0; i < in.size(); ++i) in[i] = band[i % band.size()];
  for (auto _ : state) {
    dither(in.data(), out.data());
    benchmark::ClobberMemory();
  }
  count_pixels(state, kWidth, kHeight);
}
BENCHMARK(zimg_ordered)->Arg(1)->Arg(8)->Unit(benchmark::kMillisecond);

const bool registered = [] {
  struct Case {
    const char* name;
    int bits;
    bool srgb;
    const char* matrix;
  };
  constexpr Case kCases[] = {{"1 bit", 1, false, "blue-noise"},
                             {"2 bits", 2, true, "blue-noise"},
                             {"8 bits, even in light", 8, false, "blue-noise"},
                             {"8 bits, sRGB", 8, true, "blue-noise"},
                             {"8 bits, sRGB, d3", 8, true, "d3"}};
  for (const char* set : {"best", "avx2", "sse4", "scalar"}) {
    for (const Case& c : kCases) {
      benchmark::RegisterBenchmark(
          (std::string("ordered, ") + c.name + ", " + set).c_str(),
          [=](benchmark::State& state) { ordered(state, set, c.bits, c.srgb, c.matrix); })
          ->Unit(benchmark::kMillisecond);
    }
  }
  return true;
}();

}  // namespace
}  // namespace tristim::bench
