// Conversions of float rows, beside what memory alone allows (a copy) and beside OpenColorIO's and
// Little CMS's of the same rows.
#include <OpenColorIO/OpenColorIO.h>
#include <benchmark/benchmark.h>
#include <lcms2.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "bench/pictures.h"
#include "lib/color/row_kernels.h"
#include "tristim/color/rows.h"

namespace tristim::bench {
namespace {

constexpr std::size_t kRowSamples = std::size_t{kWidth} * 3;
constexpr std::size_t kSamples = kRowSamples * kHeight;

// Runs convert(in, out) on every row.
template <typename Convert>
void for_rows(benchmark::State& state, Convert&& convert) {
  static const std::vector<float> in = noise(kSamples);
  std::vector<float> out(kSamples);
  for (auto _ : state) {
    for (std::size_t y = 0; y < kHeight; ++y) {
      convert(in.data() + y * kRowSamples, out.data() + y * kRowSamples);
    }
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  count_pixels(state, kWidth, kHeight);
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

// RGB to HSV and back, row by row.
void hsv_round_trip(benchmark::State& state) {
  const RowConversion to_hsv(parse_model("rgb", "from"), parse_model("hsv", "to"),
                             Adaptation::kBradford);
  const RowConversion to_rgb(parse_model("hsv", "from"), parse_model("rgb", "to"),
                             Adaptation::kBradford);
  for_rows(state, [&](const float* in, float* out) {
    to_hsv({in, kRowSamples}, 3, {out, kRowSamples}, 3);
    to_rgb({out, kRowSamples}, 3, {out, kRowSamples}, 3);
  });
}
BENCHMARK(hsv_round_trip);

// The loop that everybody writes first: the hexcone in floats, hue in sixths of the circle.
void plain_round_trip(const float* rgb, float* out) {
  const float high = std::max({rgb[0], rgb[1], rgb[2]});
  const float span = high - std::min({rgb[0], rgb[1], rgb[2]});
  const float saturation = high > 0 ? span / high : 0;
  float hue = 0;
  if (span > 0) {
    if (high == rgb[0]) {
      hue = (rgb[1] - rgb[2]) / span;
    } else if (high == rgb[1]) {
      hue = 2 + (rgb[2] - rgb[0]) / span;
    } else {
      hue = 4 + (rgb[0] - rgb[1]) / span;
    }
    if (hue < 0) hue += 6;
  }
  const int sextant = static_cast<int>(hue);
  const float part = hue - static_cast<float>(sextant);
  const float low = high * (1 - saturation);
  const float falling = high * (1 - saturation * part);
  const float rising = high * (1 - saturation * (1 - part));
  const float colors[][3] = {{high, rising, low},  {falling, high, low}, {low, high, rising},
                             {low, falling, high}, {rising, low, high},  {high, low, falling}};
  std::copy_n(colors[sextant % 6], 3, out);
}

void plain_hsv_round_trip(benchmark::State& state) {
  for_rows(state, [](const float* in, float* out) {
    for (std::size_t i = 0; i < kRowSamples; i += 3) plain_round_trip(in + i, out + i);
  });
}
BENCHMARK(plain_hsv_round_trip);

namespace ocio = OCIO_NAMESPACE;

using ConstProcessor = ocio::ConstCPUProcessorRcPtr;

ConstProcessor ocio_processor(const ocio::ConstTransformRcPtr& transform) {
  return ocio::Config::CreateRaw()->getProcessor(transform)->getDefaultCPUProcessor();
}

void ocio_row(const ConstProcessor& processor, const float* in, float* out) {
  const ocio::PackedImageDesc from(const_cast<float*>(in), kWidth, 1, 3);
  ocio::PackedImageDesc to(out, kWidth, 1, 3);
  processor->apply(from, to);
}

void ocio_rows(benchmark::State& state, const ocio::ConstTransformRcPtr& transform) {
  const ConstProcessor processor = ocio_processor(transform);
  for_rows(state, [&](const float* in, float* out) { ocio_row(processor, in, out); });
}

ocio::ConstTransformRcPtr fixed(ocio::FixedFunctionStyle style, bool inverse) {
  const auto transform = ocio::FixedFunctionTransform::Create(style);
  transform->setDirection(inverse ? ocio::TRANSFORM_DIR_INVERSE : ocio::TRANSFORM_DIR_FORWARD);
  return transform;
}

// Two processors: one that held both would leave both out.
void ocio_hsv_round_trip(benchmark::State& state) {
  const ConstProcessor to_hsv = ocio_processor(fixed(ocio::FIXED_FUNCTION_RGB_TO_HSV, false));
  const ConstProcessor to_rgb = ocio_processor(fixed(ocio::FIXED_FUNCTION_RGB_TO_HSV, true));
  for_rows(state, [&](const float* in, float* out) {
    ocio_row(to_hsv, in, out);
    ocio_row(to_rgb, out, out);
  });
}
BENCHMARK(ocio_hsv_round_trip);

void ocio_fixed(benchmark::State& state, ocio::FixedFunctionStyle style, bool inverse) {
  ocio_rows(state, fixed(style, inverse));
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
}  // namespace tristim::bench
