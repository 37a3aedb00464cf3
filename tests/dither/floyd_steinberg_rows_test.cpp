#include "lib/dither/floyd_steinberg_rows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tristim/color/transfer.h"
#include "tristim/dither/levels.h"

namespace tristim {
namespace {

// `count` levels of the sRGB curve, codes in steps of 3.
MixLevels levels(int count) {
  MixLevels made;
  for (int i = 0; i < count; ++i) {
    made.light.push_back(static_cast<float>(srgb_decode(i / (count - 1.0))));
    made.code.push_back(static_cast<std::uint16_t>(3 * i));
  }
  return made;
}

detail::LevelTable table(const MixLevels& levels) {
  std::vector<float> half_way;
  for (std::size_t i = 1; i < levels.light.size(); ++i) {
    const auto middle =
        static_cast<float>((double{levels.light[i - 1]} + double{levels.light[i]}) / 2);
    half_way.push_back(std::nextafter(middle, std::numeric_limits<float>::infinity()));
  }
  return {levels.light, half_way, levels.code};
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

std::vector<std::uint16_t> by_definition(const MixLevels& levels, const Image& in) {
  Raster<std::uint16_t> out(in.view().width, in.view().height, 1);
  LevelDiffusion diffusion(levels, in.view().width, {});
  for (int y = 0; y < in.view().height; ++y) {
    diffusion.row({in.view().row(y).data(), in.view().width, 1},
                  {out.view().row(y).data(), in.view().width, 1});
  }
  return samples(out);
}

// Each set of vectors, with the picture in bands of `band` rows.
std::vector<std::uint16_t> by_rows(const detail::FloydSteinbergRows& rows, const MixLevels& levels,
                                   const Image& in, int band) {
  Raster<std::uint16_t> out(in.view().width, in.view().height, 1);
  std::vector<float> errors(static_cast<std::size_t>(in.view().width) + 2, 0);
  const detail::LevelTable look_up = table(levels);
  EXPECT_TRUE(look_up.usable());
  for (int y = 0; y < in.view().height; y += band) {
    const int count = std::min(band, in.view().height - y);
    rows.run(look_up, in.view().rows(y, count), out.view().rows(y, count), errors);
  }
  return samples(out);
}

TEST(FloydSteinbergRows, AreTheDefinitionBitForBit) {
  for (const int count : {2, 3, 8, 9, 256}) {
    const MixLevels made = levels(count);
    for (const auto& [width, height] :
         {std::pair{1, 70}, {2, 3}, {3, 65}, {31, 40}, {127, 130}, {300, 17}, {1001, 66}}) {
      const Image in = noise(width, height);
      const auto expected = by_definition(made, in);
      for (const detail::FloydSteinbergRows& rows : detail::all_floyd_steinberg_rows()) {
        for (const int band : {7, 64}) {
          EXPECT_EQ(by_rows(rows, made, in, band), expected)
              << rows.name << " " << count << " levels, " << width << " x " << height
              << ", bands of " << band;
        }
      }
    }
  }
}

// Codes and levels that no curve made.
TEST(FloydSteinbergRows, TakeAnyLevels) {
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
  for (const detail::FloydSteinbergRows& rows : detail::all_floyd_steinberg_rows()) {
    for (const MixLevels& made : {uneven, many}) {
      EXPECT_EQ(by_rows(rows, made, in, 80), by_definition(made, in)) << rows.name;
    }
  }
}

// Bins would hold more than one of them, or be too many.
TEST(FloydSteinbergRows, LeaveTensOfThousandsOfLevelsToTheDefinition) {
  EXPECT_FALSE(table(levels(65536)).usable());
  EXPECT_TRUE(table(levels(2)).usable());
}

TEST(LevelDiffusion, TakesRowsTogether) {
  for (const int count : {2, 256, 65536}) {
    const MixLevels made = levels(std::min(count, 21845));  // codes below 65536
    const Image in = noise(150, 100);
    for (const bool serpentine : {false, true}) {
      Raster<std::uint16_t> expected(150, 100, 1);
      Raster<std::uint16_t> out(150, 100, 1);
      LevelDiffusion single(made, 150, {.serpentine = serpentine});
      for (int y = 0; y < 100; ++y) {
        single.row({in.view().row(y).data(), 150, 1}, {expected.view().row(y).data(), 150, 1});
      }
      LevelDiffusion together(made, 150, {.serpentine = serpentine});
      for (int y = 0; y < 100; y += 50) {
        together.rows(in.view().rows(y, 50), out.view().rows(y, 50));
      }
      EXPECT_EQ(samples(out), samples(expected)) << count << " " << serpentine;
    }
  }
}

}  // namespace
}  // namespace tristim
