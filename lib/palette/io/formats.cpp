#include "lib/palette/io/formats.h"

#include <algorithm>
#include <filesystem>

#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/palette/io/file.h"

namespace tristim {
namespace {

using std::string_view_literals::operator""sv;

template <const std::string_view& Magic>
bool begins_with(std::string_view bytes) {
  return without_utf8_mark(bytes).starts_with(Magic);
}
constexpr std::string_view kGpl = "GIMP Palette";
constexpr std::string_view kAse = "ASEF";
constexpr std::string_view kJasc = "JASC-PAL";
constexpr std::string_view kRiff = "RIFF";
constexpr std::string_view kPng = "\x89PNG\r\n\x1a\n";

constexpr PaletteFormat kFormats[] = {
    {"gpl", "gpl", "GIMP, Inkscape, Krita", kMostPaletteColors, 8, true, true, false,
     begins_with<kGpl>, detail::read_gpl, detail::write_gpl},
    {"hex", "hex txt", "a text of colours: ff8000, #ff8000 or CSS names", kMostPaletteColors, 8,
     false, true, false, nullptr, detail::read_hex, detail::write_hex},
    {"act", "act", "Photoshop colour table", 256, 8, false, false, false, nullptr, detail::read_act,
     detail::write_act},
    {"aco", "aco", "Photoshop swatches", 65535, 16, true, false, false, nullptr, detail::read_aco,
     detail::write_aco},
    {"ase", "ase", "Adobe swatch exchange", kMostPaletteColors, 16, true, false, false,
     begins_with<kAse>, detail::read_ase, detail::write_ase},
    {"jasc", "pal", "PaintShop Pro, as text", kMostPaletteColors, 8, false, true, false,
     begins_with<kJasc>, detail::read_jasc, detail::write_jasc},
    {"riff", "pal", "Microsoft RIFF", 65535, 8, false, false, false, begins_with<kRiff>,
     detail::read_riff, detail::write_riff},
    {"csv", "csv", "a table: hex, red, green, blue, alpha, code, name", kMostPaletteColors, 0, true,
     true, true, nullptr, detail::read_csv, detail::write_csv},
    {"json", "json", "a list of colours", kMostPaletteColors, 0, true, true, true, nullptr,
     detail::read_json, detail::write_json},
    {"toml", "toml", "a device's [[palette]]", kMostPaletteColors, 0, true, true, true, nullptr,
     detail::read_toml, detail::write_toml},
    {"png", "png", "a sheet of swatches, indexed", 256, 8, false, true, false, begins_with<kPng>,
     detail::read_sheet, detail::write_sheet},
    {"c", "h hpp c inc", "a C header", kMostPaletteColors, 8, true, true, true, nullptr,
     detail::read_c_header, detail::write_c_header},
};

const PaletteFormat* format_of_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  if (extension.empty()) return nullptr;
  extension.erase(0, 1);
  for (const PaletteFormat& format : kFormats) {
    for (const std::string_view name : split(format.extensions, ' ')) {
      if (same_name(name, extension)) return &format;
    }
  }
  return nullptr;
}

const PaletteFormat& format_named(std::string_view name) {
  if (const PaletteFormat* format = find_by_name(kFormats, name)) return *format;
  throw Error(ErrorKind::kMisuse, "--format", "unknown format '" + std::string(name) + "'",
              name_hint(kFormats, name));
}

std::string all_extensions() {
  std::string all;
  for (const PaletteFormat& format : kFormats) {
    if (format.name == "riff") continue;  // its extension is there already
    all += (all.empty() ? "" : " ") + std::string(format.extensions);
  }
  return all;
}

// No control characters but blanks, as in a text of words.
bool is_text(std::string_view bytes) {
  return std::ranges::none_of(bytes.substr(0, 256), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < ' ' && "\t\n\r"sv.find(c) == ""sv.npos) || byte == 127;
  });
}

// What a text is that neither begins with a mark nor has a known extension.
std::string_view text_format(std::string_view text) {
  if (text.find("[[palette]]") != std::string_view::npos) return "toml";
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool json = first != std::string_view::npos && (text[first] == '{' || text[first] == '[');
  return json ? "json" : "hex";
}

const PaletteFormat& format_of_bytes(std::string_view bytes, const std::string& file) {
  for (const PaletteFormat& format : kFormats) {
    if (format.begins != nullptr && format.begins(bytes)) return format;
  }
  if (const PaletteFormat* format = format_of_extension(file)) return *format;
  if (is_text(bytes)) return format_named(text_format(without_utf8_mark(bytes)));
  throw Error(ErrorKind::kContent, file, "is no palette of a known format",
              "give one of: " + list_names(kFormats));
}

}  // namespace

std::span<const PaletteFormat> palette_formats() noexcept { return kFormats; }

const PaletteFormat& palette_format_of(const std::string& path, std::string_view format) {
  if (!format.empty()) return format_named(format);
  if (const PaletteFormat* found = format_of_extension(path)) return *found;
  throw Error(ErrorKind::kMisuse, path == "-" ? "standard output" : path,
              "has no extension that tells a palette's format",
              path == "-" ? "give --format, one of: " + list_names(kFormats)
                          : "use one of: " + all_extensions());
}

Palette parse_palette(std::string_view bytes, const std::string& file, std::string_view format) {
  if (bytes.empty()) throw Error(ErrorKind::kContent, file, "is empty", "write or copy it again");
  const PaletteFormat& known = format.empty() ? format_of_bytes(bytes, file) : format_named(format);
  Palette palette = known.read(bytes, file);
  if (palette.colors.empty()) throw Error(ErrorKind::kContent, file, "holds no colours");
  if (palette.colors.size() > kMostPaletteColors) {
    throw Error(ErrorKind::kContent, file,
                "holds " + std::to_string(palette.colors.size()) + " colours",
                "a palette has at most " + std::to_string(kMostPaletteColors));
  }
  return palette;
}

Palette read_palette(const std::string& path, std::string_view format) {
  return parse_palette(read_text_file(path), path == "-" ? "standard input" : path, format);
}

std::string palette_bytes(const Palette& palette, const PaletteFormat& format,
                          const std::string& path) {
  if (palette.colors.empty()) throw Error(ErrorKind::kMisuse, path, "the palette has no colours");
  if (palette.colors.size() > static_cast<std::size_t>(format.most_colors)) {
    throw Error(ErrorKind::kMisuse, path,
                "a palette of " + std::to_string(palette.colors.size()) + " colours, but format " +
                    std::string(format.name) + " holds at most " +
                    std::to_string(format.most_colors),
                "use fewer colours or another format");
  }
  Palette named = palette;
  if (named.name.empty()) named.name = std::filesystem::path(path).stem().string();
  return format.write(named);
}

}  // namespace tristim
