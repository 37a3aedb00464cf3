#include <array>
#include <charconv>
#include <cmath>

#include "tristim/color/munsell.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

struct Family {
  std::string_view name;
  double begin;  // hue number that its 0 is
};

constexpr Family kFamilies[] = {{"R", 0},   {"YR", 10}, {"Y", 20},  {"GY", 30}, {"G", 40},
                                {"BG", 50}, {"B", 60},  {"PB", 70}, {"P", 80},  {"RP", 90}};

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

std::string without_spaces(std::string_view text) {
  std::string rest;
  for (const char c : text) {
    if (c != ' ' && c != '\t') rest += c;
  }
  return rest;
}

// The parts of "7.5YR5/12": hue, family, value and chroma; the last may be empty or absent.
struct Parts {
  std::string_view hue, family, value, chroma;
  bool slash = false;
};

Parts parts_of(std::string_view text) {
  Parts parts;
  std::size_t letters = 0;
  while (letters < text.size() && !is_letter(text[letters])) ++letters;
  std::size_t end = letters;
  while (end < text.size() && is_letter(text[end])) ++end;
  parts.hue = text.substr(0, letters);
  parts.family = text.substr(letters, end - letters);
  const std::string_view rest = text.substr(end);
  const std::size_t slash = rest.find('/');
  parts.slash = slash != std::string_view::npos;
  parts.value = rest.substr(0, slash);
  if (parts.slash) parts.chroma = rest.substr(slash + 1);
  return parts;
}

std::optional<double> number_between(std::string_view text, double least, double most) {
  const auto number = parse_number(text);
  if (!number || !(*number >= least && *number <= most)) return std::nullopt;
  return number;
}

// The largest finite chroma is the table's business.
constexpr double kAnyChroma = 1e9;

std::optional<Munsell> neutral(const Parts& parts) {
  const auto value = number_between(parts.value, 0, 10);
  if (!value || !parts.hue.empty()) return std::nullopt;
  if (!parts.chroma.empty() && number_between(parts.chroma, 0, 0) != 0.0) return std::nullopt;
  return Munsell{std::nan(""), *value, 0};
}

// The shortest digits without an exponent, whose 'e' would read as a family.
std::string plain(double number) {
  std::array<char, 400> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), number, std::chars_format::fixed);
  return {buffer.data(), end.ptr};
}

double rounded_to(double number, int decimals) {
  if (decimals < 0) return number;
  double scale = 1;
  for (int i = 0; i < decimals; ++i) scale *= 10;
  return std::round(number * scale) / scale;
}

}  // namespace

std::optional<Munsell> parse_munsell(std::string_view text) {
  const std::string notation = without_spaces(text);
  const Parts parts = parts_of(notation);
  if (same_name(parts.family, "N")) return neutral(parts);
  const Family* family = find_by_name(kFamilies, parts.family);
  const auto hue = number_between(parts.hue, 0, 10);
  const auto value = number_between(parts.value, 0, 10);
  const auto chroma = number_between(parts.chroma, 0, kAnyChroma);
  if (family == nullptr || !hue || !value || !chroma) return std::nullopt;
  if (*chroma == 0) return Munsell{std::nan(""), *value, 0};
  const double number = family->begin + *hue;
  return Munsell{number > 0 ? number : 100, *value, *chroma};
}

std::string munsell_hint(std::string_view text) {
  const std::string notation = without_spaces(text);
  const Parts parts = parts_of(notation);
  const bool gray = same_name(parts.family, "N");
  if (!gray && find_by_name(kFamilies, parts.family) == nullptr) {
    return "give hue value/chroma such as '7.5YR 5/12', the hue of " + list_names(kFamilies, " ") +
           ", or 'N 5/'";
  }
  if (gray) return "a gray is N and its value, 0 to 10: 'N 5/'";
  if (!number_between(parts.hue, 0, 10)) {
    return "the hue is a number of 0 to 10 before " + std::string(parts.family);
  }
  if (!number_between(parts.value, 0, 10)) return "the value, before '/', is 0 to 10";
  return "the chroma, behind '/', is a number from 0 on";
}

std::string munsell_notation(Munsell munsell, int decimals) {
  if (std::isnan(munsell.value) || std::isnan(munsell.chroma)) return "none";
  const std::string value = plain(rounded_to(munsell.value, decimals));
  const double chroma = rounded_to(munsell.chroma, decimals);
  if (chroma == 0 || std::isnan(munsell.hue)) return "N " + value + "/";
  double hue = std::fmod(rounded_to(munsell.hue, decimals), 100);
  if (hue <= 0) hue += 100;
  const auto family = static_cast<std::size_t>(std::ceil(hue / 10)) - 1;
  const double within = rounded_to(hue - kFamilies[family].begin, decimals);
  return plain(within) + std::string(kFamilies[family].name) + " " + value + "/" + plain(chroma);
}

}  // namespace tristim
