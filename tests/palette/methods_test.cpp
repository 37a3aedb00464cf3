#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "tests/error_text.h"
#include "tristim/core/find.h"
#include "tristim/palette/nearest.h"
#include "tristim/palette/quantize.h"

// What every palette method promises, over the list.
namespace tristim {
namespace {

using Palette = std::vector<Color8>;

// Crowded near a few places, so that cells hold several colours; now and then translucent.
Histogram any_histogram(int most) {
  Histogram histogram;
  const int colors = *rc::gen::inRange(0, most);
  const bool opaque = *rc::gen::arbitrary<bool>();
  const auto part = [] {
    return static_cast<std::uint8_t>(*rc::gen::element(0, 100, 200, 250) + *rc::gen::inRange(0, 6));
  };
  for (int i = 0; i < colors; ++i) {
    Color8 color{part(), part(), part()};
    if (!opaque && i % 3 == 0) color.a = part();
    histogram.add(color, *rc::gen::inRange<std::uint64_t>(1, 100));
  }
  return histogram;
}

std::set<Color8> colors_of(const Histogram& histogram) {
  std::set<Color8> used;
  for (const auto& entry : histogram.entries()) used.insert(entry.color);
  return used;
}

// A histogram with `count` distinct colours, spread over all codes.
Histogram spread(int count) {
  Histogram histogram;
  std::uint32_t state = 1;
  for (int i = 0; i < count; ++i) {
    state = state * 1664525 + 1013904223;
    histogram.add(Color8{static_cast<std::uint8_t>(state >> 24),
                         static_cast<std::uint8_t>(state >> 16), static_cast<std::uint8_t>(i)},
                  state >> 28);
  }
  return histogram;
}

RC_GTEST_PROP(PaletteMethods, KeepFewColoursAndNeverReturnMore, ()) {
  const Histogram histogram = any_histogram(60);
  const int colors = *rc::gen::inRange(1, 50);
  const std::set<Color8> used = colors_of(histogram);
  for (const PaletteMethod& method : kPaletteMethods) {
    if (method.always > colors) continue;
    const Palette palette = build_palette(histogram, method, {.colors = colors});
    const std::set<Color8> distinct(palette.begin(), palette.end());
    RC_ASSERT(std::ssize(palette) <= colors);
    RC_ASSERT(distinct.size() == palette.size());
    if (!method.needs_histogram || std::ssize(used) > colors) continue;
    RC_ASSERT(distinct == used);
    RC_ASSERT(std::ranges::is_sorted(palette));
  }
}

// The order in which colours were met must not matter: it depends on bands and threads.
RC_GTEST_PROP(PaletteMethods, DoNotDependOnTheOrderOfCounting, ()) {
  const Histogram histogram = any_histogram(60);
  auto entries = histogram.entries();
  std::ranges::reverse(entries);
  Histogram backwards;
  Histogram rest;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    (i % 2 == 0 ? backwards : rest).add(entries[i].color, entries[i].count);
  }
  backwards.merge(rest);
  for (const PaletteMethod& method : kPaletteMethods) {
    const PaletteOptions options{.colors = std::max(method.always, 9)};
    RC_ASSERT(build_palette(histogram, method, options) ==
              build_palette(backwards, method, options));
  }
}

RC_GTEST_PROP(PaletteMethods, PutFixedColoursAndTheTransparentOneWhereTheyBelong, ()) {
  const Histogram histogram = any_histogram(60);
  const Palette fixed{{1, 2, 3}, {100, 100, 100}, {255, 0, 255}};
  const int transparent = *rc::gen::inRange(3, 12);
  for (const PaletteMethod& method : kPaletteMethods) {
    if (method.always > 0) continue;
    const Palette palette = build_palette(
        histogram, method, {.colors = 12, .fixed = fixed, .transparent = transparent});
    RC_ASSERT(std::ssize(palette) <= 12);
    RC_ASSERT(std::ssize(palette) > transparent);
    RC_ASSERT(std::equal(fixed.begin(), fixed.end(), palette.begin()));
    for (std::size_t i = 0; i < palette.size(); ++i) {
      RC_ASSERT((palette[i] == Color8{0, 0, 0, 0}) ==
                (std::ssize(fixed) <= std::ptrdiff_t(i) && int(i) == transparent));
    }
  }
}

RC_GTEST_PROP(PaletteMethods, OnlyReorderWhenAskedForAnOrder, ()) {
  const Histogram histogram = any_histogram(60);
  for (const PaletteMethod& method : kPaletteMethods) {
    if (method.always > 0) continue;
    Palette found = build_palette(histogram, method, {.colors = 12});
    std::ranges::sort(found);
    for (const NamedPaletteOrder& named : kPaletteOrders) {
      Palette ordered = build_palette(histogram, method, {.colors = 12, .order = named.order});
      std::ranges::sort(ordered);
      RC_ASSERT(ordered == found);
    }
  }
}

TEST(PaletteMethods, TakeOneColourAndManyColours) {
  const Histogram histogram = spread(3000);
  for (const PaletteMethod& method : kPaletteMethods) {
    SCOPED_TRACE(method.name);
    for (const int colors : {1, 2, 3, 17, 256, 1000}) {
      if (method.always > colors) continue;
      const Palette palette = build_palette(histogram, method, {.colors = colors});
      const std::set<Color8> distinct(palette.begin(), palette.end());
      EXPECT_EQ(distinct.size(), palette.size());
      EXPECT_LE(std::ssize(palette), colors);
      // A branch of an octree can have many leaves.
      EXPECT_GT(std::ssize(palette), method.name == "octree" ? 0 : std::min(colors / 3, 200));
    }
  }
}

TEST(PaletteMethods, GiveTheMeanWhereOneColourIsAskedFor) {
  Histogram histogram;
  histogram.add(Color8{10, 20, 30}, 3);
  histogram.add(Color8{50, 60, 70}, 1);
  for (const char* name :
       {"median-cut", "variance-cut", "principal-cut", "wu", "octree", "k-means"}) {
    EXPECT_EQ(build_palette(histogram, *find_by_name(kPaletteMethods, name), {.colors = 1}),
              (Palette{{20, 30, 40}}))
        << name;
  }
}

// Two clouds far apart: a method that measures finds both.
TEST(PaletteMethods, TellTwoCloudsApart) {
  Histogram histogram;
  for (std::uint8_t i = 0; i < 5; ++i) {
    histogram.add(Color8{i, i, 0}, 10);
    histogram.add(Color8{static_cast<std::uint8_t>(250 + i), 200, i}, 3);
  }
  for (const PaletteMethod& method : kPaletteMethods) {
    // Popularity takes both from one cloud, an octree merges at once, median cut splits the larger.
    if (!method.needs_histogram || method.name == "popularity" || method.name == "octree" ||
        method.name == "median-cut") {
      continue;
    }
    const Palette palette =
        build_palette(histogram, method, {.colors = 2, .order = PaletteOrder::kLuminance});
    ASSERT_EQ(palette.size(), 2U) << method.name;
    EXPECT_LT(palette[0].r, 6) << method.name;
    EXPECT_GT(palette[1].r, 248) << method.name;
  }
}

TEST(Inks, GoFromAllInksToPaperInEqualSteps) {
  const Color8 blue{32, 64, 128};
  const auto tones = [](int colors, std::vector<Color8> inks) {
    return build_palette({}, *find_by_name(kPaletteMethods, "inks"),
                         {.colors = colors, .inks = std::move(inks)});
  };
  EXPECT_EQ(tones(2, {blue}), (Palette{blue, {255, 255, 255}}));
  // One black ink: greys whose cube roots of light are in equal steps, .5^3 = .125 in the middle.
  EXPECT_EQ(tones(3, {{0, 0, 0}}), (Palette{{0, 0, 0}, {99, 99, 99}, {255, 255, 255}}));
  const Palette duotone = tones(16, {{255, 128, 0}, {0, 0, 0}});
  ASSERT_EQ(duotone.size(), 16U);
  EXPECT_EQ(duotone.front(), (Color8{0, 0, 0}));
  EXPECT_GT(duotone[8].r, duotone[8].b + 50);  // the middle is orange
  for (std::size_t i = 1; i < duotone.size(); ++i) {
    EXPECT_GT(duotone[i].r + duotone[i].g, duotone[i - 1].r + duotone[i - 1].g);
  }
  EXPECT_EQ(tones(5, {blue, blue, blue}).size(), 5U);
}

TEST(BuildPalette, OfNothingIsWhatIsFixed) {
  for (const PaletteMethod& method : kPaletteMethods) {
    if (!method.needs_histogram) continue;
    EXPECT_TRUE(build_palette({}, method, {}).empty()) << method.name;
    EXPECT_EQ(build_palette({}, method, {.fixed = {{1, 2, 3}}, .transparent = 2}),
              (Palette{{1, 2, 3}, {1, 2, 3}, {0, 0, 0, 0}}))
        << method.name;
  }
}

TEST(BuildPalette, OrdersByLuminanceHueAndPopularity) {
  Histogram histogram;
  histogram.add(Color8{0, 0, 255}, 4);
  histogram.add(Color8{255, 0, 0}, 2);
  histogram.add(Color8{0, 255, 0}, 3);
  histogram.add(Color8{90, 90, 90}, 1);
  const auto ordered = [&](PaletteOrder order) {
    return build_palette(histogram, kPaletteMethods[0], {.colors = 4, .order = order});
  };
  const Color8 red{255, 0, 0};
  const Color8 green{0, 255, 0};
  const Color8 blue{0, 0, 255};
  const Color8 grey{90, 90, 90};
  EXPECT_EQ(ordered(PaletteOrder::kFound), (Palette{blue, green, grey, red}));
  EXPECT_EQ(ordered(PaletteOrder::kLuminance), (Palette{blue, grey, red, green}));
  EXPECT_EQ(ordered(PaletteOrder::kHue), (Palette{grey, red, green, blue}));
  EXPECT_EQ(ordered(PaletteOrder::kPopularity), (Palette{blue, green, red, grey}));
}

TEST(BuildPalette, SaysWhatIsWrong) {
  const PaletteMethod& method = kPaletteMethods[0];
  const auto text = [&](const PaletteOptions& options, const PaletteMethod& by) -> std::string {
    try {
      build_palette({}, by, options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(text({.colors = 0}, method), "palette: 0 colours, expected 1 to 65536");
  EXPECT_EQ(text({.colors = 65537}, method), "palette: 65537 colours, expected 1 to 65536");
  EXPECT_EQ(text({.colors = 1, .fixed = {{}, {1, 1, 1}}}, method),
            "palette: 2 fixed colours, more than the 1 of the palette");
  EXPECT_EQ(text({.colors = 4, .fixed = {{}}, .transparent = 0}, method),
            "palette: transparent index 0, expected 1 to 3, behind the fixed colours");
  EXPECT_EQ(text({.colors = 4, .transparent = 4}, method),
            "palette: transparent index 4, expected 0 to 3, behind the fixed colours");
  EXPECT_EQ(text({.inks = {}}, method), "palette: 0 inks, expected 1 to 3");
  EXPECT_EQ(text({.colors = 255}, *find_by_name(kPaletteMethods, "fixed-332")),
            "palette: fixed-332 has 256 colours, more than the 255 there is room for");
}

}  // namespace
}  // namespace tristim
