#include <algorithm>

#include "lib/color/toml_color.h"
#include "lib/palette/io/formats.h"
#include "lib/palette/io/text_rows.h"
#include "tristim/color/transfer.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

/// What the colours of a file were seen under.
struct Viewing {
  std::optional<Chromaticity> white;
  Adaptation adaptation = Adaptation::kBradford;
};

Viewing read_viewing(const TomlTable& root) {
  Viewing viewing;
  const auto table = root.table("viewing");
  if (!table) return viewing;
  if (table->has("white")) viewing.white = read_white_point(*table, "white");
  if (const auto name = table->string("adapt")) {
    const auto* method = find_by_name(kAdaptations, *name);
    if (method == nullptr) {
      table->fail("adapt", "unknown adapt '" + *name + "'", name_hint(kAdaptations, *name));
    }
    viewing.adaptation = method->method;
  }
  return viewing;
}

// XYZ may be on any scale, so the lightest of the file is 1 where it is beyond.
double scale_of(const std::vector<Xyz>& appearances) {
  double most = 1;
  for (const Xyz& xyz : appearances) most = std::max(most, xyz.y);
  return 1 / most;
}

EncodedRgb color_of_xyz(const Xyz& xyz, double scale, const Viewing& viewing) {
  const Eigen::Matrix3d matrix =
      rgb_from_xyz(Primaries{}) *
      adaptation_matrix(viewing.white.value_or(kD65), kD65, viewing.adaptation);
  const Eigen::Vector3d light = matrix * Eigen::Vector3d(xyz.x, xyz.y, xyz.z) * scale;
  return {srgb_encode(light.x()), srgb_encode(light.y()), srgb_encode(light.z())};
}

PaletteColor read_entry(const TomlTable& entry) {
  PaletteColor color;
  color.name = one_line_name(entry.string("name").value_or(""));
  color.alpha = entry.number("alpha").value_or(1);
  if (!(color.alpha >= 0 && color.alpha <= 1)) {
    entry.fail("alpha", "alpha is out of range", "give a number from 0 to 1");
  }
  if (const auto code = entry.integer("code")) {
    if (*code < 0 || *code > 65535) {
      entry.fail("code", "code " + std::to_string(*code) + " is out of range",
                 "give an integer from 0 to 65535");
    }
    color.code = static_cast<std::uint16_t>(*code);
  }
  return color;
}

std::string number_text(double value) {
  const std::string text = shortest(value);
  const bool integer = text.find_first_of(".e") == std::string::npos;
  return integer ? text + ".0" : text;  // or it would be a code of 8 bits
}

std::string array_text(std::array<double, 3> v) {
  return "[" + number_text(v[0]) + ", " + number_text(v[1]) + ", " + number_text(v[2]) + "]";
}

// The key and the value that say what a colour looks like.
std::string appearance_text(const EncodedRgb& c) {
  if (is_8_bits(c)) {
    const auto [r, g, b] = color_codes8(c);
    return "rgb  = [" + std::to_string(r) + ", " + std::to_string(g) + ", " + std::to_string(b) +
           "]";
  }
  const bool inside = std::min({c.r, c.g, c.b}) >= 0 && std::max({c.r, c.g, c.b}) <= 1;
  if (inside) return "rgb  = " + array_text({c.r, c.g, c.b});
  const Eigen::Vector3d xyz = xyz_from_rgb(Primaries{}) *
                              Eigen::Vector3d(srgb_decode(c.r), srgb_decode(c.g), srgb_decode(c.b));
  return "xyz  = " + array_text({std::max(xyz.x(), 0.0), xyz.y(), std::max(xyz.z(), 0.0)});
}

std::string string_text(const std::string& name) {
  std::string text = "\"";
  for (const char c : one_line_name(name)) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + "\"";
}

}  // namespace

// The name and the [[palette]] of a device file, or of one with nothing else.
Palette read_toml(std::string_view bytes, const std::string& file) {
  const TomlTable root = TomlTable::parse(without_utf8_mark(bytes), file);
  Palette palette;
  palette.name = one_line_name(root.string("name").value_or(""));
  const Viewing viewing = read_viewing(root);
  const std::vector<TomlTable> entries = root.tables("palette");
  std::vector<Xyz> appearances;
  for (const TomlTable& entry : entries) {
    palette.colors.push_back(read_entry(entry));
    appearances.push_back(read_appearance(entry, viewing.white, viewing.adaptation));
    entry.finish();
  }
  const double scale = scale_of(appearances);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    palette.colors[i].color =
        entries[i].has("rgb") ? read_rgb(entries[i]) : color_of_xyz(appearances[i], scale, viewing);
  }
  return palette;
}

// A device file that `process --device` takes as it is.
std::string write_toml(const Palette& palette) {
  std::size_t most = 0;
  for (std::size_t i = 0; i < palette.colors.size(); ++i) {
    most = std::max(most, palette.colors[i].code ? std::size_t{*palette.colors[i].code} : i);
  }
  const int bits = most < 2 ? 1 : most < 4 ? 2 : most < 16 ? 4 : 8;
  std::string text = "name = " + string_text(palette.name) + "\n\n";
  if (most < 256) {
    text += "[frame_buffer]\npacking = \"index" + std::to_string(bits) + "\"\n\n";
  }
  for (std::size_t i = 0; i < palette.colors.size(); ++i) {
    const PaletteColor& entry = palette.colors[i];
    text += "[[palette]]\n";
    if (entry.code) text += "code = " + std::to_string(*entry.code) + "\n";
    text += appearance_text(entry.color) + "\n";
    if (entry.alpha < 1) text += "alpha = " + number_text(entry.alpha) + "\n";
    if (!entry.name.empty()) text += "name = " + string_text(entry.name) + "\n";
    text += i + 1 < palette.colors.size() ? "\n" : "";
  }
  return text;
}

}  // namespace tristim::detail
