// A cube of 33 points applied to a picture of 3840x2160 floats, beside what memory alone allows (a
// copy) and beside OpenColorIO's processor with the same cube, at one thread and at two.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <cstring>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "lib/lut/cube_kernels.h"
#include "tristim/lut/rows.h"

#ifdef TRISTIM_PEERS
#include <OpenColorIO/OpenColorIO.h>
#endif

namespace tristim {
namespace {

constexpr int kWidth = 3840;
constexpr int kHeight = 2160;
constexpr int kSize = 33;
constexpr std::size_t kRow = std::size_t{kWidth} * 3;

float random_float(std::mt19937& random) { return static_cast<float>(random() >> 8) * 0x1p-24F; }

// Slow changes with some noise, as photographs have; and noise alone, which no cache foresees.
std::vector<float> make_picture(bool noise) {
  std::vector<float> picture(kRow * kHeight);
  std::mt19937 random(1);
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const auto x = static_cast<float>(i % kRow / 3) / kWidth;
    const auto y = static_cast<float>(i / kRow) / kHeight;
    const float slow = i % 3 == 0 ? x : i % 3 == 1 ? y : (x + y) / 2;
    picture[i] = noise ? random_float(random) : .98F * slow + .02F * random_float(random);
  }
  return picture;
}

const std::vector<float>& picture_of(bool noise) {
  static const std::vector<float> pictures[] = {make_picture(false), make_picture(true)};
  return pictures[noise ? 1 : 0];
}

const Lut3D& cube() {
  static const Lut3D made = [] {
    Lut3D lut{{}, kSize, std::vector<float>(cube_samples(kSize))};
    std::mt19937 random(2);
    for (float& x : lut.rgb) x = random_float(random);
    return lut;
  }();
  return made;
}

// Runs rows(in, out, first, count) on the rows of the picture, shared out among `threads`.
template <typename Rows>
void over_picture(benchmark::State& state, bool noise, int threads, Rows&& rows) {
  const std::vector<float>& in = picture_of(noise);
  static std::vector<float> out(in.size());
  const auto part = [&](int i) {
    const int first = kHeight * i / threads;
    rows(in.data(), out.data(), first, kHeight * (i + 1) / threads - first);
  };
  for (auto _ : state) {
    std::vector<std::thread> others;
    for (int i = 1; i < threads; ++i) others.emplace_back(part, i);
    part(0);
    for (std::thread& other : others) other.join();
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * kWidth * kHeight);
}

void copy(benchmark::State& state, bool noise, int threads) {
  over_picture(state, noise, threads, [](const float* in, float* out, int first, int count) {
    const std::size_t begin = kRow * static_cast<std::size_t>(first);
    std::memcpy(out + begin, in + begin, kRow * static_cast<std::size_t>(count) * sizeof(float));
  });
}

void tristim_cube(benchmark::State& state, bool noise, int threads, const std::string& set,
                  const LutInterpolation& interpolation) {
  setenv("TRISTIM_SIMD", set.c_str(), 1);
  const LutRows lut({"", {cube()}}, interpolation);
  unsetenv("TRISTIM_SIMD");
  over_picture(state, noise, threads, [&](const float* in, float* out, int first, int count) {
    for (int y = first; y < first + count; ++y) {
      const std::size_t begin = kRow * static_cast<std::size_t>(y);
      lut({in + begin, kRow}, {out + begin, kRow});
    }
  });
}

#ifdef TRISTIM_PEERS
namespace ocio = OCIO_NAMESPACE;

void ocio_cube(benchmark::State& state, bool noise, int threads, bool is_trilinear) {
  const auto lut = ocio::Lut3DTransform::Create(kSize);
  lut->setInterpolation(is_trilinear ? ocio::INTERP_LINEAR : ocio::INTERP_TETRAHEDRAL);
  for (unsigned long i = 0; i < kSize * kSize * kSize; ++i) {  // NOLINT(google-runtime-int)
    const float* p = &cube().rgb[3 * i];
    lut->setValue(i % kSize, i / kSize % kSize, i / (kSize * kSize), p[0], p[1], p[2]);
  }
  const auto processor = ocio::Config::CreateRaw()->getProcessor(lut)->getDefaultCPUProcessor();
  over_picture(state, noise, threads, [&](const float* in, float* out, int first, int count) {
    const std::size_t begin = kRow * static_cast<std::size_t>(first);
    const ocio::PackedImageDesc from(const_cast<float*>(in) + begin, kWidth, count, 3);
    ocio::PackedImageDesc to(out + begin, kWidth, count, 3);
    processor->apply(from, to);
  });
}
#endif

template <typename Run>
void add(const std::string& name, Run run) {
  for (const bool noise : {false, true}) {
    for (const int threads : {1, 2}) {
      const std::string full = name + (noise ? "/noise/" : "/smooth/") + std::to_string(threads);
      benchmark::RegisterBenchmark(full.c_str(),
                                   [=](benchmark::State& state) { run(state, noise, threads); })
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
  for (const LutInterpolation& interpolation : kLutInterpolations) {
    const std::string name(interpolation.name);
    for (const std::string& set : sets) {
      add(set + "/" + name,
          [set, &interpolation](benchmark::State& state, bool noise, int threads) {
            tristim_cube(state, noise, threads, set, interpolation);
          });
    }
#ifdef TRISTIM_PEERS
    const bool is_trilinear = interpolation.evaluate == trilinear;
    add("ocio/" + name, [is_trilinear](benchmark::State& state, bool noise, int threads) {
      ocio_cube(state, noise, threads, is_trilinear);
    });
#endif
  }
  return true;
}();

}  // namespace
}  // namespace tristim
