#include "lib/dither/palette_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "lib/dither/entry_grid.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

std::vector<Rgb> random_entries(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> light(0, 1);
  std::vector<Rgb> entries;
  for (int i = 0; i < count; ++i) {
    const double r = light(random);
    const double g = light(random);
    entries.push_back({r * r, g * g, light(random) * light(random)});
  }
  return entries;
}

// A picture of noise about slopes, with pixels that are entries already.
Image picture(int width, int height, const std::vector<Rgb>& entries) {
  Image image(width, height, 3);
  std::mt19937 random(static_cast<unsigned>(width * height));
  std::uniform_real_distribution<float> grain(-0.1F, 0.1F);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      float* p = image.view().pixel(x, y);
      p[0] = static_cast<float>(x) / static_cast<float>(width) + grain(random);
      p[1] = static_cast<float>(y) / static_cast<float>(height) + grain(random);
      p[2] = p[0] * p[1] + grain(random);
      if (random() % 7 != 0) continue;
      const Rgb& entry = entries[random() % entries.size()];
      p[0] = static_cast<float>(entry.r);
      p[1] = static_cast<float>(entry.g);
      p[2] = static_cast<float>(entry.b);
    }
  }
  return image;
}

using Indices = std::vector<std::uint16_t>;

Indices samples(const Raster<std::uint16_t>& indices) {
  const auto view = indices.view();
  return {view.data, view.data + std::ptrdiff_t{view.stride} * view.height};
}

Indices by_definition(const MixPalette& palette, const DiffusionOptions& options, const Image& in) {
  const auto view = in.view();
  Raster<std::uint16_t> out(view.width, view.height, 1);
  PaletteDiffusion diffusion(palette, view.width, options);
  for (int y = 0; y < view.height; ++y) diffusion.row(view.row(y), out.view().row(y));
  return samples(out);
}

Indices by_rows(const MixPalette& palette, const DiffusionOptions& options, const Image& in,
                int band, int threads = 1) {
  const auto view = in.view();
  Raster<std::uint16_t> out(view.width, view.height, 1);
  PaletteDiffusion diffusion(palette, view.width, options);
  for (int y = 0; y < view.height; y += band) {
    const int count = std::min(band, view.height - y);
    diffusion.rows(view.rows(y, count), out.view().rows(y, count), threads);
  }
  return samples(out);
}

class EverySet : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { setenv("TRISTIM_SIMD", GetParam().c_str(), 1); }
  void TearDown() override { unsetenv("TRISTIM_SIMD"); }
};

std::vector<std::string> sets() {
  std::vector<std::string> names;
  for (const auto& rows : detail::all_palette_rows()) names.emplace_back(rows.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(PaletteRows, EverySet, testing::ValuesIn(sets()),
                         [](const auto& set) { return set.param; });

TEST_P(EverySet, IsTheDefinitionBitForBit) {
  for (const int count : {1, 2, 7, 16, 200}) {
    const std::vector<Rgb> entries = random_entries(count, 3);
    const MixPalette palette(entries, *find_by_name(kMetrics, "oklab-toe"), Mix::kLight,
                             count > 10 ? Beyond::kDamped : Beyond::kMoved);
    for (const auto& [width, height] : {std::pair{1, 20}, {2, 5}, {3, 40}, {31, 18}, {130, 70}}) {
      const Image in = picture(width, height, entries);
      for (const DiffusionKernel* kernel : {&kFloydSteinberg, &kBlueDiffusion, &kStevensonArce}) {
        const DiffusionOptions options{.kernel = kernel, .jitter = kernel->jitter, .seed = 5};
        const Indices expected = by_definition(palette, options, in);
        for (const int band : {64, 21}) {
          EXPECT_EQ(by_rows(palette, options, in, band), expected)
              << kernel->name << ", " << count << " entries, " << width << " x " << height;
        }
      }
    }
  }
}

TEST_P(EverySet, GivesTheSameOnAnyNumberOfThreads) {
  const std::vector<Rgb> entries = random_entries(8, 6);
  const MixPalette palette(entries, *find_by_name(kMetrics, "oklab-toe"), Mix::kLight);
  for (const int width : {1, 40, 700}) {
    const Image in = picture(width, 130, entries);
    for (const DiffusionKernel* kernel : {&kFloydSteinberg, &kBlueDiffusion}) {
      const DiffusionOptions options{.kernel = kernel, .jitter = kernel->jitter};
      const Indices expected = by_definition(palette, options, in);
      for (const int threads : {2, 7}) {
        EXPECT_EQ(by_rows(palette, options, in, 100, threads), expected)
            << kernel->name << ", " << width << " wide, " << threads << " threads";
      }
    }
  }
}

TEST_P(EverySet, TakesEveryKernelAndMetric) {
  const std::vector<Rgb> entries = random_entries(12, 4);
  const Image in = picture(60, 40, entries);
  const MixPalette usual(entries, *find_by_name(kMetrics, "oklab-toe"), Mix::kLight);
  for (const DiffusionKernel& kernel : kDiffusionKernels) {
    const DiffusionOptions options{.kernel = &kernel, .jitter = kernel.jitter};
    EXPECT_EQ(by_rows(usual, options, in, 40), by_definition(usual, options, in)) << kernel.name;
  }
  for (const Metric& metric : kMetrics) {
    for (const Mix mix : {Mix::kLight, Mix::kEncoded}) {
      const MixPalette palette(entries, metric, mix);
      EXPECT_EQ(by_rows(palette, {}, in, 40), by_definition(palette, {}, in)) << metric.name;
    }
  }
}

TEST(EntryGrid, FindsWhatComparingWithAllFinds) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> any(-0.5F, 1.5F);
  for (const int count : {1, 2, 16, 256}) {
    const MixPalette palette(random_entries(count, 9), *find_by_name(kMetrics, "oklab-toe"),
                             Mix::kLight);
    const detail::EntryGrid grid(palette);
    for (int i = 0; i < 5000; ++i) {
      const float r = any(random);
      const float g = any(random);
      const MixPalette::Color color{r, g, any(random)};
      auto place = grid.place(color);
      int best = 0;
      float least = 1e9F;
      for (std::size_t a = 0; a < 3; ++a) {
        place[a] = std::clamp(place[a], grid.axes()[a].knot.front(), grid.axes()[a].knot.back());
      }
      for (int k = 0; k < count; ++k) {
        const auto entry = grid.place(palette.entry(k));
        float sum = 0;
        for (std::size_t a = 0; a < 3; ++a) sum += (entry[a] - place[a]) * (entry[a] - place[a]);
        if (sum < least) {
          least = sum;
          best = k;
        }
      }
      EXPECT_EQ(grid.nearest(color), best);
    }
  }
}

TEST(EntryGrid, PlacesAsTheMetricDoes) {
  const MixPalette palette(random_entries(5, 1), *find_by_name(kMetrics, "oklab-toe"), Mix::kLight);
  const detail::EntryGrid grid(palette);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> any(-2, 3);
  for (int i = 0; i < 2000; ++i) {
    const float r = any(random);
    const float g = any(random);
    const float b = any(random);
    const auto exact = oklab_toe_place({r, g, b});
    const auto fast = grid.place({r, g, b});
    for (std::size_t a = 0; a < 3; ++a)
      EXPECT_NEAR(fast[a], exact[a], 3e-6 * (1 + std::abs(exact[a])));
  }
}

}  // namespace
}  // namespace tristim
