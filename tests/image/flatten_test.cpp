#include "tristim/image/flatten.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>
#include <vector>

#include "tristim/image/memory.h"

namespace tristim {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

Image row_of(const std::vector<float>& samples, int channels) {
  Image image(static_cast<int>(samples.size()) / channels, 1, channels);
  std::ranges::copy(samples, image.view().row(0).begin());
  return image;
}

std::vector<float> flattened(const std::vector<float>& samples, int channels, Rgb background,
                             OddValues* counts = nullptr) {
  const auto source =
      flatten(std::make_unique<ImageSource>(row_of(samples, channels)), background, counts);
  EXPECT_EQ(source->info().channels, 3);
  Image image(source->info().width, 1, 3);
  source->read(image.view());
  const auto row = image.view().row(0);
  return {row.begin(), row.end()};
}

TEST(Flatten, ReplacesAndCountsOddValues) {
  OddValues counts;
  const auto out = flattened({kNan, kInf, -kInf, 1, kNan, 2}, 3, {1, 1, 1}, &counts);
  EXPECT_EQ(out, (std::vector<float>{0, 65504, -65504, 1, 0, 2}));
  EXPECT_EQ(counts, (OddValues{.nan = 2, .infinite = 2}));
}

TEST(Flatten, KeepsLargeAndNegativeFiniteValues) {
  OddValues counts;
  const std::vector<float> samples{1e30F, -1e30F, -0.25F};
  EXPECT_EQ(flattened(samples, 3, {}, &counts), samples);
  EXPECT_EQ(counts, OddValues{});
}

TEST(Flatten, PutsPremultipliedAlphaOverTheBackground) {
  const auto out = flattened({0.25F, 0.5F, 0, 0.5F, 4, 0, 0, 0}, 4, {1, 0.5, 0.25});
  EXPECT_EQ(out, (std::vector<float>{0.75F, 0.75F, 0.125F, 5, 0.5F, 0.25F}));
}

TEST(Flatten, OpaquePixelsDoNotSeeTheBackground) {
  EXPECT_EQ(flattened({0.1F, 0.2F, 0.3F, 1}, 4, {9, 9, 9}), (std::vector<float>{0.1F, 0.2F, 0.3F}));
}

TEST(Flatten, ClampsAlpha) {
  EXPECT_EQ(flattened({1, 1, 1, 3, 1, 1, 1, -2}, 4, {0.5, 0.5, 0.5}),
            (std::vector<float>{1, 1, 1, 1.5F, 1.5F, 1.5F}));
}

TEST(Flatten, CountsOddAlphaAndReadsItAsAnyOtherSample) {
  OddValues counts;
  const auto out = flattened({1, 1, 1, kNan, 1, 1, 1, kInf}, 4, {0.5, 0.5, 0.5}, &counts);
  EXPECT_EQ(out, (std::vector<float>{1.5F, 1.5F, 1.5F, 1, 1, 1}));
  EXPECT_EQ(counts, (OddValues{.nan = 1, .infinite = 1}));
}

TEST(Flatten, IsGreyOnlyOverANeutralBackground) {
  const auto grey = [](Rgb background) {
    PictureInfo info;
    info.grey = true;
    return flatten(std::make_unique<ImageSource>(Image(2, 2, 4), info), background, nullptr)
        ->info()
        .grey;
  };
  EXPECT_TRUE(grey({0.5, 0.5, 0.5}));
  EXPECT_FALSE(grey({0.5, 0.5, 0.6}));
}

TEST(Flatten, RowsAreTheSameForAnyBandHeight) {
  const auto picture = [] {
    Image image(5, 70, 4);
    float value = 0;
    for (int y = 0; y < 70; ++y) {
      for (float& sample : image.view().row(y)) sample = (value += 0.001F);
    }
    return image;
  };
  std::vector<float> first;
  for (const int band : {1, 2, 7, 64}) {
    SCOPED_TRACE(band);
    const auto source = flatten(std::make_unique<ImageSource>(picture()), {1, 2, 3}, nullptr);
    Image out(5, 70, 3);
    for (int y = 0; y < 70; y += band) {
      source->read(out.view().rows(y, std::min(band, 70 - y)));
    }
    const std::vector<float> rows(out.view().data, out.view().row(69).data() + 15);
    if (first.empty()) first = rows;
    EXPECT_EQ(rows, first);
  }
}

}  // namespace
}  // namespace tristim
