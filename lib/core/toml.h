#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tristim::detail {

/// A table of a TOML file whose reader asks for keys by name; finish() then refuses the keys that
/// nobody asked for, so that the list of known keys is written only once, in the reading code.
///
/// Every failure is an Error (kContent) "<file>:<line>:<column>: <what is wrong>; <what to do>".
class TomlTable {
 public:
  /// Throws Error where `text` is no TOML. `file` is for messages.
  static TomlTable parse(std::string_view text, const std::string& file);

  bool has(std::string_view key) const;
  bool is_array(std::string_view key) const;
  bool is_number(std::string_view key) const;
  bool is_string(std::string_view key) const;
  std::optional<std::string> string(std::string_view key) const;
  std::optional<double> number(std::string_view key) const;  // finite
  std::optional<std::int64_t> integer(std::string_view key) const;
  std::optional<bool> boolean(std::string_view key) const;
  std::optional<std::vector<double>> numbers(std::string_view key) const;
  std::optional<std::vector<std::string>> strings(std::string_view key) const;
  std::optional<std::vector<std::vector<double>>> rows(
      std::string_view key) const;  // array of arrays
  std::optional<TomlTable> table(std::string_view key) const;
  std::vector<TomlTable> tables(std::string_view key) const;  // [[key]]; empty where absent

  /// Whether every number of the array `key` is written as an integer.
  bool all_integers(std::string_view key) const;

  /// Any scalar as the text it would have on a command line: for tables of options.
  std::string scalar_text(std::string_view key) const;

  /// The keys of this table, in alphabetical order.
  std::vector<std::string> keys() const;

  /// Refuses keys that were never asked for, with the nearest known one.
  void finish() const;

  /// Throws, pointing at the value of `key` (at the table where it has none).
  [[noreturn]] void fail(std::string_view key, std::string_view wrong,
                         std::string_view remedy = {}) const;

 private:
  struct State;
  explicit TomlTable(std::shared_ptr<State> state) : state_(std::move(state)) {}
  std::shared_ptr<State> state_;
};

}  // namespace tristim::detail
