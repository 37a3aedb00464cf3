#include "tristim/color/interpolate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/color/conversion.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

const ColorModel& model(std::string_view name) { return *parse_model(name, "").model; }

HueArc arc_of(const std::string& name) {
  if (name == "-") return HueArc::kShorter;
  const NamedHueArc* arc = find_by_name(kHueArcs, name);
  if (arc == nullptr) throw std::runtime_error("no such arc");
  return arc->arc;
}

Components cells(const ExampleRow& row, const std::string& letter) {
  return {row.number(letter + "0"), row.number(letter + "1"), row.number(letter + "2")};
}

// Mixes two colours of `from` in `space`.
Components mix(const std::string& from, const std::string& space, const Components& a,
               const Components& b, double t, HueArc arc) {
  const ModelReference source = parse_model(from, "");
  const ColorConversion there(source, parse_model(space, ""), Adaptation::kNone);
  const ColorConversion back(there.to_reference(), source, Adaptation::kNone);
  return back(interpolate(there.to(), there(a), there(b), t, arc));
}

TEST(Interpolate, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/interpolate.csv")) {
    SCOPED_TRACE(row.text("id"));
    const std::string space = row.text("space");
    const bool light = space.ends_with("_linear_bt709");
    const Components mixed =
        mix(light ? "linear:bt709" : "rgb:bt709", space.substr(0, space.find('_')), cells(row, "a"),
            cells(row, "b"), row.number("t"), arc_of(row.text("arc")));
    const Components expected = cells(row, "o");
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(mixed[i], expected[i], space == "rgb" ? 2e-16 : 1e-13);
    }
  }
}

TEST(Interpolate, GoesRoundAsCssSays) {
  struct Case {
    double first, last;
    HueArc arc;
    double half;
  };
  const Case cases[] = {
      {10, 50, HueArc::kShorter, 30},     {50, 10, HueArc::kShorter, 30},
      {350, 20, HueArc::kShorter, 5},     {20, 350, HueArc::kShorter, 5},
      {10, 50, HueArc::kLonger, 210},     {50, 10, HueArc::kLonger, 210},
      {350, 20, HueArc::kLonger, 185},    {20, 350, HueArc::kLonger, 185},
      {30, 30, HueArc::kLonger, 210},     {30, 30, HueArc::kShorter, 30},
      {50, 10, HueArc::kIncreasing, 210}, {10, 50, HueArc::kIncreasing, 30},
      {10, 50, HueArc::kDecreasing, 210}, {50, 10, HueArc::kDecreasing, 30},
      {-60, 660, HueArc::kShorter, 300},  {0, 180, HueArc::kShorter, 90},
  };
  for (const Case& c : cases) {
    const Components half = interpolate(model("hsv"), {c.first, 1, 1}, {c.last, 1, 1}, 0.5, c.arc);
    EXPECT_NEAR(half[0], c.half, 1e-13) << c.first << " to " << c.last;
  }
}

TEST(Interpolate, TakesAnUndefinedHueFromTheOtherEnd) {
  const double none = std::nan("");
  for (const double t : {0.0, 0.25, 1.0}) {
    EXPECT_EQ(interpolate(model("lch"), {50, 0, none}, {60, 10, 77}, t)[2], 77);
    EXPECT_EQ(interpolate(model("lch"), {50, 10, 77}, {60, 0, none}, t)[2], 77);
    EXPECT_TRUE(std::isnan(interpolate(model("lch"), {50, 0, none}, {60, 0, none}, t)[2]));
  }
  EXPECT_TRUE(std::isnan(interpolate(model("lch"), {none, 0, 1}, {60, 10, 77}, 0.5)[0]));
}

TEST(Interpolate, EndsWhereItShould) {
  for (const ColorModel& m : color_models()) {
    SCOPED_TRACE(m.name);
    const Components a{0.1, 0.3, 0.7, 0.2};
    const Components b{0.9, 0.2, 0.4, 0.6};
    for (std::size_t i = 0; i < component_count(m); ++i) {
      EXPECT_EQ(interpolate(m, a, b, 0)[i], a[i]);
      EXPECT_EQ(interpolate(m, a, b, 1)[i], b[i]);
    }
  }
}

TEST(Interpolate, MakesTheNotesTwoYellows) {
  const Components red{1, 0, 0};
  const Components green{0, 1, 0};
  EXPECT_EQ(mix("rgb:srgb", "rgb", red, green, 0.5, HueArc::kShorter), (Components{0.5, 0.5, 0}));
  EXPECT_EQ(mix("rgb:srgb", "hsv", red, green, 0.5, HueArc::kShorter), (Components{1, 1, 0}));
}

}  // namespace
}  // namespace tristim
