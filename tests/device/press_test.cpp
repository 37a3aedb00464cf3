#include "tristim/device/press.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/error_text.h"
#include "tristim/device/display_file.h"

namespace tristim {
namespace {

using Areas = std::vector<double>;

Press offset() { return *load_display("offset-cmyk").press; }

Areas areas(const Press& press, const Rgb& light, bool relative = true) {
  Areas inks(press.inks.size());
  Separation(press, relative).areas(light, inks);
  return inks;
}

// What picture light stands for on the sheet.
Rgb wanted(const Press& press, const Rgb& light) {
  const Rgb black = darkest_print(press);
  return {black.r + (1 - black.r) * light.r, black.g + (1 - black.g) * light.g,
          black.b + (1 - black.b) * light.b};
}

double distance(const Rgb& a, const Rgb& b) {
  return std::max({std::fabs(a.r - b.r), std::fabs(a.g - b.g), std::fabs(a.b - b.b)});
}

Press ideal(std::vector<std::string> names) {
  Press press;
  for (const std::string& name : names) {
    const double none = 1e-3;
    Rgb light{none, none, none};
    if (name == "cyan") light = {none, 1, 1};
    if (name == "magenta") light = {1, none, 1};
    if (name == "yellow") light = {1, 1, none};
    press.inks.push_back({name, light});
  }
  return press;
}

TEST(PrintedLight, MultipliesWhatInksLetThrough) {
  const std::vector<Ink> inks{{"a", {0.2, 1, 0.5}}, {"b", {1, 0.4, 0.5}}};
  EXPECT_EQ(printed_light(inks, Areas{0, 0}), (Rgb{1, 1, 1}));
  EXPECT_LT(distance(printed_light(inks, Areas{1, 0}), {0.2, 1, 0.5}), 1e-15);
  EXPECT_LT(distance(printed_light(inks, Areas{1, 1}), {0.2, 0.4, 0.25}), 1e-15);
  // [Neugebauer37]: half of each covers a quarter with both, a quarter with each, a quarter not.
  const Rgb half = printed_light(inks, Areas{0.5, 0.5});
  EXPECT_NEAR(half.b, (1 + 0.5 + 0.5 + 0.25) / 4, 1e-15);
}

TEST(Separation, PrintsGreysWithTheRightLight) {
  for (const double replacement : {1.0, 0.8, 0.3, 0.0}) {
    Press press = offset();
    press.black.replacement = replacement;
    press.black.limit = 4;
    for (int i = 4; i <= 20; ++i) {
      const double grey = i / 20.0;
      const Areas inks = areas(press, {grey, grey, grey});
      EXPECT_LT(distance(printed_light(press.inks, inks), wanted(press, {grey, grey, grey})), 1e-6)
          << replacement << " " << grey;
    }
  }
}

TEST(Separation, PrintsWhatItsInksHaveMixed) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> area(0, 1);
  Press press = offset();
  press.black = {0, 4};
  for (int i = 0; i < 500; ++i) {
    const Areas mixed{area(random), area(random), area(random), 0};
    const Rgb seen = printed_light(press.inks, mixed);
    const Rgb black = darkest_print(press);
    const Rgb light{(seen.r - black.r) / (1 - black.r), (seen.g - black.g) / (1 - black.g),
                    (seen.b - black.b) / (1 - black.b)};
    if (std::min({light.r, light.g, light.b}) < 0) continue;  // darker than black: not asked for
    const Areas inks = areas(press, light);
    EXPECT_LT(distance(printed_light(press.inks, inks), seen), 1e-5) << i;
  }
}

// Whatever the share of black and within whatever sum of inks, all that four inks can mix comes out
// again, if with other areas.
TEST(Separation, PrintsWhatItsFourInksHaveMixed) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-0.4, 1.4);  // many bare and solid ones
  double worst = 0;
  for (const Press& inks : {offset(), ideal({"cyan", "magenta", "yellow", "black"})}) {
    const Rgb black = darkest_print(inks);
    for (const double limit : {4.0, 3.3, 2.6}) {
      for (const double replacement : {1.0, 0.8, 0.5, 0.2, 0.0}) {
        Press press = inks;
        press.black = {replacement, limit};
        const Separation separation(press);
        for (int i = 0; i < 2000; ++i) {
          Areas mixed(4);
          for (double& area : mixed) area = std::clamp(any(random), 0.0, 1.0);
          const Rgb seen = printed_light(press.inks, mixed);
          const Rgb light{(seen.r - black.r) / (1 - black.r), (seen.g - black.g) / (1 - black.g),
                          (seen.b - black.b) / (1 - black.b)};
          if (std::min({light.r, light.g, light.b}) < 0) continue;  // darker than asked for
          if (mixed[0] + mixed[1] + mixed[2] + mixed[3] > limit) continue;
          Areas found(4);
          separation.areas(light, found);
          worst = std::max(worst, distance(printed_light(press.inks, found), seen));
          ASSERT_LE(found[0] + found[1] + found[2] + found[3], limit + 1e-12);
        }
      }
    }
  }
  EXPECT_LT(worst, 1e-5);  // largest measured: 3e-6
}

