#include "tristim/color/iscc_nbs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <string>

#include "tests/color/srgb_munsell.h"
#include "tests/example_rows.h"
#include "tests/support.h"

namespace tristim {
namespace {

std::string name_of(const Munsell& munsell) {
  const IsccNbsName* name = iscc_nbs_name(munsell);
  return name == nullptr ? "none" : std::string(name->name);
}

TEST(IsccNbs, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/iscc_nbs.csv")) {
    EXPECT_EQ(name_of({row.number("H"), row.number("V"), row.number("C")}), row.text("name"));
  }
}

TEST(IsccNbs, Has267NamesWhoseCentersHaveThem) {
  std::set<std::string_view> names;
  ASSERT_EQ(iscc_nbs_names().size(), 267U);
  int number = 0;
  for (const IsccNbsName& name : iscc_nbs_names()) {
    EXPECT_EQ(name.number, ++number);
    EXPECT_EQ(name_of(name.center), name.name);
    names.insert(name.name);
  }
  EXPECT_EQ(names.size(), 267U);
}

// [Kelly76] section 13.
TEST(IsccNbs, NamesColors) {
  EXPECT_EQ(name_of({1.5, 7, 13}), "vivid pink");
  EXPECT_EQ(name_of({69.5, 3.5, 1}), "dark bluish gray");
  EXPECT_EQ(name_of({91.92, 9.06, 8.16}), "light purplish pink");
  EXPECT_EQ(name_of({91.92 - 100, 9.06, 8.16}), "light purplish pink");
  EXPECT_EQ(name_of({0.5, 5, 0.2}), "medium gray");
  EXPECT_EQ(name_of({std::nan(""), 10, 0}), "white");
  EXPECT_EQ(name_of({std::nan(""), 0, 0}), "black");
}

TEST(IsccNbs, BeginsAtBoundaries) {
  EXPECT_EQ(name_of({64, 3.5, 7}), "strong greenish blue");
  EXPECT_EQ(name_of({5, 2.5, 0.2}), "dark gray");
  EXPECT_EQ(name_of({5, std::nextafter(2.5, 0), 0.2}), "black");
}

TEST(IsccNbs, NamesEveryColorHoweverVivid) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 100000; ++i) {
    const Munsell m{100 * unit(random), 10 * unit(random), 60 * unit(random) * unit(random)};
    ASSERT_NE(iscc_nbs_name(m), nullptr) << munsell_notation(m);
  }
  for (int hue = 0; hue <= 100; ++hue) {
    for (const double value : {0.0, 2.5, 10.0}) {
      for (const double chroma : {0.0, 0.5, 7.0, 1000.0}) {
        ASSERT_NE(iscc_nbs_name({double(hue), value, chroma}), nullptr);
      }
    }
  }
}

TEST(IsccNbs, NamesAllOfSrgb) {
  for (int red = 0; red < 256; red += 17) {
    for (int green = 0; green < 256; green += 17) {
      for (int blue = 0; blue < 256; blue += 17) {
        ASSERT_NE(iscc_nbs_name(srgb_munsell(red, green, blue)), nullptr);
      }
    }
  }
  EXPECT_EQ(name_of(srgb_munsell(255, 0, 0)), "vivid reddish orange");
  EXPECT_EQ(name_of(srgb_munsell(0, 0, 255)), "vivid blue");
  EXPECT_EQ(name_of(srgb_munsell(128, 128, 128)), "medium gray");
}

TEST(IsccNbs, HasNoNameForNoColor) {
  const double nan = std::nan("");
  for (const Munsell m :
       {Munsell{nan, nan, nan}, {5, -1, 2}, {5, 5, -1}, {nan, 5, 4}, {5, nan, 0}}) {
    EXPECT_EQ(iscc_nbs_name(m), nullptr);
  }
}

}  // namespace
}  // namespace tristim
