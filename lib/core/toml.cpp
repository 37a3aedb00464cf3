#include "lib/core/toml.h"

#include <toml++/toml.h>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "tristim/core/error.h"
#include "tristim/core/find.h"

namespace tristim::detail {
namespace {

struct Key {
  std::string name;
};

std::string place(const std::string& file, const toml::source_position& at) {
  return file + ":" + std::to_string(at.line) + ":" + std::to_string(at.column);
}

bool known(const std::vector<Key>& keys, std::string_view name) {
  return std::any_of(keys.begin(), keys.end(), [&](const Key& k) { return k.name == name; });
}

}  // namespace

struct TomlTable::State {
  std::shared_ptr<const toml::table> root;  // keeps `table` alive
  const toml::table* table;
  std::string file;
  std::vector<Key> asked;

  const toml::node* node(std::string_view key) {
    if (!known(asked, key)) asked.push_back({std::string(key)});
    return table->get(key);
  }
};

TomlTable TomlTable::parse(std::string_view text, const std::string& file) {
  try {
    auto root = std::make_shared<const toml::table>(toml::parse(text, file));
    const toml::table* table = root.get();
    return TomlTable(std::make_shared<State>(State{std::move(root), table, file, {}}));
  } catch (const toml::parse_error& error) {
    throw Error(ErrorKind::kContent, place(file, error.source().begin),
                std::string("not valid TOML: ") + std::string(error.description()));
  }
}

void TomlTable::fail(std::string_view key, std::string_view wrong, std::string_view remedy) const {
  const toml::node* node = state_->table->get(key);
  const toml::source_position at =
      node != nullptr ? node->source().begin : state_->table->source().begin;
  throw Error(ErrorKind::kContent, place(state_->file, at), wrong, remedy);
}

bool TomlTable::has(std::string_view key) const { return state_->node(key) != nullptr; }

bool TomlTable::is_array(std::string_view key) const {
  const toml::node* node = state_->node(key);
  return node != nullptr && node->is_array();
}

bool TomlTable::is_number(std::string_view key) const {
  const toml::node* node = state_->node(key);
  return node != nullptr && node->is_number();
}

bool TomlTable::is_string(std::string_view key) const {
  const toml::node* node = state_->node(key);
  return node != nullptr && node->is_string();
}

std::optional<std::string> TomlTable::string(std::string_view key) const {
  const toml::node* node = state_->node(key);
  if (node == nullptr) return std::nullopt;
  if (const auto value = node->value_exact<std::string>()) return *value;
  fail(key, "'" + std::string(key) + "' must be a string");
}

std::optional<double> TomlTable::number(std::string_view key) const {
  const toml::node* node = state_->node(key);
  if (node == nullptr) return std::nullopt;
  const auto value = node->is_number() ? node->value<double>() : std::nullopt;
  if (!value || !std::isfinite(*value)) {
    fail(key, "'" + std::string(key) + "' must be a finite number");
  }
  return value;
}

std::optional<std::int64_t> TomlTable::integer(std::string_view key) const {
  const toml::node* node = state_->node(key);
  if (node == nullptr) return std::nullopt;
  if (const auto value = node->value_exact<std::int64_t>()) return *value;
  fail(key, "'" + std::string(key) + "' must be an integer");
}

std::optional<bool> TomlTable::boolean(std::string_view key) const {
  const toml::node* node = state_->node(key);
  if (node == nullptr) return std::nullopt;
  if (const auto value = node->value_exact<bool>()) return *value;
  fail(key, "'" + std::string(key) + "' must be true or false");
}

namespace {

std::optional<std::vector<double>> finite_numbers(const toml::array* array) {
  if (array == nullptr) return std::nullopt;
  std::vector<double> values;
  for (const toml::node& item : *array) {
    const auto value = item.is_number() ? item.value<double>() : std::nullopt;
    if (!value || !std::isfinite(*value)) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

}  // namespace

std::optional<std::vector<double>> TomlTable::numbers(std::string_view key) const {
  const toml::node* node = state_->node(key);
  if (node == nullptr) return std::nullopt;
  if (auto values = finite_numbers(node->as_array())) return values;
  fail(key, "'" + std::string(key) + "' must be an array of finite numbers");
}

std::optional<std::vector<std::string>> TomlTable::strings(std::string_view key) const {
  const toml::node* node = state_->node(key);
  if (node == nullptr) return std::nullopt;
  const std::string wrong = "'" + std::string(key) + "' must be an array of strings";
  if (!node->is_array()) fail(key, wrong);
  std::vector<std::string> values;
  for (const toml::node& item : *node->as_array()) {
    const auto value = item.value_exact<std::string>();
    if (!value) fail(key, wrong);
    values.push_back(*value);
  }
  return values;
}

std::optional<std::vector<std::vector<double>>> TomlTable::rows(std::string_view key) const {
  const toml::node* node = state_->node(key);
  if (node == nullptr) return std::nullopt;
  const std::string wrong = "'" + std::string(key) + "' must be an array of arrays of numbers";
  if (!node->is_array()) fail(key, wrong);
  std::vector<std::vector<double>> values;
  for (const toml::node& item : *node->as_array()) {
    auto row = finite_numbers(item.as_array());
    if (!row) fail(key, wrong);
    values.push_back(std::move(*row));
  }
  return values;
}

std::optional<TomlTable> TomlTable::table(std::string_view key) const {
  const toml::node* node = state_->node(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_table()) {
    fail(key, "'" + std::string(key) + "' must be a table", "write [" + std::string(key) + "]");
  }
  return TomlTable(
      std::make_shared<State>(State{state_->root, node->as_table(), state_->file, {}}));
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
  const toml::node* node = state_->node(key);
  if (node == nullptr) return {};
  if (!node->is_array_of_tables()) {
    fail(key, "'" + std::string(key) + "' must be an array of tables",
         "write [[" + std::string(key) + "]]");
  }
  std::vector<TomlTable> all;
  for (const toml::node& item : *node->as_array()) {
    all.push_back(
        TomlTable(std::make_shared<State>(State{state_->root, item.as_table(), state_->file, {}})));
  }
  return all;
}

bool TomlTable::all_integers(std::string_view key) const {
  const toml::node* node = state_->node(key);
  return node != nullptr && node->is_array() &&
         node->as_array()->is_homogeneous(toml::node_type::integer);
}

std::string TomlTable::scalar_text(std::string_view key) const {
  const toml::node* node = state_->node(key);
  if (node == nullptr) fail(key, "'" + std::string(key) + "' is missing");
  if (const auto text = node->value_exact<std::string>()) return *text;
  if (const auto flag = node->value_exact<bool>()) return *flag ? "true" : "false";
  if (!node->is_number())
    fail(key, "'" + std::string(key) + "' must be a string, number or boolean");
  std::ostringstream text;  // toml++ prints numbers without the locale
  text << toml::node_view<const toml::node>(node);
  return text.str();
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::string> names;
  for (const auto& [key, value] : *state_->table) names.emplace_back(key.str());
  return names;
}

void TomlTable::finish() const {
  for (const auto& [key, value] : *state_->table) {
    if (known(state_->asked, key.str())) continue;
    throw Error(ErrorKind::kContent, place(state_->file, key.source().begin),
                "unknown key '" + std::string(key.str()) + "'",
                name_hint(state_->asked, key.str()));
  }
}

}  // namespace tristim::detail
