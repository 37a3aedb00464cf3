#include "lib/dither/level_rows.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <string>

#include "tristim/color/transfer.h"
#include "tristim/dither/levels.h"

namespace tristim {
namespace {

// `count` levels of the sRGB curve, codes in steps.
MixLevels levels(int count) {
  MixLevels made;
  for (int i = 0; i < count; ++i) {
    made.light.push_back(static_cast<float>(srgb_decode(i / (count - 1.0))));
    made.code.push_back(static_cast<std::uint16_t>(count > 20000 ? i : 3 * i));
  }
  return made;
}

Image noise(int width, int height) {
  Image picture(width, height, 1);
  std::mt19937 random(static_cast<unsigned>(width * height));
  std::uniform_real_distribution<float> light(-0.2F, 1.2F);
  for (int y = 0; y < height; ++y) {
    for (float& v : picture.view().row(y)) v = light(random);
  }
  return picture;
}

std::vector<std::uint16_t> samples(const Raster<std::uint16_t>& codes) {
  std::vector<std::uint16_t> all;
  for (int y = 0; y < codes.view().height; ++y) {
    all.insert(all.end(), codes.view().row(y).begin(), codes.view().row(y).end());
  }
  return all;
}

std::vector<std::uint16_t> by_definition(const MixLevels& levels, const DiffusionOptions& options,
                                         const Image& in) {
  Raster<std::uint16_t> out(in.view().width, in.view().height, 1);
  LevelDiffusion diffusion(levels, in.view().width, options);
  for (int y = 0; y < in.view().height; ++y) {
    diffusion.row({in.view().row(y).data(), in.view().width, 1},
                  {out.view().row(y).data(), in.view().width, 1});
  }
  return samples(out);
}

// With the picture in bands of `band` rows.
std::vector<std::uint16_t> by_rows(const MixLevels& levels, const DiffusionOptions& options,
                                   const Image& in, int band, int threads = 1) {
  Raster<std::uint16_t> out(in.view().width, in.view().height, 1);
  LevelDiffusion diffusion(levels, in.view().width, options);
  for (int y = 0; y < in.view().height; y += band) {
    const int count = std::min(band, in.view().height - y);
    diffusion.rows(in.view().rows(y, count), out.view().rows(y, count), threads);
  }
  return samples(out);
}

class EverySetOfLevelRows : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { setenv("TRISTIM_SIMD", GetParam().c_str(), 1); }
  void TearDown() override { unsetenv("TRISTIM_SIMD"); }
};

std::vector<std::string> sets() {
  std::vector<std::string> names;
  for (const auto& rows : detail::all_level_rows()) names.emplace_back(rows.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(LevelRows, EverySetOfLevelRows, testing::ValuesIn(sets()),
                         [](const auto& set) { return set.param; });

TEST_P(EverySetOfLevelRows, AreTheDefinitionBitForBit) {
  for (const int count : {2, 3, 8, 9, 256, 1024}) {
    const MixLevels made = levels(count);
    for (const auto& [width, height] :
         {std::pair{1, 70}, {2, 3}, {3, 65}, {31, 40}, {127, 130}, {300, 17}, {1001, 66}}) {
      const Image in = noise(width, height);
      const auto expected = by_definition(made, {}, in);
      for (const int band : {1, 7, 64}) {
        EXPECT_EQ(by_rows(made, {}, in, band), expected)
            << count << " levels, " << width << " x " << height << ", bands of " << band;
      }
    }
  }
}

TEST_P(EverySetOfLevelRows, TakeEveryKernelAndJitter) {
  for (const int count : {1, 2, 5, 100}) {
    const MixLevels made = count == 1 ? MixLevels{{0.3F}, {7}} : levels(count);
    for (const DiffusionKernel& kernel : kDiffusionKernels) {
      for (const float jitter : {0.0F, 0.4F}) {
        const DiffusionOptions options{.kernel = &kernel, .jitter = jitter, .seed = 3};
        for (const auto& [width, height] : {std::pair{1, 9}, {5, 40}, {90, 150}}) {
          const Image in = noise(width, height);
          const auto expected = by_definition(made, options, in);
          for (const int band : {10, 100}) {
            EXPECT_EQ(by_rows(made, options, in, band), expected)
                << kernel.name << ", " << count << " levels, jitter " << jitter << ", " << width
                << " x " << height << ", bands of " << band;
          }
        }
      }
    }
  }
}

TEST_P(EverySetOfLevelRows, AreTheSameOnAnyNumberOfThreads) {
  for (const int width : {1, 40, 700}) {
    const Image in = noise(width, 300);
    for (const DiffusionKernel* kernel : {&kFloydSteinberg, &kBlueDiffusion}) {
      const DiffusionOptions options{.kernel = kernel, .jitter = kernel->jitter};
      const auto expected = by_definition(levels(2), options, in);
      for (const int threads : {2, 7}) {
        EXPECT_EQ(by_rows(levels(2), options, in, 290, threads), expected)
            << kernel->name << ", " << width << " wide, " << threads << " threads";
      }
    }
  }
}

// Weights that nobody published.
TEST_P(EverySetOfLevelRows, TakeAnyKernel) {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> weight(-4, 12);
  for (int i = 0; i < 40; ++i) {
    DiffusionKernel kernel{.name = "random", .divisor = 0, .closed = i % 3 == 0};
    for (std::size_t row = 0; row < 4; ++row) {
      for (std::size_t x = row == 0 ? 4 : 0; x < 7; ++x) {
        kernel.weight[row][x] = random() % 3 == 0 ? 0 : weight(random);
        kernel.divisor += std::abs(kernel.weight[row][x]);
      }
    }
    const MixLevels made = levels(2 + static_cast<int>(random() % 40));
    const DiffusionOptions options{.kernel = &kernel, .jitter = i % 2 == 0 ? 0.0F : 0.2F};
    const Image in = noise(1 + static_cast<int>(random() % 150), 70);
    EXPECT_EQ(by_rows(made, options, in, 1 + static_cast<int>(random() % 70)),
              by_definition(made, options, in))
        << i;
  }
}

// Codes and levels that no curve made.
TEST_P(EverySetOfLevelRows, TakeAnyLevels) {
  const MixLevels uneven{{0.1F, 0.11F, 0.3F, 0.31F, 0.7F}, {9, 2, 700, 1, 0xFFFF}};
  MixLevels many{{}, {}};
  std::mt19937 random(5);
  float light = 0.01F;
  for (int i = 0; i < 300; ++i) {
    many.light.push_back(light);
    many.code.push_back(static_cast<std::uint16_t>(random()));
    light += std::uniform_real_distribution<float>(0.001F, 0.005F)(random);
  }
  const Image in = noise(200, 80);
  for (const MixLevels& made : {uneven, many, levels(65536)}) {
    EXPECT_EQ(by_rows(made, {}, in, 80), by_definition(made, {}, in));
  }
}

TEST(LevelTable, TakesWhateverLevelsAreNotBelowBlack) {
  const auto table = [](const MixLevels& made) {
    std::vector<float> half_way;
    for (std::size_t i = 1; i < made.light.size(); ++i) {
      half_way.push_back((made.light[i - 1] + made.light[i]) / 2);
    }
    return detail::LevelTable(made.light, half_way, made.code);
  };
  EXPECT_TRUE(table(levels(2)).usable());
  EXPECT_TRUE(table(levels(256)).usable());
  EXPECT_TRUE(table(levels(65536)).usable());
  MixLevels below = levels(256);
  below.light[0] = -1;
  EXPECT_FALSE(table(below).usable());
}

TEST(LevelDiffusion, TakesRowsTogether) {
  const Image in = noise(150, 100);
  for (const int count : {2, 256, 16384}) {
    for (const bool serpentine : {false, true}) {
      const DiffusionOptions options{.serpentine = serpentine};
      EXPECT_EQ(by_rows(levels(count), options, in, 50), by_definition(levels(count), options, in))
          << count << " " << serpentine;
    }
  }
}

}  // namespace
}  // namespace tristim
