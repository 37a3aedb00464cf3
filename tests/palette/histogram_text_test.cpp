#include "tristim/palette/histogram_text.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "tests/error_text.h"

namespace tristim {
namespace {

constexpr std::string_view kHead = "tristim histogram 1\n";

Histogram example() {
  Histogram histogram;
  histogram.add(Color8{255, 128, 0}, 12);
  histogram.add(Color8{0, 1, 2}, 5'000'000'000);
  histogram.add(Color8{0, 1, 2, 127}, 1);
  return histogram;
}

std::string refusal(std::string_view rows) {
  return error_text([rows] {
    Histogram histogram;
    merge_histogram_text(std::string(kHead) + std::string(rows), "h", histogram);
  });
}

TEST(HistogramText, IsARowForEachColour) {
  EXPECT_EQ(histogram_text(example()),
            std::string(kHead) + "0001027f 1\n000102 5000000000\nff8000 12\n");
  EXPECT_EQ(histogram_text({}), kHead);
}

TEST(HistogramText, ReadBackIsTheSame) {
  Histogram histogram;
  merge_histogram_text(histogram_text(example()), "h", histogram);
  EXPECT_EQ(histogram.entries(), example().entries());
  merge_histogram_text(histogram_text(example()), "h", histogram);
  EXPECT_EQ(histogram.entries()[1].count, 10'000'000'000U);
}

TEST(HistogramText, TakesOtherEndsOfLinesAndRepeatedColours) {
  Histogram histogram;
  merge_histogram_text("\xEF\xBB\xBFtristim histogram 1\r\nFF8000 5\r\nff8000ff 7", "h", histogram);
  ASSERT_EQ(histogram.entries().size(), 1U);
  EXPECT_EQ(histogram.entries()[0].count, 12U);
}

TEST(HistogramText, SaysWhatIsWrongAndWhere) {
  const std::string remedy = "; write it with palette build --histogram-out";
  const std::string row = ": expected a colour and how often it occurs, as in 'ff8000 12'" + remedy;
  for (const char* bad :
       {"ff8000\n", "ff8000 \n", "ff8000 0\n", "ff8000 -1\n", "ff8000 1.5\n", "ff8000 12 \n",
        "ff8000  12\n", "ff800 12\n", "#ff8000 12\n", "gg8000 12\n", "+f8000 12\n", "\n", " 12\n",
        "ff8000 99999999999999999999\n"}) {
    EXPECT_EQ(refusal(std::string("000000 1\n") + bad), "3 h:3" + row) << bad;
  }
  EXPECT_EQ(refusal("000000 70368744177665\n"),
            "3 h:2: counts more than 70368744177664 pixels" + remedy);
  EXPECT_EQ(refusal("000000 70368744177664\nffffff 1\n"),
            "3 h:3: counts more than 70368744177664 pixels" + remedy);
  EXPECT_EQ(error_text([] {
              Histogram histogram;
              merge_histogram_text("", "h", histogram);
            }),
            "3 h:1: is no histogram: its first line is not 'tristim histogram 1'" + remedy);
}

TEST(HistogramText, LeavesTheHistogramWhereItFails) {
  Histogram histogram = example();
  EXPECT_THROW(merge_histogram_text(std::string(kHead) + "000000 1\nx", "h", histogram),
               std::exception);
  EXPECT_EQ(histogram.entries(), example().entries());
}

// Hostile text is refused or read, never worse.
RC_GTEST_PROP(HistogramText, SurvivesMutations, ()) {
  std::string text = histogram_text(example());
  for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
    text[*rc::gen::inRange<std::size_t>(0, text.size())] = *rc::gen::arbitrary<char>();
  }
  Histogram histogram;
  error_text([&] { merge_histogram_text(text, "h", histogram); });
}

}  // namespace
}  // namespace tristim
