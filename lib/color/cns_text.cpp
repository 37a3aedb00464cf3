#include <algorithm>
#include <array>
#include <iterator>

#include "lib/color/name_text.h"
#include "tristim/color/cns.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

// The place of a list's name at the beginning of `text`, of the longest one; it is cut off.
template <std::size_t N>
std::optional<int> take(std::string_view& text, const std::string_view (&list)[N]) {
  for (std::size_t i = 0; i < N; ++i) {
    if (!text.starts_with(list[i])) continue;
    const std::string_view rest = text.substr(list[i].size());
    if (!rest.empty() && rest[0] != ' ') continue;
    text = rest.empty() ? rest : rest.substr(1);
    return static_cast<int>(i);
  }
  return std::nullopt;
}

template <std::size_t N>
std::string words_of(const std::string_view (&list)[N]) {
  std::string words;
  for (const std::string_view word : list) words += (words.empty() ? "" : ", ") + std::string(word);
  return words;
}

std::optional<int> hue_by_name(std::string_view name) {
  const auto hues = cns_hues();
  const auto found =
      std::find_if(hues.begin(), hues.end(), [&](const CnsHue& hue) { return hue.name == name; });
  if (found == hues.end()) return std::nullopt;
  return static_cast<int>(found - hues.begin());
}

// Also "orange-red" for "red-orange", and "yellowish-green" for "yellowish green".
std::optional<int> parse_hue(std::string_view text) {
  if (const auto hue = hue_by_name(text)) return hue;
  const std::size_t hyphen = text.find('-');
  if (hyphen == std::string_view::npos) return std::nullopt;
  const std::string first(text.substr(0, hyphen));
  const std::string second(text.substr(hyphen + 1));
  return hue_by_name(first.ends_with("ish") ? first + " " + second : second + "-" + first);
}

std::optional<CnsName> parse_gray(std::string_view text, std::optional<int> lightness) {
  if (text == "gray") return CnsName{lightness.value_or(2), 0, std::nullopt};
  if (lightness) return std::nullopt;
  if (text == "black") return CnsName{-1, 0, std::nullopt};
  if (text == "white") return CnsName{5, 0, std::nullopt};
  return std::nullopt;
}

}  // namespace

std::optional<CnsName> parse_cns(std::string_view text) {
  const std::string name = detail::normal_name(text);
  std::string_view rest = name;
  const auto lightness = take(rest, kCnsLightness);
  if (const auto gray = parse_gray(rest, lightness)) return gray;
  const auto saturation = take(rest, kCnsSaturation);
  const auto hue = parse_hue(rest);
  if (!hue) return std::nullopt;
  return CnsName{lightness.value_or(2), saturation.value_or(3), hue};
}

std::string cns_text(const CnsName& name) {
  if (!name.hue && name.lightness < 0) return "black";
  if (!name.hue && name.lightness > 4) return "white";
  std::string text;
  if (name.lightness != 2) {
    text += std::string(kCnsLightness[static_cast<std::size_t>(name.lightness)]) + " ";
  }
  if (!name.hue) return text + "gray";
  text += std::string(kCnsSaturation[static_cast<std::size_t>(name.saturation)]) + " ";
  return text + std::string(cns_hues()[static_cast<std::size_t>(*name.hue)].name);
}

std::string cns_hint(std::string_view text) {
  const std::string name = detail::normal_name(text);
  std::string_view rest = name;
  std::string start;
  if (const auto lightness = take(rest, kCnsLightness)) {
    start += std::string(kCnsLightness[static_cast<std::size_t>(*lightness)]) + " ";
  }
  if (const auto saturation = take(rest, kCnsSaturation)) {
    start += std::string(kCnsSaturation[static_cast<std::size_t>(*saturation)]) + " ";
  }
  const std::string hint = name_hint(cns_hues(), rest);
  if (hint.starts_with("did you mean ")) {
    return "did you mean " + start + hint.substr(std::string_view("did you mean ").size());
  }
  return "give a lightness (" + words_of(kCnsLightness) + "), a saturation (" +
         words_of(kCnsSaturation) + ") and a hue of neighbours, such as 'light vivid purplish red'";
}

}  // namespace tristim
