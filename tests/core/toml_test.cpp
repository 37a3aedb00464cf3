#include "lib/core/toml.h"

#include <gtest/gtest.h>

#include <locale>

#include "tests/error_text.h"

namespace tristim::detail {
namespace {

TomlTable parsed(std::string_view text) { return TomlTable::parse(text, "a.toml"); }

TEST(TomlTable, ReadsEveryKindOfValue) {
  const TomlTable table = parsed(R"(
text = "panel"
real = 2.5
whole = 3
flag = true
list = [1, 2.5]
names = ["a", "b"]
pairs = [[0, 0.5], [255, 100]]
[inner]
depth = 1
[[entry]]
code = 1
[[entry]]
code = 2
)");
  EXPECT_EQ(table.string("text"), "panel");
  EXPECT_EQ(table.number("real"), 2.5);
  EXPECT_EQ(table.number("whole"), 3);
  EXPECT_EQ(table.integer("whole"), 3);
  EXPECT_EQ(table.boolean("flag"), true);
  EXPECT_EQ(table.numbers("list"), (std::vector<double>{1, 2.5}));
  EXPECT_FALSE(table.all_integers("list"));
  EXPECT_EQ(table.strings("names"), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(table.rows("pairs"), (std::vector<std::vector<double>>{{0, 0.5}, {255, 100}}));
  EXPECT_EQ(table.table("inner")->integer("depth"), 1);
  ASSERT_EQ(table.tables("entry").size(), 2U);
  EXPECT_EQ(table.tables("entry")[1].integer("code"), 2);
  EXPECT_TRUE(table.has("text"));
  EXPECT_TRUE(table.is_array("list"));
  EXPECT_FALSE(table.is_array("text"));
}

TEST(TomlTable, HasNothingAtAbsentKeys) {
  const TomlTable table = parsed("");
  EXPECT_FALSE(table.has("x"));
  EXPECT_FALSE(table.string("x"));
  EXPECT_FALSE(table.number("x"));
  EXPECT_FALSE(table.integer("x"));
  EXPECT_FALSE(table.boolean("x"));
  EXPECT_FALSE(table.numbers("x"));
  EXPECT_FALSE(table.strings("x"));
  EXPECT_FALSE(table.rows("x"));
  EXPECT_FALSE(table.table("x"));
  EXPECT_TRUE(table.tables("x").empty());
}

TEST(TomlTable, NamesUnknownKeysWithPlaceAndHint) {
  const TomlTable table = parsed("name = \"x\"\n  bit_ordr = \"msb\"\n");
  (void)table.string("name");
  (void)table.string("bit_order");
  EXPECT_EQ(error_text([&] { table.finish(); }),
            "3 a.toml:2:3: unknown key 'bit_ordr'; did you mean bit_order?");
  const TomlTable far = parsed("zzz = 1\n");
  (void)far.string("name");
  (void)far.string("bit_order");
  EXPECT_EQ(error_text([&] { far.finish(); }),
            "3 a.toml:1:1: unknown key 'zzz'; use one of: name, bit_order");
}

TEST(TomlTable, AcceptsAllKeysThatWereAskedFor) {
  const TomlTable table = parsed("a = 1\nb = 2\n");
  (void)table.has("a");
  (void)table.is_array("b");
  EXPECT_NO_THROW(table.finish());
}

TEST(TomlTable, FinishesTablesOneByOne) {
  const TomlTable table = parsed("[inner]\ndepth = 1\n");
  const TomlTable inner = *table.table("inner");
  EXPECT_NO_THROW(table.finish());
  EXPECT_THROW(inner.finish(), Error);
}

TEST(TomlTable, RefusesValuesOfAnotherKind) {
  const TomlTable table = parsed("s = \"x\"\nn = 1.5\nb = [1, \"x\"]\nt = [[1], 2]\nf = inf\n");
  const auto text = [&](auto&& action) { return error_text([&] { (void)action(); }); };
  EXPECT_EQ(text([&] { return table.string("n"); }), "3 a.toml:2:5: 'n' must be a string");
  EXPECT_EQ(text([&] { return table.number("s"); }), "3 a.toml:1:5: 's' must be a finite number");
  EXPECT_EQ(text([&] { return table.number("f"); }), "3 a.toml:5:5: 'f' must be a finite number");
  EXPECT_EQ(text([&] { return table.integer("n"); }), "3 a.toml:2:5: 'n' must be an integer");
  EXPECT_EQ(text([&] { return table.boolean("n"); }), "3 a.toml:2:5: 'n' must be true or false");
  EXPECT_EQ(text([&] { return table.numbers("b"); }),
            "3 a.toml:3:5: 'b' must be an array of finite numbers");
  EXPECT_EQ(text([&] { return table.strings("b"); }),
            "3 a.toml:3:5: 'b' must be an array of strings");
  EXPECT_EQ(text([&] { return table.rows("t"); }),
            "3 a.toml:4:5: 't' must be an array of arrays of numbers");
  EXPECT_EQ(text([&] { return table.table("n"); }), "3 a.toml:2:5: 'n' must be a table; write [n]");
  EXPECT_EQ(text([&] { return table.tables("n"); }),
            "3 a.toml:2:5: 'n' must be an array of tables; write [[n]]");
}

TEST(TomlTable, SaysWhereTextIsNoToml) {
  const std::string error = error_text([] { parsed("a = 1\nb = = 2\n"); });
  EXPECT_TRUE(error.starts_with("3 a.toml:2:5: not valid TOML: ")) << error;
  EXPECT_TRUE(error_text([] { parsed("a = 1\na = 2\n"); }).starts_with("3 a.toml:2:"));
}

TEST(TomlTable, FailPointsAtTheValueOrTheTable) {
  const TomlTable table = parsed("a = 1\n[inner]\nb = 2\n");
  const TomlTable inner = *table.table("inner");
  EXPECT_EQ(error_text([&] { inner.fail("b", "is wrong", "mend it"); }),
            "3 a.toml:3:5: is wrong; mend it");
  EXPECT_EQ(error_text([&] { inner.fail("absent", "is wrong"); }), "3 a.toml:2:1: is wrong");
}

struct Comma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(TomlTable, GivesScalarsAsTextInAnyLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale(), new Comma));
  const TomlTable table = parsed("a = 1.5\nb = 90000\nc = true\nd = \"x\"\ne = -2\nf = [1]\n");
  std::string text;
  for (const char* key : {"a", "b", "c", "d", "e"}) text += table.scalar_text(key) + " ";
  std::locale::global(before);
  EXPECT_EQ(text, "1.5 90000 true x -2 ");
  EXPECT_EQ(error_text([&] { (void)table.scalar_text("f"); }),
            "3 a.toml:6:5: 'f' must be a string, number or boolean");
}

TEST(TomlTable, ListsItsKeys) {
  EXPECT_EQ(parsed("b = 1\na = 2\n").keys(), (std::vector<std::string>{"a", "b"}));
}

}  // namespace
}  // namespace tristim::detail
