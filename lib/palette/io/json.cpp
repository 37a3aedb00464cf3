#include <nlohmann/json.hpp>

#include "lib/palette/io/formats.h"
#include "lib/palette/io/text_rows.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void fail(const std::string& file, std::size_t entry, std::string_view wrong,
                       std::string_view remedy) {
  throw Error(ErrorKind::kContent, file + ", colour " + std::to_string(entry), wrong, remedy);
}

// Three channels, and alpha: integers from 0 to 255 or numbers, in sRGB.
void read_channels(const Json& array, PaletteColor& color, const std::string& file,
                   std::size_t entry) {
  constexpr std::string_view kRemedy = "write [r, g, b] of integers 0..255 or numbers 0.0..1.0";
  if (!array.is_array() || array.size() < 3 || array.size() > 4) {
    fail(file, entry, "is no array of three channels", kRemedy);
  }
  std::array<double, 4> values{0, 0, 0, 1};
  bool integers = true;
  for (std::size_t i = 0; i < array.size(); ++i) {
    if (!array[i].is_number()) fail(file, entry, "has a channel that is no number", kRemedy);
    values[i] = array[i].get<double>();
    integers = integers && array[i].is_number_integer();
    if (!(values[i] >= -255 && values[i] <= 255)) {
      fail(file, entry, "has a channel that is out of range", kRemedy);
    }
  }
  const double scale = integers ? 255 : 1;
  color.color = {values[0] / scale, values[1] / scale, values[2] / scale};
  if (array.size() == 4) color.alpha = values[3] / scale;
}

void read_word(const Json& json, PaletteColor& color, const std::string& file, std::size_t entry) {
  const auto* word = json.get_ptr<const std::string*>();
  const auto parsed = word != nullptr ? color_of_word(*word) : std::nullopt;
  if (!parsed) fail(file, entry, "is no colour", "write \"#rrggbb\" or {\"rgb\": [r, g, b]}");
  color = *parsed;
}

// {"rgb": ..., "hex": ..., "alpha": ..., "code": ..., "name": ...}
PaletteColor read_object(const Json& json, const std::string& file, std::size_t entry) {
  PaletteColor color;
  if (json.contains("rgb")) {
    read_channels(json["rgb"], color, file, entry);
  } else {
    read_word(json.contains("hex") ? json["hex"] : Json(), color, file, entry);
  }
  if (json.contains("name") && json["name"].is_string()) {
    color.name = one_line_name(json["name"].get<std::string>());
  }
  if (json.contains("alpha")) {
    const Json& alpha = json["alpha"];
    color.alpha = alpha.is_number() ? alpha.get<double>() : -1;
  }
  if (json.contains("code") && !json["code"].is_null()) {
    const Json& code = json["code"];
    const bool good = code.is_number_unsigned() && code.get<std::uint64_t>() <= 65535;
    if (!good) fail(file, entry, "has no code", "write an integer from 0 to 65535");
    color.code = code.get<std::uint16_t>();
  }
  return color;
}

PaletteColor read_entry(const Json& json, const std::string& file, std::size_t entry) {
  PaletteColor color;
  if (json.is_object()) {
    color = read_object(json, file, entry);
  } else if (json.is_array()) {
    read_channels(json, color, file, entry);
  } else {
    read_word(json, color, file, entry);
  }
  if (!(color.alpha >= 0 && color.alpha <= 1)) {
    fail(file, entry, "has an alpha that is out of range", "write a number from 0 to 1");
  }
  return color;
}

Json parsed(std::string_view bytes, const std::string& file) {
  bytes = without_utf8_mark(bytes);
  try {
    return Json::parse(bytes);
  } catch (const Json::parse_error& error) {
    throw Error(ErrorKind::kContent, file + ", byte " + std::to_string(error.byte),
                "is not valid JSON");
  } catch (const Json::exception&) {
    throw Error(ErrorKind::kContent, file, "has a number that is too large");
  }
}

}  // namespace

// {"name": ..., "colors": [...]} or the list alone.
Palette read_json(std::string_view bytes, const std::string& file) {
  const Json json = parsed(bytes, file);
  Palette palette;
  if (json.is_object() && json.contains("name") && json["name"].is_string()) {
    palette.name = one_line_name(json["name"].get<std::string>());
  }
  const bool object = json.is_object() && json.contains("colors");
  const Json& colors = object ? json["colors"] : json;
  if (!colors.is_array()) {
    throw Error(ErrorKind::kContent, file, "has no list of colours",
                "write {\"colors\": [\"#rrggbb\", ...]}");
  }
  for (const Json& entry : colors) {
    palette.colors.push_back(read_entry(entry, file, palette.colors.size()));
  }
  return palette;
}

std::string write_json(const Palette& palette) {
  const auto text = [](const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  };
  std::string out = "{\"name\": " + text(palette.name) + ",\n \"colors\": [\n";
  for (std::size_t i = 0; i < palette.colors.size(); ++i) {
    const PaletteColor& entry = palette.colors[i];
    const EncodedRgb& c = entry.color;
    Json json{{"hex", hex_text(c)}};
    const auto [r, g, b] = color_codes8(c);
    json["rgb"] = is_8_bits(c) ? Json{r, g, b} : Json{c.r, c.g, c.b};
    if (entry.alpha < 1) json["alpha"] = entry.alpha;
    if (entry.code) json["code"] = *entry.code;
    if (!entry.name.empty()) json["name"] = entry.name;
    out += "  " + text(json) + (i + 1 < palette.colors.size() ? ",\n" : "\n");
  }
  return out + "]}\n";
}

}  // namespace tristim::detail
