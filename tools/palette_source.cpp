#include "tools/palette_source.h"

#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>

#include "tools/palette_picture.h"
#include "tools/spool.h"
#include "tristim/color/parse.h"
#include "tristim/color/transfer.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/device/display_file.h"
#include "tristim/image/io/indexed.h"
#include "tristim/palette/io/file.h"

namespace tristim::tools {
namespace {

// The first bytes of a file, enough to tell a picture; none where it cannot be read.
std::string head_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(256, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return head;
}

PaletteSource picture_source(const std::string& path) {
  if (path == "-") make_rereadable(path);
  if (const auto indexed = read_indexed_picture(path)) return palette_source(path, *indexed);
  constexpr std::size_t kMost = 256;
  PaletteSource source{path, {}, {}};
  for (const Histogram::Entry& entry : picture_histogram(path).entries()) {
    if (source.pixels.size() == kMost) {
      throw Error(ErrorKind::kContent, path, "is a picture of more than 256 colours",
                  "choose some of them: tristim palette build " + path);
    }
    const Color8 c = entry.color;
    source.palette.colors.push_back({{c.r / 255.0, c.g / 255.0, c.b / 255.0}});
    source.pixels.push_back(entry.count);
  }
  return source;
}

PaletteColor color_of(const std::string& word, const std::string& option) {
  const auto color = parse_color(word);
  if (!color) {
    throw Error(ErrorKind::kContent, option, "'" + word + "' is no colour", color_hint(word));
  }
  const bool named = std::isalpha(static_cast<unsigned char>(word[0])) != 0;
  return {*color, named ? word : ""};
}

}  // namespace

PaletteSource palette_source(const std::string& path, const IndexedPicture& picture) {
  PaletteSource source{path, {}, std::vector<std::uint64_t>(picture.palette.size())};
  for (const auto& [r, g, b, alpha] : picture.palette) {
    source.palette.colors.push_back({{r / 255.0, g / 255.0, b / 255.0}, {}, alpha / 255.0});
  }
  const auto view = picture.positions.view();
  for (int y = 0; y < view.height; ++y) {
    for (const std::uint8_t position : view.row(y)) ++source.pixels[position];
  }
  return source;
}

bool names_file(const std::vector<std::string>& words) {
  if (words.size() != 1 || parse_color(words.front())) return false;
  if (words.front() == "-") return true;
  std::error_code ignored;
  const std::filesystem::path path = words.front();
  const std::string extension = path.extension().string();
  return std::filesystem::exists(path, ignored) || path.has_parent_path() ||
         (extension.size() > 1 && std::isalpha(static_cast<unsigned char>(extension[1])) != 0);
}

bool is_picture(const std::string& path) {
  using std::string_view_literals::operator""sv;
  constexpr std::array kBegins{
      "\x89PNG"sv,          "GIF8"sv,       "BM"sv,    "II*\0"sv, "MM\0*"sv, "\xff\xd8"sv,
      "\x76\x2f\x31\x01"sv, "#?RADIANCE"sv, "#?RGBE"sv};
  const std::string head = head_of(path);
  const bool pnm = head.size() > 2 && head[0] == 'P' && (head[1] >= '1' && head[1] <= '7') &&
                   std::isspace(static_cast<unsigned char>(head[2])) != 0;
  return pnm || head.starts_with("PF") || head.starts_with("Pf") ||
         std::any_of(kBegins.begin(), kBegins.end(),
                     [&](std::string_view begin) { return head.starts_with(begin); });
}

PaletteSource load_palette(const std::vector<std::string>& words, const std::string& option) {
  const std::string& first = words.front();
  if (names_file(words)) {
    return is_picture(first) ? picture_source(first)
                             : PaletteSource{first, read_palette(first), {}};
  }
  const BuiltInDisplay* display =
      words.size() == 1 ? find_by_name(built_in_displays(), first) : nullptr;
  if (display != nullptr && display->text.find("[[palette]]") == std::string_view::npos) {
    throw Error(ErrorKind::kMisuse, first, "is a device without palette",
                "tristim device list tells which have one");
  }
  if (display != nullptr) return {first, parse_palette(display->text, first + ".toml"), {}};
  PaletteSource source{option, {}, {}};
  for (const std::string& word : words) source.palette.colors.push_back(color_of(word, option));
  return source;
}

std::vector<Rgb> palette_light(const Palette& palette) {
  std::vector<Rgb> light;
  for (const PaletteColor& entry : palette.colors) {
    const EncodedRgb& c = entry.color;
    light.push_back({srgb_decode(c.r), srgb_decode(c.g), srgb_decode(c.b)});
  }
  return light;
}

}  // namespace tristim::tools
