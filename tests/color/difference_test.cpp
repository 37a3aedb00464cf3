#include "tristim/color/difference.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <set>

#include "tests/error_text.h"
#include "tests/example_rows.h"
#include "tests/support.h"

namespace tristim {
namespace {

struct Pair {
  Lab first, second;
  double difference;
};

// clang-format off
// The supplementary test data [Sharma05 table 1], to the 4 decimals printed; pair 14 is exactly
// opposite in hue.
constexpr Pair kPairs[] = {
    {{50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425},
    {{50, 3.1571, -77.2803}, {50, 0, -82.7485}, 2.8615},
    {{50, 2.8361, -74.02}, {50, 0, -82.7485}, 3.4412},
    {{50, -1.3802, -84.2814}, {50, 0, -82.7485}, 1},
    {{50, -1.1848, -84.8006}, {50, 0, -82.7485}, 1},
    {{50, -0.9009, -85.5211}, {50, 0, -82.7485}, 1},
    {{50, 0, 0}, {50, -1, 2}, 2.3669},
    {{50, -1, 2}, {50, 0, 0}, 2.3669},
    {{50, 2.49, -0.001}, {50, -2.49, 0.0009}, 7.1792},
    {{50, 2.49, -0.001}, {50, -2.49, 0.001}, 7.1792},
    {{50, 2.49, -0.001}, {50, -2.49, 0.0011}, 7.2195},
    {{50, 2.49, -0.001}, {50, -2.49, 0.0012}, 7.2195},
    {{50, -0.001, 2.49}, {50, 0.0009, -2.49}, 4.8045},
    {{50, -0.001, 2.49}, {50, 0.001, -2.49}, 4.8045},
    {{50, -0.001, 2.49}, {50, 0.0011, -2.49}, 4.7461},
    {{50, 2.5, 0}, {50, 0, -2.5}, 4.3065},
    {{50, 2.5, 0}, {73, 25, -18}, 27.1492},
    {{50, 2.5, 0}, {61, -5, 29}, 22.8977},
    {{50, 2.5, 0}, {56, -27, -3}, 31.903},
    {{50, 2.5, 0}, {58, 24, 15}, 19.4535},
    {{50, 2.5, 0}, {50, 3.1736, 0.5854}, 1},
    {{50, 2.5, 0}, {50, 3.2972, 0}, 1},
    {{50, 2.5, 0}, {50, 1.8634, 0.5757}, 1},
    {{50, 2.5, 0}, {50, 3.2592, 0.335}, 1},
    {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
    {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.263},
    {{61.2901, 3.7196, -5.3901}, {61.4292, 2.248, -4.962}, 1.8731},
    {{35.0831, -44.1164, 3.7933}, {35.0232, -40.0716, 1.5901}, 1.8645},
    {{22.7233, 20.0904, -46.694}, {23.0331, 14.973, -42.5619}, 2.0373},
    {{36.4612, 47.858, 18.3852}, {36.2715, 50.5065, 21.2231}, 1.4146},
    {{90.8027, -2.0831, 1.441}, {91.1528, -1.6435, 0.0447}, 1.4441},
    {{90.9257, -0.5406, -0.9208}, {88.6381, -0.8985, -0.7239}, 1.5381},
    {{6.7747, -0.2908, -2.4247}, {5.8714, -0.0985, -2.2286}, 0.6377},
    {{2.0776, 0.0795, -1.135}, {0.9033, -0.0636, -0.5514}, 0.9082},
};
// clang-format on

double channel(int low, int high) { return *rc::gen::inRange(low * 10, high * 10) / 10.0; }
Lab any_lab() { return {channel(0, 101), channel(-130, 131), channel(-130, 131)}; }

TEST(Ciede2000, ReproducesThePublishedPairs) {
  ASSERT_EQ(std::size(kPairs), 34U);
  for (const Pair& pair : kPairs) {
    SCOPED_TRACE(testing::Message() << "pair " << &pair - kPairs + 1);
    EXPECT_NEAR(ciede2000(pair.first, pair.second), pair.difference, 0.5e-4);
    EXPECT_EQ(ciede2000(pair.second, pair.first), ciede2000(pair.first, pair.second));
  }
}

RC_GTEST_PROP(Ciede2000, IsSymmetricToTheBit, ()) {
  const Lab a = any_lab();
  const Lab b = any_lab();
  RC_ASSERT(ciede2000(a, b) == ciede2000(b, a));
  RC_ASSERT(ciede2000(a, b) >= 0);
}

RC_GTEST_PROP(Ciede2000, IsZeroForEqualColoursOnly, ()) {
  const Lab a = any_lab();
  Lab b = a;
  RC_ASSERT(ciede2000(a, b) == 0);
  b.l += 0.1;
  RC_ASSERT(ciede2000(a, b) > 0);
}

TEST(Ciede2000, OfGreysIsOfLightnessAlone) {
  EXPECT_EQ(ciede2000({50, 0, 0}, {50, 0, 0}), 0);
  // At mean L* 50 the weight of lightness is 1 [Sharma05 eq 15].
  EXPECT_DOUBLE_EQ(ciede2000({49, 0, 0}, {51, 0, 0}), 2);
}

TEST(Ciede2000, NanStaysNan) {
  EXPECT_TRUE(std::isnan(ciede2000({std::nan(""), 0, 0}, {50, 0, 0})));
  EXPECT_TRUE(std::isnan(ciede2000({50, std::nan(""), 0}, {50, 0, 0})));
}

using Values = std::array<double, 3>;

// In 40 digits: ciede2000, cie76, cie94, cie94-textiles, cmc, cmc-1-1, in the order of the list.
struct Golden {
  Values reference, sample;
  double differences[6];
};
constexpr Golden kGolden[] = {
    {{50, 2.6772, -79.7751},
     {50, 0, -82.7485},
     {2.0424596801565604, 4.0010632836784865, 1.3950388678587357, 1.423046205421281,
      1.7387361057261509, 1.7387361057261509}},
    {{50, -0.001, 2.49},
     {50, 0.001, -2.49},
     {4.8045245082117679, 4.9800004016064099, 4.8006944494591868, 4.8122455096129036,
      6.6749232592102113, 6.6749232592102113}},
    {{94.2, -44.18, -69.75},
     {31.8, 99.4, 8.9},
     {110.64000490049073, 175.1993119278726, 95.898667559224025, 81.779163520989323,
      76.701910567964388, 85.281036792024074}},
    {{58.2, 16.8, 57.3},
     {56.7, 17.8, 59.2},
     {1.5054841033151263, 2.6191601707417631, 1.6201347342779708, 0.95446927072630147,
      1.0379574361859762, 1.5155233693234721}},
    {{12, 30, -40},
     {14, 28, -43},
     {2.8005055464695438, 4.1231056256176605, 2.8009511769736835, 2.247450166126346,
      2.8671347823306606, 4.4395257009774163}},
    {{50, 0, 0},
     {50.000001, 0, 0},
     {9.9999999747524187e-7, 9.9999999747524271e-7, 9.9999999747524271e-7, 4.9999999873762135e-7,
      4.5942647840076739e-7, 9.1885295680153479e-7}},
    {{60, 20, -30},
     {60.0000001, 20.0000002, -30.0000001},
     {1.3251382779243634e-7, 2.4494897424003682e-7, 1.4375164590013407e-7, 1.1397521214891678e-7,
      1.2593709409303063e-7, 1.4532973062312728e-7}},
    {{50, 40, 30},
     {55, -20, -15},
     {43.547583315023678, 75.166481891864541, 41.43458288504454, 42.313349550384337,
      57.756629709332989, 57.893511960668977}},
};

TEST(Differences, AgreeWithFortyDigits) {
  for (const Golden& golden : kGolden) {
    for (std::size_t i = 0; i < 6; ++i) {
      const DifferenceFormula& formula = kDifferenceFormulas.at(i);
      SCOPED_TRACE(testing::Message() << formula.name << " " << golden.reference[1]);
      const double ours = formula.difference(golden.reference, golden.sample, formula.factors);
      // Largest error measured over 700 pairs: 5.7e-16 of the difference.
      EXPECT_LE(std::fabs(ours - golden.differences[i]), 2e-15 * golden.differences[i]);
    }
  }
}

TEST(Differences, AgreeWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  const std::pair<const char*, const char*> columns[] = {
      {"cie76", "dE76"},    {"cie94", "dE94_graphic"}, {"cie94-textiles", "dE94_textile"},
      {"cmc", "dEcmc_2_1"}, {"cmc-1-1", "dEcmc_1_1"},  {"ciede2000", "dE00"}};
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/delta_e.csv")) {
    const Values a{row.number("L1"), row.number("a1"), row.number("b1")};
    const Values b{row.number("L2"), row.number("a2"), row.number("b2")};
    for (const auto& [name, column] : columns) {
      SCOPED_TRACE(row.text("id") + " " + name);
      const double wanted = row.number(column);
      EXPECT_NEAR(parse_difference(name, "")(a, b), wanted, 1e-13 + 1e-15 * wanted);
    }
  }
}

TEST(Differences, HaveNamesOfTheirOwnAndAreZeroForOneColour) {
  std::set<std::string_view> names;
  for (const DifferenceFormula& formula : kDifferenceFormulas) {
    SCOPED_TRACE(formula.name);
    EXPECT_TRUE(names.insert(formula.name).second);
    EXPECT_FALSE(formula.formula.empty() || formula.source.empty());
    EXPECT_EQ(formula.difference({50, 20, -30}, {50, 20, -30}, formula.factors), 0);
    EXPECT_EQ(formula.difference({50, 0, 0}, {50, 0, 0}, formula.factors), 0);
    for (std::size_t i = 0; i < 3; ++i) {
      Values odd{50, 20, -30};
      odd[i] = std::nan("");
      EXPECT_TRUE(std::isnan(formula.difference(odd, {50, 20, -30}, formula.factors)));
      EXPECT_TRUE(std::isnan(formula.difference({50, 20, -30}, odd, formula.factors)));
    }
  }
}

RC_GTEST_PROP(Differences, AreSymmetricWhereTheySaySo, ()) {
  const Lab a = any_lab();
  const Lab b = any_lab();
  for (const DifferenceFormula& formula : kDifferenceFormulas) {
    const double forth = formula.difference({a.l, a.a, a.b}, {b.l, b.a, b.b}, formula.factors);
    const double back = formula.difference({b.l, b.a, b.b}, {a.l, a.a, a.b}, formula.factors);
    RC_ASSERT(forth >= 0);
    if (formula.symmetric) {
      RC_ASSERT(forth == back);
    }
  }
}

TEST(Differences, DivideByTheirFactors) {
  // At mean L* 50 and without chroma only the factor of the lightness is left.
  EXPECT_DOUBLE_EQ(ciede2000({49, 0, 0}, {51, 0, 0}, {2, 1, 1}), 1);
  EXPECT_DOUBLE_EQ(cie94({49, 0, 0}, {51, 0, 0}, {}, {4, 1, 1}), 0.5);
  EXPECT_EQ(cmc({40, 9, 9}, {50, 9, 9}, {4, 1, 1}), cmc({40, 9, 9}, {50, 9, 9}) / 2);
}

// [Clarke84]: T has another form from 164 to 345 degrees, both ends included.
TEST(Cmc, ChangesItsHueWeightAtTheAnglesOfTheStandard) {
  const auto weight = [](double degrees) {
    const double h = degrees * M_PI / 180;
    const Lab reference{50, 40 * std::cos(h), 40 * std::sin(h)};
    const Lab turned{50, 40 * std::cos(h + 1e-3), 40 * std::sin(h + 1e-3)};
    return 0.04 / cmc(reference, turned, {});  // near 1/SH
  };
  const auto sh = [](double t) {
    const double f = std::sqrt(std::pow(40, 4) / (std::pow(40, 4) + 1900));
    return (0.0638 * 40 / (1 + 0.0131 * 40) + 0.638) * (f * t + 1 - f);
  };
  const auto cosine = [](double degrees) { return std::fabs(std::cos(degrees * M_PI / 180)); };
  for (const double degrees : {0.0, 90.0, 163.9, 345.1, 359.0}) {
    EXPECT_NEAR(weight(degrees), sh(0.36 + 0.4 * cosine(degrees + 35)), 1e-5) << degrees;
  }
  for (const double degrees : {164.1, 200.0, 270.0, 344.9}) {
    EXPECT_NEAR(weight(degrees), sh(0.56 + 0.2 * cosine(degrees + 168)), 1e-5) << degrees;
  }
}

// [Sharma05 eq 17] has no bump at hues just beyond 360 degrees, although 275 is near.
TEST(Ciede2000, RotatesNoReds) {
  const double beyond = ciede2000({50, 60, 4}, {50, 70, 8});
  EXPECT_NEAR(beyond, 2.9682916456054893, 1e-13);
}

TEST(ParseDifference, TakesNamesAndFactors) {
  EXPECT_EQ(parse_difference("CIEDE2000", "").formula->name, "ciede2000");
  EXPECT_EQ(parse_difference("cmc", "").factors, (DifferenceFactors{2, 1, 1}));
  EXPECT_EQ(parse_difference("cmc:1.5:3", "").factors, (DifferenceFactors{1.5, 3, 1}));
  EXPECT_EQ(parse_difference("cie94:1:2:3", "").factors, (DifferenceFactors{1, 2, 3}));
}

TEST(ParseDifference, RefusesWhatItDoesNotKnow) {
  const auto text = [](const char* name) {
    return error_text([&] { parse_difference(name, "--difference"); });
  };
  EXPECT_EQ(text("ciede2001"),
            "2 --difference: unknown difference 'ciede2001'; did you mean ciede2000?");
  EXPECT_EQ(text("cmc:0"), "2 --difference: 'cmc:0' has wrong factors; give cmc:L:C, each above 0");
  EXPECT_EQ(text("cmc:1:1:1"),
            "2 --difference: 'cmc:1:1:1' has wrong factors; give cmc:L:C, each above 0");
  EXPECT_EQ(text("cie94:x"),
            "2 --difference: 'cie94:x' has wrong factors; give cie94:L:C:H, each above 0");
  EXPECT_EQ(text("ok:2"), "2 --difference: 'ok:2' has wrong factors; ok has none");
}

}  // namespace
}  // namespace tristim
