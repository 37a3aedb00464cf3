#include "tristim/dither/formula.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/error_text.h"

namespace tristim {
namespace {

double value(const char* text, double x = 0, double y = 0) { return Formula(text)(x, y); }

TEST(Formula, FollowsTheRulesOfPrecedence) {
  EXPECT_EQ(value("1 + 2*3"), 7);
  EXPECT_EQ(value("(1 + 2)*3"), 9);
  EXPECT_EQ(value("8 - 3 - 2"), 3);
  EXPECT_EQ(value("8/4/2"), 1);
  EXPECT_EQ(value("2^3^2"), 512);
  EXPECT_EQ(value("-2^2"), -4);
  EXPECT_EQ(value("2^-1"), 0.5);
  EXPECT_EQ(value("- -3"), 3);
  EXPECT_EQ(value("1.5e1 + .5"), 15.5);
}

TEST(Formula, KnowsItsVariablesAndConstants) {
  EXPECT_EQ(value("x - 10*y", 3, 2), -17);
  EXPECT_EQ(value("pi"), 3.14159265358979323846);
  EXPECT_EQ(value("e"), 2.71828182845904523536);
}

TEST(Formula, HasTheFunctionsOfTheList) {
  struct Case {
    const char* text;
    double expected;
  };
  const Case cases[] = {{"sin(1)", std::sin(1.0)},   {"cos(2)", std::cos(2.0)},
                        {"tan(.5)", std::tan(0.5)},  {"atan(2)", std::atan(2.0)},
                        {"sqrt(2)", std::sqrt(2.0)}, {"abs(-3)", 3},
                        {"exp(1.5)", std::exp(1.5)}, {"log(5)", std::log(5.0)},
                        {"floor(-1.5)", -2},         {"atan2(1, -1)", std::atan2(1.0, -1.0)},
                        {"hypot(3, 4)", 5},          {"min(2, -1)", -1},
                        {"max(2, -1)", 2},           {"sin(-100)", std::sin(-100.0)}};
  ASSERT_EQ(std::size(cases), formula_functions().size() + 1);
  for (const Case& c : cases) EXPECT_NEAR(value(c.text), c.expected, 2e-14) << c.text;
}

TEST(Formula, CosineIsEvenToTheLastBit) {
  for (double x = 0; x < 1; x += 0.037) {
    EXPECT_EQ(value("cos(pi*x)", x), value("cos(pi*x)", -x));
    EXPECT_EQ(value("cos(pi*x)+cos(pi*y)", x, 0.3), value("cos(pi*x)+cos(pi*y)", 0.3, -x));
  }
}

TEST(Formula, TellsWhatIsWrongAndWhere) {
  const auto error = [](const std::string& text) { return error_text([&] { Formula{text}; }); };
  EXPECT_EQ(error("cos(pi*x"), "invalid: ')' is missing at character 9 of 'cos(pi*x'");
  EXPECT_EQ(error(""), "invalid: the formula ends at character 1 of ''");
  EXPECT_EQ(error("1 +"), "invalid: the formula ends at character 4 of '1 +'");
  EXPECT_EQ(error("x y"), "invalid: unexpected 'y' at character 3 of 'x y'");
  EXPECT_EQ(error("2 * $"), "invalid: unexpected '$' at character 5 of '2 * $'");
  EXPECT_EQ(error("1..2"), "invalid: '1..2' is no number at character 1 of '1..2'");
  EXPECT_EQ(error("sin x"), "invalid: '(' is missing behind sin at character 5 of 'sin x'");
  EXPECT_EQ(error("min(x)"),
            "invalid: min takes 2 values: ',' is missing at character 6 of 'min(x)'");
  EXPECT_EQ(
      error("z"),
      "invalid: unknown name 'z' (there are x, y, pi, e, sin, cos, tan, atan, sqrt, abs, exp, "
      "log, floor, atan2, hypot, min, max) at character 1 of 'z'");
}

TEST(Formula, RefusesWhatWouldExhaustIt) {
  const auto refused = [](const std::string& text) {
    return error_text([&] { Formula{text}; }).starts_with("invalid: ");
  };
  EXPECT_TRUE(refused(std::string(999, '(')));
  EXPECT_TRUE(refused(std::string(999, '-') + "x"));
  EXPECT_TRUE(refused("x" + std::string(1000, ' ')));
  std::string deep = "x";
  for (int i = 0; i < 15; ++i) deep = "max(x,x+x*x^(" + deep + "))";
  EXPECT_EQ(value(deep.c_str(), 1), 2);  // the stack holds all that the parser lets through
}

}  // namespace
}  // namespace tristim
