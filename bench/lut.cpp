// A cube of 33 points applied to a picture of 3840x2160 floats, beside what memory alone allows (a
// copy) and beside OpenColorIO's and Little CMS's processors with the same cube, at one thread and
// at two.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "bench/peers/peers.h"
#include "bench/pictures.h"
#include "lib/lut/cube_kernels.h"
#include "tristim/lut/rows.h"

namespace tristim::bench {
namespace {

constexpr int kSize = 33;
constexpr std::size_t kRow = std::size_t{kWidth} * 3;

// Slow changes with some noise, as photographs have; and noise alone, which no cache foresees.
std::vector<float> make_picture(bool only_noise) {
  std::vector<float> picture = noise(kRow * kHeight);
  for (std::size_t i = 0; i < picture.size() && !only_noise; ++i) {
    const auto x = static_cast<float>(i % kRow / 3) / kWidth;
    const auto y = static_cast<float>(i / kRow) / kHeight;
    const float slow = i % 3 == 0 ? x : i % 3 == 1 ? y : (x + y) / 2;
    picture[i] = .98F * slow + .02F * picture[i];
  }
  return picture;
}

const std::vector<float>& picture_of(bool only_noise) {
  static const std::vector<float> pictures[] = {make_picture(false), make_picture(true)};
  return pictures[only_noise ? 1 : 0];
}

const Lut3D& cube() {
  static const Lut3D made{{}, kSize, noise(cube_samples(kSize))};
  return made;
}

// Runs rows(in, out, first, count) on the rows of the picture, shared out among `threads`.
template <typename Rows>
void over_picture(benchmark::State& state, bool only_noise, int threads, Rows&& rows) {
  const std::vector<float>& in = picture_of(only_noise);
  static std::vector<float> out(in.size());
  for (auto _ : state) {
    share_rows(kHeight, threads,
               [&](int first, int count) { rows(in.data(), out.data(), first, count); });
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  count_pixels(state, kWidth, kHeight);
}

void copy(benchmark::State& state, bool only_noise, int threads) {
  over_picture(state, only_noise, threads, [](const float* in, float* out, int first, int count) {
    const std::size_t begin = kRow * static_cast<std::size_t>(first);
    std::memcpy(out + begin, in + begin, kRow * static_cast<std::size_t>(count) * sizeof(float));
  });
}

void tristim_cube(benchmark::State& state, bool only_noise, int threads, const std::string& set,
                  const LutInterpolation& interpolation) {
  setenv("TRISTIM_SIMD", set.c_str(), 1);
  const LutRows lut({"", {cube()}}, interpolation);
  unsetenv("TRISTIM_SIMD");
  over_picture(state, only_noise, threads, [&](const float* in, float* out, int first, int count) {
    for (int y = first; y < first + count; ++y) {
      const std::size_t begin = kRow * static_cast<std::size_t>(y);
      lut({in + begin, kRow}, {out + begin, kRow});
    }
  });
}

void peer_cube(benchmark::State& state, bool only_noise, int threads, const FloatPixels& peer) {
  over_picture(state, only_noise, threads, [&](const float* in, float* out, int first, int count) {
    const std::size_t begin = kRow * static_cast<std::size_t>(first);
    peer(in + begin, out + begin, kWidth * count);
  });
}

template <typename Run>
void add(const std::string& name, Run run) {
  for (const bool only_noise : {false, true}) {
    for (const int threads : {1, 2}) {
      const std::string full =
          name + (only_noise ? "/noise/" : "/smooth/") + std::to_string(threads);
      benchmark::RegisterBenchmark(
          full.c_str(), [=](benchmark::State& state) { run(state, only_noise, threads); })
          ->UseRealTime()
          ->MeasureProcessCPUTime()
          ->Unit(benchmark::kMillisecond);
    }
  }
}

[[maybe_unused]] const bool kRegistered = [] {
  add("copy", copy);
  std::vector<std::string> sets;
  for (const detail::CubeKernels& kernels : detail::simd_cube_kernels()) {
    sets.emplace_back(kernels.name);
  }
  sets.emplace_back("scalar");
  sets.emplace_back("best");
  for (const LutInterpolation& interpolation : kLutInterpolations) {
    const std::string name(interpolation.name);
    for (const std::string& set : sets) {
      add(set + "/" + name,
          [set, &interpolation](benchmark::State& state, bool only_noise, int threads) {
            tristim_cube(state, only_noise, threads, set, interpolation);
          });
    }
    const bool is_trilinear = interpolation.evaluate == trilinear;
    add("OpenColorIO/" + name,
        [is_trilinear](benchmark::State& state, bool only_noise, int threads) {
          peer_cube(state, only_noise, threads, ocio_cube(cube(), is_trilinear));
        });
  }
  add("Little CMS/tetrahedral", [](benchmark::State& state, bool only_noise, int threads) {
    peer_cube(state, only_noise, threads, lcms_cube(cube()));
  });
  return true;
}();

}  // namespace
}  // namespace tristim::bench
