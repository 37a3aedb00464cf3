#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tristim {

/// The shortest decimal text that reads back as `value`, whatever the locale: "0.1", "1e+30",
/// "nan", "inf".
std::string shortest(double value);

/// `value` with `digits` significant digits at the most, without trailing zeros.
std::string rounded(double value, int digits);

/// The number that all of `text` is, in decimal, whatever the locale; "inf", "-inf" and "nan"
/// count. A leading
/// '+' is allowed. Nothing where it is no number.
std::optional<double> parse_number(std::string_view text) noexcept;

/// The integer that all of `text` is, in decimal. Nothing where it is none or does not fit.
std::optional<long long> parse_integer(std::string_view text) noexcept;

/// The parts of `text` between `separator`s; empty parts are kept.
std::vector<std::string_view> split(std::string_view text, char separator);

/// `text` without the mark that some programs put in front of UTF-8 (U+FEFF).
std::string_view without_utf8_mark(std::string_view text) noexcept;

}  // namespace tristim
