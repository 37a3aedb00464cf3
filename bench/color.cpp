// Conversions of float rows, beside what memory alone allows (a copy) and beside OpenColorIO's and
// Little CMS's of the same rows.
#include <benchmark/benchmark.h>

#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "lib/color/row_kernels.h"
#include "tristim/color/rows.h"

#ifdef TRISTIM_PEERS
#include <OpenColorIO/OpenColorIO.h>
#include <lcms2.h>
#endif

namespace tristim {
namespace {

constexpr int kWidth = 3840;
constexpr int kRows = 512;  // with the result 47 MB: no cache holds it
constexpr std::size_t kRowSamples = std::size_t{kWidth} * 3;
constexpr std::size_t kSamples = kRowSamples * kRows;

const std::vector<float>& noise() {
  static const std::vector<float> samples = [] {
    std::vector<float> all(kSamples);
    std::mt19937 random(1);
    std::uniform_real_distribution<float> light(0, 1);
    for (float& x : all) x = light(random);
    return all;
  }();
  return samples;
}

// Runs convert(in, out) on every row.
template <typename Convert>
void for_rows(benchmark::State& state, Convert&& convert) {
  const std::vector<float>& in = noise();
  std::vector<float> out(kSamples);
  for (auto _ : state) {
    for (std::size_t y = 0; y < kRows; ++y) {
      convert(in.data() + y * kRowSamples, out.data() + y * kRowSamples);
    }
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * kWidth * kRows);
}

// The floor.
void copy(benchmark::State& state) {
  for_rows(state,
           [](const float* in, float* out) { std::memcpy(out, in, kRowSamples * sizeof(float)); });
}
BENCHMARK(copy);

struct Conversion {
  const char* from;
  const char* to;
};

constexpr Conversion kConversions[] = {
    {"linear:srgb", "xyz"},
    {"linear:srgb", "linear:bt2020"},
    {"rgb", "yiq"},
    {"yiq", "rgb"},
    {"rgb", "hsv"},
    {"hsv", "rgb"},
    {"rgb", "hls"},
    {"hls", "rgb"},
    {"xyz", "lab"},
    {"linear:srgb", "lab"},
    {"lab", "xyz"},
    {"xyz", "luv"},
    {"luv", "xyz"},
    {"linear:srgb", "oklab"},
    {"oklab", "linear:srgb"},
    {"linear:srgb", "rgb:srgb"},
    {"rgb:srgb", "linear:srgb"},
    {"linear:srgb", "rgb:srgb/pq"},
    {"rgb:srgb/hlg", "linear:srgb"},
    {"rgb", "lab"},
    {"rgb", "lch"},
};

void tristim_rows(benchmark::State& state, const Conversion& conversion, const std::string& set) {
  setenv("TRISTIM_SIMD", set.c_str(), 1);
  const RowConversion rows(parse_model(conversion.from, "from"), parse_model(conversion.to, "to"),
                           Adaptation::kBradford);
  unsetenv("TRISTIM_SIMD");
  for_rows(state, [&](const float* in, float* out) {
    rows({in, kRowSamples}, 3, {out, kRowSamples}, 3);
  });
}

#ifdef TRISTIM_PEERS
namespace ocio = OCIO_NAMESPACE;

void ocio_rows(benchmark::State& state, const ocio::ConstTransformRcPtr& transform) {
  const auto config = ocio::Config::CreateRaw();
  const auto processor = config->getProcessor(transform)->getDefaultCPUProcessor();
  for_rows(state, [&](const float* in, float* out) {
    const ocio::PackedImageDesc from(const_cast<float*>(in), kWidth, 1, 3);
    ocio::PackedImageDesc to(out, kWidth, 1, 3);
    processor->apply(from, to);
  });
}

void ocio_fixed(benchmark::State& state, ocio::FixedFunctionStyle style, bool inverse) {
  const auto transform = ocio::FixedFunctionTransform::Create(style);
  transform->setDirection(inverse ? ocio::TRANSFORM_DIR_INVERSE : ocio::TRANSFORM_DIR_FORWARD);
  ocio_rows(state, transform);
}
BENCHMARK_CAPTURE(ocio_fixed, rgb_to_hsv, ocio::FIXED_FUNCTION_RGB_TO_HSV, false);
BENCHMARK_CAPTURE(ocio_fixed, hsv_to_rgb, ocio::FIXED_FUNCTION_RGB_TO_HSV, true);
BENCHMARK_CAPTURE(ocio_fixed, xyz_to_luv, ocio::FIXED_FUNCTION_XYZ_TO_LUV, false);
BENCHMARK_CAPTURE(ocio_fixed, luv_to_xyz, ocio::FIXED_FUNCTION_XYZ_TO_LUV, true);

void ocio_matrix(benchmark::State& state) {
  constexpr double kMatrix[] = {0.41, 0.36, 0.18, 0, 0.21, 0.72, 0.07, 0,
                                0.02, 0.12, 0.95, 0, 0,    0,    0,    1};
  const auto transform = ocio::MatrixTransform::Create();
  transform->setMatrix(kMatrix);
  ocio_rows(state, transform);
}
BENCHMARK(ocio_matrix);

void ocio_srgb_encode(benchmark::State& state) {
  const auto transform = ocio::ExponentWithLinearTransform::Create();
  transform->setGamma({2.4, 2.4, 2.4, 1});
  transform->setOffset({0.055, 0.055, 0.055, 0});
  transform->setDirection(ocio::TRANSFORM_DIR_INVERSE);
  ocio_rows(state, transform);
}
BENCHMARK(ocio_srgb_encode);

void lcms_xyz_to_lab(benchmark::State& state) {
  const cmsHPROFILE xyz = cmsCreateXYZProfile();
  const cmsHPROFILE lab = cmsCreateLab4Profile(nullptr);
  constexpr cmsUInt32Number kXyzFloats =
      FLOAT_SH(1) | COLORSPACE_SH(PT_XYZ) | CHANNELS_SH(3) | BYTES_SH(4);
  const cmsHTRANSFORM transform =
      cmsCreateTransform(xyz, kXyzFloats, lab, TYPE_Lab_FLT, INTENT_RELATIVE_COLORIMETRIC, 0);
  for_rows(state, [&](const float* in, float* out) { cmsDoTransform(transform, in, out, kWidth); });
  cmsDeleteTransform(transform);
  cmsCloseProfile(xyz);
  cmsCloseProfile(lab);
}
BENCHMARK(lcms_xyz_to_lab);
#endif

[[maybe_unused]] const bool kRegistered = [] {
  std::vector<std::string> sets;
  for (const detail::RowKernels& kernels : detail::simd_row_kernels()) {
    sets.emplace_back(kernels.name);
  }
  sets.emplace_back("scalar");
  for (const std::string& set : sets) {
    for (const Conversion& conversion : kConversions) {
      const std::string name = set + "/" + conversion.from + "_to_" + conversion.to;
      benchmark::RegisterBenchmark(name.c_str(), [&conversion, set](benchmark::State& state) {
        tristim_rows(state, conversion, set);
      });
    }
  }
  return true;
}();

}  // namespace
}  // namespace tristim
