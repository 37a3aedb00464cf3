#include "tristim/core/text.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <clocale>
#include <cmath>
#include <limits>

namespace tristim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Shortest, WritesNoMoreDigitsThanNeeded) {
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(1e30), "1e+30");
  EXPECT_EQ(shortest(100), "100");
  EXPECT_EQ(shortest(-0.0), "-0");
  EXPECT_EQ(shortest(1.0 / 3), "0.3333333333333333");
  EXPECT_EQ(shortest(kInfinity), "inf");
  EXPECT_EQ(shortest(-kInfinity), "-inf");
  EXPECT_EQ(shortest(std::copysign(std::numeric_limits<double>::quiet_NaN(), -1)), "nan");
}

RC_GTEST_PROP(Shortest, ReadsBackAsTheSameBits, (std::uint64_t bits)) {
  const auto value = std::bit_cast<double>(bits);
  RC_PRE(!std::isnan(value));
  const auto back = parse_number(shortest(value));
  RC_ASSERT(back.has_value());
  RC_ASSERT(std::bit_cast<std::uint64_t>(*back) == bits);
}

TEST(Rounded, KeepsTheDigitsAskedFor) {
  EXPECT_EQ(rounded(1.0 / 3, 4), "0.3333");
  EXPECT_EQ(rounded(2, 8), "2");
  EXPECT_EQ(rounded(0.5, 3), "0.5");
  EXPECT_EQ(rounded(123456, 3), "1.23e+05");
  EXPECT_EQ(rounded(std::nan(""), 3), "nan");
}

TEST(ParseNumber, TakesDecimalNumbers) {
  EXPECT_EQ(parse_number("1.5"), 1.5);
  EXPECT_EQ(parse_number("+1.5"), 1.5);
  EXPECT_EQ(parse_number("-2e-3"), -2e-3);
  EXPECT_EQ(parse_number(".5"), 0.5);
  EXPECT_EQ(parse_number("5."), 5);
  EXPECT_EQ(parse_number("inf"), kInfinity);
  EXPECT_EQ(parse_number("+inf"), kInfinity);
  EXPECT_EQ(parse_number("-inf"), -kInfinity);
  ASSERT_TRUE(parse_number("nan"));
  EXPECT_TRUE(std::isnan(*parse_number("nan")));
}

TEST(ParseNumber, RefusesWhatIsNotWhollyANumber) {
  for (const char* text : {"", "+", "-", "+-1", "-+1", "++1", " 1", "1 ", "1,5", "0x10", "1e", "e1",
                           "1.2.3", "one", "1e999", "--1", "."}) {
    EXPECT_FALSE(parse_number(text)) << "'" << text << "'";
  }
  EXPECT_FALSE(parse_number(std::string_view("1\0", 2)));
}

TEST(ParseInteger, TakesWholeNumbersThatFit) {
  EXPECT_EQ(parse_integer("42"), 42);
  EXPECT_EQ(parse_integer("+42"), 42);
  EXPECT_EQ(parse_integer("-7"), -7);
  EXPECT_EQ(parse_integer("9223372036854775807"), std::numeric_limits<long long>::max());
  EXPECT_EQ(parse_integer("-9223372036854775808"), std::numeric_limits<long long>::min());
  for (const char* text : {"9223372036854775808", "1.0", "1e3", "", "+", "+-1", "0x1", "1 "}) {
    EXPECT_FALSE(parse_integer(text)) << "'" << text << "'";
  }
}

TEST(Numbers, DoNotDependOnTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  const char* comma = nullptr;
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8"}) {
    if (comma == nullptr) comma = std::setlocale(LC_ALL, name);
  }
  const bool present = comma != nullptr;
  const std::string written = shortest(1.5) + " " + rounded(2.25, 3);
  const auto read = parse_number("1.5");
  const auto with_comma = parse_number("1,5");
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_EQ(written, "1.5 2.25");
  EXPECT_EQ(read, 1.5);
  EXPECT_FALSE(with_comma);
  if (!present) GTEST_SKIP() << "no locale with a decimal comma is installed";
}

TEST(Split, KeepsEmptyParts) {
  using Parts = std::vector<std::string_view>;
  EXPECT_EQ(split("a,b,c", ','), (Parts{"a", "b", "c"}));
  EXPECT_EQ(split("", ','), Parts{""});
  EXPECT_EQ(split(",a,,", ','), (Parts{"", "a", "", ""}));
  EXPECT_EQ(split("a,b", ';'), Parts{"a,b"});
}

RC_GTEST_PROP(Split, JoinedAgainGivesTheText, (std::string text)) {
  std::string joined;
  for (const std::string_view part : split(text, 'a')) (joined += part) += 'a';
  joined.pop_back();
  RC_ASSERT(joined == text);
}

TEST(WithoutUtf8Mark, TakesOneAwayInFront) {
  EXPECT_EQ(without_utf8_mark("\xef\xbb\xbfred"), "red");
  EXPECT_EQ(without_utf8_mark("red"), "red");
  EXPECT_EQ(without_utf8_mark("\xef\xbb"), "\xef\xbb");
  EXPECT_EQ(without_utf8_mark(""), "");
}

}  // namespace
}  // namespace tristim
