#include "tristim/palette/guidelines.h"

#include <gtest/gtest.h>

#include "tristim/color/parse.h"
#include "tristim/color/transfer.h"

namespace tristim {
namespace {

ChartColor color(std::string_view name) {
  const EncodedRgb c = parse_color(name).value();
  return {std::string(name), {srgb_decode(c.r), srgb_decode(c.g), srgb_decode(c.b)}};
}

Chart chart(std::initializer_list<std::string_view> names, std::string_view background = {}) {
  std::vector<ChartColor> colors;
  for (const std::string_view name : names) colors.push_back(color(name));
  std::optional<ChartColor> behind;
  if (!background.empty()) behind = color(background);
  return palette_chart(std::move(colors), std::move(behind));
}

Finding finding(int number, const Chart& chart) {
  return judge(guidelines()[static_cast<std::size_t>(number - 1)], chart);
}

Verdict verdict(int number, const Chart& chart) { return finding(number, chart).verdict; }

TEST(Guidelines, AreFifteenInOrder) {
  ASSERT_EQ(guidelines().size(), 15U);
  for (std::size_t i = 0; i < 15; ++i) {
    EXPECT_EQ(guidelines()[i].number, static_cast<int>(i) + 1);
    EXPECT_FALSE(guidelines()[i].text.empty() || guidelines()[i].measure.empty());
    const Finding found = judge(guidelines()[i], chart({"red", "navy", "gold"}));
    EXPECT_FALSE(found.text.empty()) << i;
    if (guidelines()[i].judge == nullptr) {
      EXPECT_EQ(found.verdict, Verdict::kUnjudged) << i;
    }
  }
}

TEST(Guidelines, OneWantsAPlane) {
  EXPECT_EQ(verdict(1, chart({"#000", "#444", "#888", "#fff"})), Verdict::kPass);
  EXPECT_EQ(verdict(1, chart({"red", "lime", "blue", "yellow", "white", "black"})), Verdict::kWarn);
  EXPECT_EQ(verdict(1, chart({"red", "lime"})), Verdict::kUnjudged);
}

TEST(Guidelines, TwoWarnsOfRedAndBlueTogether) {
  const Finding warned = finding(2, chart({"red", "blue"}));
  EXPECT_EQ(warned.verdict, Verdict::kWarn);
  EXPECT_NEAR(warned.measures[0].second, 464.3, 0.3);  // sRGB's primaries
  EXPECT_NEAR(warned.measures[1].second, 611.4, 0.3);
  EXPECT_EQ(verdict(2, chart({"red", "lime"})), Verdict::kPass);
  EXPECT_EQ(verdict(2, chart({"#c99", "#99c"})), Verdict::kPass);
}

TEST(Guidelines, ThreeWarnsOfPureBlue) {
  EXPECT_EQ(verdict(3, chart({"blue", "white"})), Verdict::kWarn);
  EXPECT_EQ(verdict(3, chart({"red", "white"})), Verdict::kPass);
}

TEST(Guidelines, FourWarnsOfNeighboursThatDifferInBlueOnly) {
  const Finding warned = finding(4, chart({"#808000", "#808060"}));
  EXPECT_EQ(warned.verdict, Verdict::kWarn);
  EXPECT_NE(warned.text.find("#808000 and #808060"), std::string::npos);
  EXPECT_EQ(verdict(4, chart({"#800000", "#808060"})), Verdict::kPass);
  Chart apart = chart({"#808000", "#808060", "black"});
  apart.neighbours = {{0, 2}, {1, 2}};
  EXPECT_EQ(verdict(4, apart), Verdict::kPass);
}

TEST(Guidelines, SevenAndEightMeasureStepsAndEdges) {
  EXPECT_EQ(verdict(7, chart({"#808080", "#828282"})), Verdict::kWarn);
  EXPECT_EQ(verdict(7, chart({"black", "white"})), Verdict::kPass);
  const Finding edge = finding(8, chart({"black", "white"}));
  EXPECT_EQ(edge.verdict, Verdict::kPass);
  EXPECT_NEAR(edge.measures[0].second, 21, 1e-12);
  EXPECT_EQ(verdict(8, chart({"#d00000", "#008000"})), Verdict::kWarn);
}

TEST(Guidelines, NineNeedsPlaces) {
  Chart picture = chart({"red", "black"});
  EXPECT_EQ(verdict(9, picture), Verdict::kUnjudged);
  picture.has_places = true;
  picture.colors[0].rim = 10;
  picture.colors[1].rim = 90;
  EXPECT_EQ(verdict(9, picture), Verdict::kWarn);
  picture.colors[0].rim = 1;
  EXPECT_EQ(verdict(9, picture), Verdict::kPass);
}

TEST(Guidelines, TenLooksForOpponents) {
  EXPECT_EQ(verdict(10, chart({"blue", "gold"})), Verdict::kPass);
  EXPECT_EQ(verdict(10, chart({"red", "orange"})), Verdict::kWarn);
  EXPECT_EQ(verdict(10, chart({"black", "white"})), Verdict::kUnjudged);
}

TEST(Guidelines, ElevenSeesAsTheDeficientDo) {
  const Finding warned = finding(11, chart({"#b06000", "#608000"}));
  EXPECT_EQ(warned.verdict, Verdict::kWarn) << warned.text;
  EXPECT_EQ(warned.measures.size(), 3U);
  EXPECT_EQ(verdict(11, chart({"black", "white"})), Verdict::kPass);
}

TEST(Guidelines, TwelveCountsHues) {
  EXPECT_EQ(verdict(12, chart({"red", "yellow", "lime", "cyan", "blue", "magenta"})),
            Verdict::kWarn);
  EXPECT_EQ(verdict(12, chart({"red", "orange", "gold"})), Verdict::kPass);
}

TEST(Guidelines, ThirteenAndFourteenJudgeTheBackground) {
  EXPECT_EQ(verdict(13, chart({"gold"}, "blue")), Verdict::kPass);
  EXPECT_EQ(verdict(13, chart({"gold"}, "white")), Verdict::kWarn);
  EXPECT_EQ(verdict(13, chart({"gold"})), Verdict::kUnjudged);
  Chart chart9 =
      chart({"#111", "#222", "#333", "#444", "#555", "#666", "#777", "#888", "#999"}, "#808080");
  EXPECT_EQ(verdict(14, chart9), Verdict::kPass);
  EXPECT_EQ(verdict(13, chart9), Verdict::kUnjudged);
  chart9.background = color("navy");
  EXPECT_EQ(verdict(14, chart9), Verdict::kWarn);
  EXPECT_EQ(verdict(14, chart({"gold"}, "white")), Verdict::kUnjudged);
}

TEST(ContrastRatio, IsThatOfWcag) {
  EXPECT_NEAR(contrast_ratio({0, 0, 0}, {1, 1, 1}), 21, 1e-12);
  EXPECT_EQ(contrast_ratio({1, 1, 1}, {1, 1, 1}), 1);
  EXPECT_NEAR(contrast_ratio(color("#777777").linear_srgb, {1, 1, 1}), 4.48, 0.005);
}

}  // namespace
}  // namespace tristim
