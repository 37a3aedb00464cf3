#include "tristim/core/find.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <string>

namespace tristim {
namespace {

struct Item {
  std::string_view name;
};
constexpr std::array kItems{Item{"floyd-steinberg"}, Item{"bayer8"}, Item{"bayer16"}, Item{"d2"}};

// Letters of both cases, the marks that do not count, and one that does.
rc::Gen<std::string> names() {
  return rc::gen::container<std::string>(rc::gen::elementOf(std::string("abABzZ_-1 ")));
}

std::string folded(const std::string& name) {
  std::string result;
  for (const char c : name) {
    if (c != '_' && c != '-') result += static_cast<char>(std::tolower(c));
  }
  return result;
}

TEST(SameName, IgnoresCaseUnderscoreAndHyphen) {
  EXPECT_TRUE(same_name("NTSC_1953", "ntsc1953"));
  EXPECT_TRUE(same_name("Floyd-Steinberg", "floyd_steinberg"));
  EXPECT_TRUE(same_name("-a-", "A"));
  EXPECT_TRUE(same_name("", "_-"));
  EXPECT_FALSE(same_name("a b", "ab"));
  EXPECT_FALSE(same_name("ab", "abc"));
  EXPECT_FALSE(same_name("abc", "ab"));
  EXPECT_FALSE(same_name("\xc3\x84", "\xc3\xa4"));  // letters of ASCII alone
}

RC_GTEST_PROP(SameName, IsEqualityAfterFolding, ()) {
  const std::string a = *names();
  const std::string b = *names();
  RC_ASSERT(same_name(a, b) == (folded(a) == folded(b)));
  RC_ASSERT(same_name(a, "-" + folded(a) + "_"));
}

TEST(NameDistance, CountsEdits) {
  EXPECT_EQ(name_distance("kitten", "sitting"), 3U);  // [Levenshtein66]'s usual example
  EXPECT_EQ(name_distance("", "abc"), 3U);
  EXPECT_EQ(name_distance("abc", ""), 3U);
  EXPECT_EQ(name_distance("Bayer-8", "bayer_8"), 0U);
  EXPECT_EQ(name_distance("bayer8", "bayer16"), 2U);
}

RC_GTEST_PROP(NameDistance, IsAMetric, ()) {
  const std::string a = *names();
  const std::string b = *names();
  const std::string c = *names();
  RC_ASSERT(name_distance(a, b) == name_distance(b, a));
  RC_ASSERT((name_distance(a, b) == 0) == same_name(a, b));
  RC_ASSERT(name_distance(a, c) <= name_distance(a, b) + name_distance(b, c));
}

TEST(FindByName, FindsTheMemberOrNothing) {
  EXPECT_EQ(find_by_name(kItems, "BAYER_8"), &kItems[1]);
  EXPECT_EQ(find_by_name(kItems, "bayer"), nullptr);
  EXPECT_EQ(find_by_name(kItems, ""), nullptr);
}

TEST(ListNames, JoinsThemInTheirOrder) {
  EXPECT_EQ(list_names(kItems), "floyd-steinberg, bayer8, bayer16, d2");
  EXPECT_EQ(list_names(kItems, "|"), "floyd-steinberg|bayer8|bayer16|d2");
  EXPECT_EQ(list_names(std::array<Item, 0>{}), "");
}

TEST(CommonStart, CountsFoldedCharacters) {
  EXPECT_EQ(common_start("Bayer-8", "bayer16"), 5U);
  EXPECT_EQ(common_start("a-b", "AB"), 2U);
  EXPECT_EQ(common_start("", "ab"), 0U);
}

TEST(NameContains, FindsFoldedPartsOfTwoCharactersOrMore) {
  EXPECT_TRUE(name_contains("floyd-steinberg", "DSTEIN"));
  EXPECT_FALSE(name_contains("floyd-steinberg", "f"));
  EXPECT_FALSE(name_contains("floyd-steinberg", "-"));
  EXPECT_FALSE(name_contains("ab", "abc"));
}

TEST(NameHint, OffersTheNearestOfSeveral) {
  EXPECT_EQ(name_hint(kItems, "floyd-steinburg"), "did you mean floyd-steinberg?");
  EXPECT_EQ(name_hint(kItems, "bayer9"), "did you mean bayer8?");
  EXPECT_EQ(name_hint(kItems, "bayer"), "did you mean bayer8?");  // one letter away
}

TEST(NameHint, OffersOfEquallyNearOnesThatWithTheLongestStart) {
  constexpr std::array kLike{Item{"cat"}, Item{"bar"}, Item{"car"}};
  EXPECT_EQ(name_hint(kLike, "caw"), "did you mean cat?");  // before car: the first of equals
  EXPECT_EQ(name_hint(kLike, "baw"), "did you mean bar?");
}

TEST(NameHint, OffersTheOnlyOneThatContainsTheName) {
  EXPECT_EQ(name_hint(kItems, "floyd"), "did you mean floyd-steinberg?");
  EXPECT_EQ(name_hint(kItems, "16"), "did you mean bayer16?");
}

TEST(NameHint, ListsTheChoicesWhereNoneIsNear) {
  const std::string all = "use one of: floyd-steinberg, bayer8, bayer16, d2";
  EXPECT_EQ(name_hint(kItems, "xyzzyx"), all);
  EXPECT_EQ(name_hint(kItems, ""), all);
  EXPECT_EQ(name_hint(kItems, "dd"), "did you mean d2?");  // half of the letters
  EXPECT_EQ(name_hint(kItems, "x"), all);
}

}  // namespace
}  // namespace tristim
