#include "lib/dither/mixtures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tristim/core/find.h"

namespace tristim::detail {
namespace {

using Color = MixPalette::Color;

std::vector<Rgb> random_entries(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(0, 1);
  std::vector<Rgb> entries;
  for (int i = 0; i < count; ++i) entries.push_back({any(random), any(random), any(random)});
  return entries;
}

std::vector<Rgb> steps_of_cube(int steps) {
  std::vector<Rgb> entries;
  const auto at = [steps](int i) { return static_cast<double>(i) / (steps - 1); };
  for (int i = 0; i < steps * steps * steps; ++i) {
    entries.push_back({at(i / steps / steps), at(i / steps % steps), at(i % steps)});
  }
  return entries;
}

std::vector<Rgb> greys(int count) {
  std::vector<Rgb> entries;
  for (int i = 0; i < count; ++i) {
    const double light = static_cast<double>(i) / std::max(count - 1, 1);
    entries.push_back({light, light, light});
  }
  return entries;
}

// Of all kinds: few and many, on a line, in planes, in equal steps, twice the same.
std::vector<std::vector<Rgb>> palettes() {
  std::vector<std::vector<Rgb>> all{greys(1),
                                    greys(2),
                                    greys(16),
                                    steps_of_cube(2),
                                    steps_of_cube(6),
                                    random_entries(3, 1),
                                    random_entries(4, 2),
                                    random_entries(16, 3),
                                    random_entries(300, 4)};
  std::vector<Rgb> twice = random_entries(7, 5);
  twice.insert(twice.end(), twice.begin(), twice.end());
  all.push_back(twice);
  return all;
}

MixPalette palette_of(const std::vector<Rgb>& entries, Beyond beyond = Beyond::kMoved) {
  return MixPalette(entries, *find_by_name(kMetrics, "oklab-toe"), Mix::kLight, beyond);
}

Color mixed_by(const Mixtures& mixtures, const MixPalette& palette, const Color& color) {
  constexpr int kSteps = 2048;
  std::array<double, 3> sum{};
  for (int i = 0; i < kSteps; ++i) {
    const float threshold = (static_cast<float>(i) + 0.5F) / kSteps;
    const Color& entry = palette.entry(mixtures.entry(color, threshold));
    for (std::size_t c = 0; c < 3; ++c) sum[c] += entry[c] / kSteps;
  }
  return {static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2])};
}

TEST(Mixtures, HaveTheColourAsTheirMean) {
  std::mt19937 random(1);
  for (const std::vector<Rgb>& entries : palettes()) {
    const MixPalette palette = palette_of(entries);
    const Mixtures mixtures(palette);
    ASSERT_TRUE(mixtures.known());
    for (int i = 0; i < 40; ++i) {
      Color color{};
      std::array<float, 4> share{};
      float sum = 0;
      for (float& s : share) sum += s = std::exponential_distribution<float>()(random);
      for (const float s : share) {
        const Color& entry = palette.entry(static_cast<int>(random() % entries.size()));
        for (std::size_t c = 0; c < 3; ++c) color[c] += s / sum * entry[c];
      }
      SCOPED_TRACE(testing::Message() << entries.size() << " entries, " << i);
      const Color mean = mixed_by(mixtures, palette, color);
      // The steps of the thresholds, three times.
      for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], color[c], 1e-3);
    }
  }
}

// Of six greys the two around it mix a half.
TEST(Mixtures, StrayLittle) {
  const MixPalette palette = palette_of(greys(6));
  const Mixtures mixtures(palette);
  for (float threshold = 0.01F; threshold < 1; threshold += 0.05F) {
    const int entry = mixtures.entry({0.5F, 0.5F, 0.5F}, threshold);
    EXPECT_EQ(entry, threshold <= 0.5F ? 3 : 2) << threshold;  // the brighter one first
  }
}

TEST(Mixtures, ShowEntriesAsThemselves) {
  for (const std::vector<Rgb>& entries : palettes()) {
    const MixPalette palette = palette_of(entries);
    const Mixtures mixtures(palette);
    for (int i = 0; i < palette.size(); ++i) {
      Color near = palette.entry(i);
      for (float& c : near) c = std::nextafter(c, i % 2 == 0 ? 2.0F : 0.0F);
      // Of many entries some simplices are so thin that a last bit is a thousandth of a share.
      const float least = entries.size() > 256 ? 0.05F : 1 / 32768.0F;
      for (const float threshold : {least, 0.5F, 1 - least}) {
        const Color& shown = palette.entry(mixtures.entry(near, threshold));
        EXPECT_EQ(shown, palette.entry(i)) << entries.size() << " entries, " << i;
      }
    }
  }
}

// What a palette does not mix takes the brightness that it can.
TEST(Mixtures, TakeAnyColour) {
  const MixPalette palette = palette_of(greys(4), Beyond::kDamped);
  const Mixtures mixtures(palette);
  EXPECT_EQ(mixtures.entry({7, 7, 7}, 0.5F), 3);
  EXPECT_EQ(mixtures.entry({-7, -7, -7}, 0.5F), 0);
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  for (const float any : {kInfinity, -kInfinity, kNaN}) {
    EXPECT_LT(mixtures.entry({any, 0.5F, any}, 0.5F), 4);
  }
}

TEST(Mixtures, AreTheSameInVectors) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> any(-0.2F, 1.2F);
  for (const std::vector<Rgb>& entries : palettes()) {
    for (const Beyond beyond : {Beyond::kMoved, Beyond::kDamped}) {
      const MixPalette palette = palette_of(entries, beyond);
      const Mixtures mixtures(palette);
      for (const std::size_t size : {0, 1, 15, 16, 17, 255, 256, 257, 1023}) {
        std::array<std::vector<float>, 3> planes;
        std::vector<float> thresholds;
        for (std::size_t i = 0; i < size; ++i) {
          for (auto& plane : planes) plane.push_back(any(random));
          thresholds.push_back(std::uniform_real_distribution<float>(0, 1)(random));
        }
        if (size > 16) planes[1][3] = std::numeric_limits<float>::quiet_NaN();
        std::vector<std::uint16_t> indices(size);
        mixtures.entry_row({planes[0].data(), planes[1].data(), planes[2].data()},
                           thresholds.data(), indices);
        for (std::size_t i = 0; i < size; ++i) {
          ASSERT_EQ(indices[i],
                    mixtures.entry({planes[0][i], planes[1][i], planes[2][i]}, thresholds[i]))
              << entries.size() << " entries, pixel " << i << " of " << size;
        }
      }
    }
  }
}

TEST(Mixtures, AreNotOfLargePalettes) {
  EXPECT_FALSE(Mixtures(palette_of(random_entries(Mixtures::kMostEntries + 1, 6))).known());
}

}  // namespace
}  // namespace tristim::detail