double squares(const Rgb& a, const Rgb& b) {
  return (a.r - b.r) * (a.r - b.r) + (a.g - b.g) * (a.g - b.g) + (a.b - b.b) * (a.b - b.b);
}

// Nothing that inks mix is as pure as light of one channel: no ink more or less comes nearer.
TEST(Separation, ComesNearToWhatItsInksCannotMix) {
  const Press press = offset();
  for (const Rgb& light : {Rgb{1, 0, 0}, Rgb{0, 1, 0}, Rgb{0, 0, 1}, Rgb{1, 1, 0}, Rgb{0, 1, 1}}) {
    const Areas inks = areas(press, light);
    const Rgb aim = wanted(press, light);
    const double off = squares(printed_light(press.inks, inks), aim);
    EXPECT_GT(off, 1e-3);
    for (std::size_t i = 0; i < inks.size(); ++i) {
      for (const double change : {-0.02, 0.02}) {
        Areas other = inks;
        other[i] = std::clamp(other[i] + change, 0.0, 1.0);
        EXPECT_LE(off, squares(printed_light(press.inks, other), aim) + 1e-9) << i;
      }
    }
  }
}

TEST(Separation, BlackTakesGreysAloneWhereItReplacesAll) {
  Press press = offset();
  press.black.replacement = 1;
  const Areas inks = areas(press, {0.25, 0.25, 0.25});
  EXPECT_NEAR(inks[3], 0.75, 1e-9);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(inks[i], 0, 1e-6);
  EXPECT_EQ(areas(press, {1, 1, 1}), (Areas{0, 0, 0, 0}));
  EXPECT_EQ(areas(press, {0, 0, 0})[3], 1);
}

TEST(Separation, FollowsTheNamedFormulasForIdealInks) {
  Press press = ideal({"black", "yellow", "magenta", "cyan"});  // any order
  press.black.replacement = 0.5;
  const Rgb light{0.2, 0.5, 0.9};
  press.rule = SeparationRule::kSubtract;
  const Areas subtract = areas(press, light);
  EXPECT_NEAR(subtract[0], 0.05, 1e-15);
  EXPECT_NEAR(subtract[1], 0.05, 1e-15);
  EXPECT_NEAR(subtract[2], 0.45, 1e-15);
  EXPECT_NEAR(subtract[3], 0.75, 1e-15);
  press.rule = SeparationRule::kNormalised;
  EXPECT_NEAR(areas(press, light)[3], 0.75 / 0.95, 1e-15);
}

TEST(Separation, KeepsTheInkLimit) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> channel(0, 1);
  Press press = offset();
  for (const NamedSeparation& rule : kSeparations) {
    press.rule = rule.rule;
    press.black = {0.2, 2.4};
    for (int i = 0; i < 300; ++i) {
      const Areas inks = areas(press, {channel(random), channel(random), channel(random)});
      double sum = 0;
      for (const double ink : inks) {
        EXPECT_GE(ink, 0);
        EXPECT_LE(ink, 1);
        sum += ink;
      }
      EXPECT_LE(sum, 2.4 + 1e-12) << rule.name;
    }
  }
}

TEST(Separation, OneInkHasOneScale) {
  const Press press = ideal({"black"});
  EXPECT_NEAR(areas(press, {0.3, 0.3, 0.3})[0], 0.7, 1e-12);
  EXPECT_NEAR(areas(press, {0, 0, 0})[0], 1, 1e-12);
}

TEST(Separation, KnowsProcessInksOnly) {
  EXPECT_EQ(error_text([] {
              Separation(ideal({"cyan", "red"}));
            }),
            "invalid: press: inks cyan, red; expected one, or cyan, magenta and yellow with black "
            "or without");
  EXPECT_EQ(areas(ideal({"cyan", "magenta", "yellow"}), {0, 0, 0}), (Areas{1, 1, 1}));
}

}  // namespace
}  // namespace tristim
