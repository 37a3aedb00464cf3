#include "tristim/dither/ordered.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "lib/dither/ordered_kernels.h"
#include "tristim/color/transfer.h"
#include "tristim/dither/matrices.h"

namespace tristim {
namespace {

using Codes = std::vector<std::uint16_t>;

MixLevels srgb_levels(int count) {
  MixLevels levels;
  for (int i = 0; i < count; ++i) {
    levels.light.push_back(static_cast<float>(srgb_decode(i / (count - 1.0))));
    levels.code.push_back(static_cast<std::uint16_t>(i));
  }
  return levels;
}

MixLevels linear_levels(int count, int code_step = 1) {
  MixLevels levels;
  for (int i = 0; i < count; ++i) {
    levels.light.push_back(static_cast<float>(i / (count - 1.0)));
    levels.code.push_back(static_cast<std::uint16_t>(i * code_step));
  }
  return levels;
}

// Noise, the levels themselves and their neighbours, and what is no light.
std::vector<float> hard_row(const MixLevels& levels, std::size_t size) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  std::vector<float> row{std::nanf(""), kInfinity, -kInfinity, -0.0F, 1e-42F, -1e-42F, 3e38F, -1};
  for (const float light : levels.light) {
    row.insert(row.end(), {light, std::nextafter(light, -1.0F), std::nextafter(light, 2.0F)});
  }
  std::mt19937 random(1);
  std::uniform_real_distribution<float> light(-0.1F, 1.1F);
  while (row.size() < size) row.push_back(light(random));
  row.resize(size);
  return row;
}

const std::pair<const char*, MixLevels> kScales[] = {
    {"two", linear_levels(2)},
    {"linear 256", linear_levels(256)},
    {"linear, codes apart", linear_levels(16, 17)},
    {"srgb 256", srgb_levels(256)},
    {"srgb 4", srgb_levels(4)},
    {"srgb 16", srgb_levels(16)},
    {"srgb 1024", srgb_levels(1024)},
    {"srgb 65536", srgb_levels(65536)},
    {"uneven", {{0, 0.1F, 0.15F, 0.7F, 1}, {9, 1, 4, 3, 7}}},
    {"narrow", {{0.25F, 0.5F}, {3, 4}}},
    {"one", {{0.3F}, {4}}}};

TEST(OrderedKernels, AllInstructionSetsGiveTheSameCodes) {
  for (const auto& [name, levels] : kScales) {
    for (const char* recipe : {"d3", "bayer8", "blue-noise100", "blue-noise128"}) {
      SCOPED_TRACE(std::string(name) + " " + recipe);
      const ThresholdMatrix matrix = make_matrix(*find_matrix_recipe(recipe));
      const detail::OrderedLevels scale(levels, matrix.ranks);
      std::vector<float> least;
      const std::size_t period = static_cast<std::size_t>(matrix.width) * 64;
      for (std::size_t i = 0; i < period + detail::kMostLanes; ++i) {
        least.push_back(matrix.row(1)[i % static_cast<std::size_t>(matrix.width)] + 0.5F);
      }
      const detail::OrderedRow row{&scale, least.data(), period, 5};
      for (const std::size_t size : {1, 7, 61, 4003}) {
        const std::vector<float> in = hard_row(levels, size);
        std::vector<float> strength(size);
        for (std::size_t i = 0; i < size; ++i) strength[i] = static_cast<float>(i % 11) / 10;
        for (const float* part : std::initializer_list<const float*>{nullptr, strength.data()}) {
          Codes expected(size);
          detail::scalar_ordered_kernels().row(row, in.data(), part, size, expected.data());
          for (const detail::OrderedKernels& kernels : detail::simd_ordered_kernels()) {
            Codes codes(size);
            kernels.row(row, in.data(), part, size, codes.data());
            ASSERT_EQ(codes, expected) << kernels.name;
          }
        }
      }
    }
  }
}

// The rule as it is written, in double: S = floor(f N + 1/2), the upper level where S > rank.
TEST(OrderedDither, IsTheRule) {
  for (const auto& [name, levels] : kScales) {
    if (levels.light.size() > 1024) continue;  // half a rank is below the last bit of a float
    for (const char* recipe : {"d3", "bayer16"}) {
      SCOPED_TRACE(std::string(name) + " " + recipe);
      const ThresholdMatrix matrix = make_matrix(*find_matrix_recipe(recipe));
      const OrderedDither dither(levels, matrix);
      std::mt19937 random(2);
      std::uniform_real_distribution<float> any(-0.1F, 1.1F);
      std::vector<float> in(2000);
      for (float& light : in) light = any(random);
      Codes codes(in.size());
      dither.row({in.data(), 2000, 1}, 1, {codes.data(), 2000, 1});
      for (std::size_t x = 0; x < in.size(); ++x) {
        std::size_t lower = 0;
        while (lower + 1 < levels.light.size() && in[x] >= levels.light[lower + 1]) ++lower;
        double steps = 0;
        if (lower + 1 < levels.light.size()) {
          const double step = double{levels.light[lower + 1]} - levels.light[lower];
          steps = (double{in[x]} - levels.light[lower]) / step * matrix.ranks;
        }
        const double tie = steps + 0.5 - std::floor(steps + 0.5);
        if (std::min(tie, 1 - tie) < 0.02) continue;  // floats may fall to either side
        const int rank = matrix.row(1)[x % static_cast<std::size_t>(matrix.width)];
        const bool upper = std::floor(steps + 0.5) > rank;
        ASSERT_EQ(codes[x], levels.code[lower + (upper ? 1 : 0)]) << in[x];
      }
    }
  }
}

TEST(OrderedDither, KeepsTheLevelsThemselvesFlat) {
  for (const auto& [name, levels] : kScales) {
    if (levels.light.size() > 1024) continue;
    const ThresholdMatrix matrix = make_matrix(*find_matrix_recipe("blue-noise128"));
    const OrderedDither dither(levels, matrix);
    for (std::size_t i = 0; i < levels.light.size(); ++i) {
      const std::vector<float> in(128, levels.light[i]);
      for (int y = 0; y < 128; y += 9) {
        Codes codes(128);
        dither.row({in.data(), 128, 1}, y, {codes.data(), 128, 1});
        ASSERT_EQ(codes, Codes(128, levels.code[i])) << name << " level " << i;
      }
    }
  }
}

TEST(OrderedDither, StrengthZeroIsTheNearestLevel) {
  const MixLevels levels{{0, 0.4F, 1}, {0, 1, 2}};
  const OrderedDither dither(levels, make_matrix(*find_matrix_recipe("bayer8")));
  const std::vector<float> in{0.1F, 0.19F, 0.21F, 0.5F, 0.69F, 0.71F};
  const std::vector<float> none(in.size(), 0);
  Codes codes(in.size());
  dither.row({in.data(), 6, 1}, 3, {codes.data(), 6, 1}, none);
  EXPECT_EQ(codes, (Codes{0, 0, 1, 1, 1, 2}));
}

// 17 patches of sRGB k/16 on 1-bit and 2-bit devices: |dL*| for every mask of 64 x 64 or more.
TEST(OrderedDither, KeepsTheToneOfPatches) {
  const auto lightness = [](double y) {
    return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389 / 27;
  };
  for (const char* recipe : {"bayer64", "bayer128", "bayer256", "magic64", "spiral64",
                             "clustered64", "blue-noise64", "blue-noise128", "blue-noise200"}) {
    const ThresholdMatrix matrix = make_matrix(*find_matrix_recipe(recipe));
    for (const MixLevels& levels : {linear_levels(2), srgb_levels(4), linear_levels(4)}) {
      const OrderedDither dither(levels, matrix);
      for (int patch = 0; patch <= 16; ++patch) {
        const double light = srgb_decode(patch / 16.0);
        const std::vector<float> in(static_cast<std::size_t>(matrix.width),
                                    static_cast<float>(light));
        double sum = 0;
        for (int y = 0; y < matrix.height; ++y) {
          Codes codes(in.size());
          dither.row({in.data(), matrix.width, 1}, y, {codes.data(), matrix.width, 1});
          for (const std::uint16_t code : codes) sum += levels.light[code];
        }
        const double mean = sum / static_cast<double>(matrix.rank.size());
        // Half a rank of 4096 is .11 at black's slope of 903.
        EXPECT_NEAR(lightness(mean), lightness(light), 0.12) << recipe << " " << patch;
      }
    }
  }
}

TEST(OrderedDither, TakesInterleavedChannelsAndPartsOfRows) {
  const MixLevels levels = srgb_levels(256);
  for (const char* recipe : {"d3", "bayer8", "blue-noise128"}) {
    const OrderedDither dither(levels, make_matrix(*find_matrix_recipe(recipe)));
    const std::vector<float> in = hard_row(levels, 2000);
    Codes whole(in.size());
    dither.row({in.data(), 2000, 1}, 77, {whole.data(), 2000, 1});
    for (const int step : {1, 3}) {
      for (const int first : {0, 1, 511, 1990}) {
        const int count = (2000 - first) / step;
        Codes part(static_cast<std::size_t>(count));
        std::vector<float> apart(static_cast<std::size_t>(count * step));
        for (int x = 0; x < count; ++x)
          apart[static_cast<std::size_t>(x * step)] = in[static_cast<std::size_t>(first + x)];
        dither.row({apart.data(), count, step}, 77, {part.data(), count, 1}, {}, first);
        ASSERT_TRUE(std::equal(part.begin(), part.end(), whole.begin() + first)) << recipe;
      }
    }
  }
}

}  // namespace
}  // namespace tristim
