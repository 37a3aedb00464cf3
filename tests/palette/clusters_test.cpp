#include "lib/palette/clusters.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "lib/palette/search.h"

namespace tristim::detail {
namespace {

Places any_places(std::size_t count, int axes) {
  Places places;
  for (std::size_t i = 0; i < count; ++i) {
    Place place{};
    for (int a = 0; a < axes; ++a) {
      // Coarse, so that some are equally near.
      place[static_cast<std::size_t>(a)] = static_cast<float>(*rc::gen::inRange(0, 9)) / 8;
    }
    places.push_back(place, 1);
  }
  places.axes = axes;
  return places;
}

Nearest search_all(const PlaceSearch& search, const Places& entries, const Places& places,
                   int axes) {
  Nearest nearest{std::vector<std::uint32_t>(places.size()), std::vector<float>(places.size())};
  search.nearest(planes_of(entries), planes_of(places), axes, nearest.index.data(),
                 nearest.distance2.data());
  return nearest;
}

RC_GTEST_PROP(PlaceSearch, InVectorsIsTheDefinition, ()) {
  const int axes = *rc::gen::inRange(3, 5);
  const Places entries = any_places(*rc::gen::inRange<std::size_t>(1, 40), axes);
  const Places places = any_places(*rc::gen::inRange<std::size_t>(0, 150), axes);
  const Nearest expected = search_all(scalar_place_search(), entries, places, axes);
  const Nearest found = search_all(place_search(), entries, places, axes);
  RC_ASSERT(found.index == expected.index);
  RC_ASSERT(found.distance2 == expected.distance2);
}

// A few thousand colours with neighbours, and palettes up to the largest.
TEST(NearestEntries, AreThoseOfAllEntries) {
  std::vector<Histogram::Entry> entries;
  Histogram histogram;
  std::uint32_t state = 7;
  const auto random = [&state] { return (state = state * 1664525 + 1013904223) >> 24; };
  for (int i = 0; i < 3000; ++i) {
    const std::uint32_t r = random();
    histogram.add(Color8{static_cast<std::uint8_t>(r),
                         static_cast<std::uint8_t>(r / 2 + random() / 8),
                         static_cast<std::uint8_t>(random() / 4)});
  }
  entries = histogram.entries();
  for (const Metric& metric : kMetrics) {
    const ColorCells cells(entries, metric);
    const Placer placer(metric);
    for (const int size : {1, 2, 7, 256, 4096, 65536}) {
      if (size == 65536 && metric.name != "balanced") continue;
      Places palette;
      for (int k = 0; k < size; ++k) {
        palette.push_back(
            placer({static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()),
                    static_cast<std::uint8_t>(random())}),
            0);
      }
      const Nearest found = nearest_entries(cells.colors, palette);
      const Nearest expected = search_all(place_search(), palette, cells.colors.places, 3);
      EXPECT_EQ(found.index, expected.index) << metric.name << " " << size;
      EXPECT_EQ(found.distance2, expected.distance2) << metric.name << " " << size;
    }
  }
}

TEST(ColorCells, HoldEveryColourOnce) {
  Histogram histogram;
  for (int i = 0; i < 4000; ++i) {
    histogram.add(Color8{static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i / 16),
                         static_cast<std::uint8_t>(i / 100)},
                  static_cast<std::uint64_t>(i % 5 + 1));
  }
  const auto entries = histogram.entries();
  const ColorCells cells(entries, *kMetrics.begin());
  EXPECT_EQ(cells.entries, histogram.neighbours());
  double weight = 0;
  for (const float w : cells.cells.places.weight) weight += w;
  double expected = 0;
  for (const auto& entry : entries) expected += static_cast<double>(entry.count);
  EXPECT_EQ(weight, expected);
  ASSERT_EQ(cells.colors.levels.size(), 2U);
  std::uint32_t next = 0;
  for (const PlaceGroup& group : cells.colors.levels.back()) {
    EXPECT_EQ(group.first, next);
    next = group.end;
  }
  EXPECT_EQ(next, entries.size());
}

}  // namespace
}  // namespace tristim::detail
